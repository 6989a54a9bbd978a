#include "haptics/levels/level_pairs.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <limits>

namespace fulcrum {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

LevelAnswer LevelPairs::find(const Pose& X_OT, double within_m) noexcept {
    LevelAnswer answer{.nearest_m = kNever};
    contacts_.clear();
    if (!is_finite(X_OT)) {
        return answer;
    }
    const bool has_budget = settings_.budget_us > 0.0;
    const double began_s = has_budget ? monotonic_now_s() : 0.0;
    tree_.move_to(X_OT, within_m);
    waiting_.clear();
    opened_.clear();
    wait(tree_.root());
    while (waiting_.count() > 0) {
        const std::int32_t pair = take_waiting();
        open(pair, has_budget && is_time_up(began_s), answer);
    }
    // Children came after their parents, so from the last to the first.
    for (std::size_t i = opened_.count(); i-- > 0;) {
        tree_.learn_from_children(opened_[i]);
    }
    answer.n_looked_at = tree_.n_measured();
    answer.n_kept = tree_.n_kept();
    answer.is_late = has_budget && 1.0e6 * (monotonic_now_s() - began_s) > settings_.budget_us;
    return answer;
}

void LevelPairs::wait(std::int32_t pair) noexcept {
    if (tree_.is_beyond(pair, tree_.place().within_m)) {
        return;
    }
    waiting_.add({tree_.at(pair).error_m, pair});  // as much room as there are pairs
    if (settings_.budget_us > 0.0) {
        const auto all = waiting_.all();
        std::push_heap(all.begin(), all.end());
    }
}

std::int32_t LevelPairs::take_waiting() noexcept {
    if (settings_.budget_us > 0.0) {
        const auto all = waiting_.all();
        std::pop_heap(all.begin(), all.end());
    }
    return waiting_.take_last().pair;
}

bool LevelPairs::is_fine_enough(const PairTree::Pair& one) const noexcept {
    constexpr double kOneWay = 0.8660254037844387;  // 30 degrees
    const LevelNode& a = tree_.object_node(one.nodes);
    const LevelNode& b = tree_.tool_node(one.nodes);
    return tree_.is_leaf(one.nodes) || (static_cast<double>(one.error_m) <= settings_.tolerance_m &&
                                        a.deviation_m + b.deviation_m <= settings_.tolerance_m &&
                                        std::min(a.radius_m, b.radius_m) <= settings_.tolerance_m &&
                                        std::max(a.cone_cosine, b.cone_cosine) >= kOneWay);
}

// What waits has still to be looked at, some 2 us each.
bool LevelPairs::is_time_up(double began_s) const noexcept {
    constexpr double kPair_us = 2.0;
    const double spent_us = 1.0e6 * (monotonic_now_s() - began_s);
    const int n_measured = tree_.n_measured();
    const double each_us = n_measured > 16 ? std::min(kPair_us, spent_us / n_measured) : kPair_us;
    return spent_us + each_us * static_cast<double>(waiting_.count() + 1) > settings_.budget_us;
}

void LevelPairs::open(std::int32_t pair, bool as_it_is, LevelAnswer& answer) noexcept {
    if (as_it_is || is_fine_enough(tree_.at(pair))) {
        look_below(pair, answer);
        return;
    }
    HullPair found;
    if (tree_.at(pair).first_child == PairTree::kNone) {
        if (tree_.measure(pair, tree_.place().within_m, found)) {
            return;
        }
        if (!tree_.divide(pair)) {
            answer.is_cut = true;
            return;
        }
    }
    opened_.add(pair);
    for (std::int32_t child = tree_.at(pair).first_child; child != PairTree::kNone;
         child = tree_.at(child).next) {
        wait(child);
    }
}

template <class LookAt>
void LevelPairs::walk_below(std::int32_t top, const double& enough_m, const LookAt& look_at,
                            LevelAnswer& answer) noexcept {
    below_.clear();
    below_.add(top);
    HullPair found;
    while (below_.count() > 0) {
        const std::int32_t pair = below_.take_last();
        if (tree_.is_beyond(pair, enough_m)) {
            continue;
        }
        if (tree_.at(pair).first_child == PairTree::kNone) {
            if (tree_.measure(pair, enough_m, found)) {
                continue;
            }
            if (tree_.is_leaf(tree_.at(pair).nodes)) {
                look_at(tree_.at(pair).nodes, found);
                continue;
            }
            if (!tree_.divide(pair)) {
                answer.is_cut = true;
                continue;
            }
        }
        opened_.add(pair);
        const std::size_t first = below_.count();
        for (std::int32_t child = tree_.at(pair).first_child; child != PairTree::kNone;
             child = tree_.at(child).next) {
            if (!tree_.is_beyond(child, enough_m)) {
                below_.add(child);
            }
        }
        // The nearest first, as far as that is known.
        std::ranges::sort(below_.all().subspan(first), std::greater<>(),
                          [this](std::int32_t child) { return tree_.at(child).bound_m; });
    }
}

PairContacts LevelPairs::touch(const NodePair& leaves, const HullPair& found) const noexcept {
    const LevelPlace& place = tree_.place();
    return PairContacts({.object = tree_.object_node(leaves),
                         .tool = tree_.tool_node(leaves),
                         .object_hull = tree_.object().hull(leaves.object),
                         .tool_hull = tree_.tool().hull(leaves.tool),
                         .turn = place.turn,
                         .shift = place.shift,
                         .within_m = place.within_m,
                         .spread_m = settings_.spread_m},
                        found);
}

void LevelPairs::look_below(std::int32_t top, LevelAnswer& answer) noexcept {
    const LevelPlace& place = tree_.place();
    const float error_m = tree_.at(top).error_m;
    const bool is_leaf = tree_.is_leaf(tree_.at(top).nodes);
    answer.error_m = std::max(answer.error_m, static_cast<double>(error_m));
    Nearest nearest{.gap_m = kNever};
    double enough_m = place.within_m;
    const auto look_at = [&](const NodePair& leaves, const HullPair& found) noexcept {
        const PairContacts contacts = touch(leaves, found);
        for (const PairPoint& point : contacts.points()) {
            if (-point.depth_m < nearest.gap_m) {
                nearest = {leaves, found, -point.depth_m};
                enough_m = std::min(place.within_m, nearest.gap_m - slack_m_);
            }
        }
    };
    const auto add = [&](const NodePair& leaves, const HullPair& found) noexcept {
        add_contacts(leaves, found, error_m, answer);
    };
    if (is_leaf) {
        walk_below(top, enough_m, add, answer);
        return;
    }
    const NodePair last = tree_.at(top).nearest;
    if (last.object >= 0) {
        if (const HullPair found = tree_.measure_leaves(last, top); !found.is_far) {
            look_at(last, found);
        }
    }
    walk_below(top, enough_m, look_at, answer);
    tree_.at(top).nearest = nearest.nodes;
    if (nearest.gap_m <= 0.0) {
        enough_m = place.within_m;
        walk_below(top, enough_m, add, answer);
    } else if (nearest.nodes.object >= 0) {
        add(nearest.nodes, nearest.found);
    }
}

void LevelPairs::add_contacts(const NodePair& leaves, const HullPair& found, float error_m,
                              LevelAnswer& answer) noexcept {
    answer.nearest_m = std::min(answer.nearest_m, found.gap_m);
    const PairContacts contacts = touch(leaves, found);
    for (const PairPoint& point : contacts.points()) {
        answer.is_cut = !contacts_.add({point.place_O, contacts.normal_O(), point.depth_m,
                                        static_cast<double>(error_m)}) ||
                        answer.is_cut;
    }
}

}  // namespace fulcrum
