#include "haptics/levels/level_pairs.h"

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
    began_s_ = has_budget ? settings_.now_s() : 0.0;
    tree_.move_to(X_OT, within_m);
    waiting_.clear();
    opened_.clear();
    wait(tree_.root());
    while (waiting_.count() > 0 && !(has_budget && is_time_up())) {
        open(take_waiting(), answer);
    }
    conclude(answer);
    learn(answer);
    answer.n_looked_at = tree_.n_measured();
    answer.n_kept = tree_.n_kept();
    answer.is_late = has_budget && spent_us() > settings_.budget_us;
    return answer;
}

void LevelPairs::wait(std::int32_t pair) noexcept {
    if (tree_.is_beyond(pair, tree_.place().within_m)) {
        return;
    }
    waiting_.add(
        {tree_.at(pair).told_m, tree_.at(pair).error_m, pair});  // as much room as there are pairs
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

double LevelPairs::compute_off_m(const NodePair& nodes) const noexcept {
    return tree_.object_node(nodes).deviation_m + tree_.tool_node(nodes).deviation_m;
}

bool LevelPairs::is_fine_enough(const PairTree::Pair& one) const noexcept {
    constexpr double kOneWay = 0.5;  // 60 degrees
    if (tree_.is_leaf(one.nodes)) {
        return true;
    }
    if (!(static_cast<double>(one.error_m) <= settings_.tolerance_m)) {
        return false;
    }
    const double looks =
        std::max(tree_.object_node(one.nodes).cone_cosine, tree_.tool_node(one.nodes).cone_cosine);
    const double most_off_m = std::min(settings_.tolerance_m, tree_.place().within_m);
    return settings_.is_as_source || (compute_off_m(one.nodes) <= most_off_m && looks >= kOneWay);
}

double LevelPairs::spent_us() const noexcept {
    return 1.0e6 * (settings_.now_s() - began_s_);
}

// What waits has still to be told, and what was opened to learn.
bool LevelPairs::is_time_up() const noexcept {
    constexpr double kLearn_us = 0.05;
    return spent_us() + each_us_ * static_cast<double>(waiting_.count()) +
               kLearn_us * static_cast<double>(opened_.count()) >
           settings_.budget_us;
}

void LevelPairs::open(std::int32_t pair, LevelAnswer& answer) noexcept {
    if (is_fine_enough(tree_.at(pair))) {
        tell(pair, answer);
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

void LevelPairs::conclude(LevelAnswer& answer) noexcept {
    if (waiting_.count() == 0) {
        return;
    }
    const auto all = waiting_.all();
    std::ranges::sort(all, [this](const Waiting& a, const Waiting& b) {
        const float of_a = tree_.at(a.pair).told_m;
        const float of_b = tree_.at(b.pair).told_m;
        return of_a != of_b ? of_a > of_b : a.pair < b.pair;
    });
    constexpr int kMostWays = 16;  // that end where nothing is
    const double before_us = spent_us();
    double spent = before_us;
    int n = 0;
    for (const Waiting& one : all) {
        if (n > 0 && spent > settings_.budget_us) {
            leave(one.pair, answer);
            continue;
        }
        // One way down, at least.
        int steps = n == 0 ? 2 * (object().n_levels() + tool().n_levels()) : 0;
        WayDown ended = WayDown::is_dead_end;
        for (int way = 0; way < kMostWays && ended == WayDown::is_dead_end &&
                          !tree_.is_beyond(one.pair, tree_.place().within_m);
             ++way) {
            ended = go_down(one.pair, steps, answer);
        }
        if (ended == WayDown::is_dead_end) {
            leave(one.pair, answer);  // unless nothing is near in all of it
        }
        spent = spent_us();
        ++n;
    }
    constexpr double kFollow = 0.2;
    each_us_ += kFollow * ((spent - before_us) / n - each_us_);
}

// To what was told of last, then, where that is still too coarse to be told, to where spheres are nearest.
LevelPairs::WayDown LevelPairs::go_down(std::int32_t top, int& steps,
                                        LevelAnswer& answer) noexcept {
    HullPair found;
    std::int32_t pair = top;
    for (;;) {
        if (tree_.at(pair).first_child == PairTree::kNone) {
            if (steps-- <= 0 && spent_us() > settings_.budget_us) {
                leave(top, answer);
                return WayDown::has_no_time;
            }
            if (is_usable(tree_.at(pair))) {
                return tell_as_it_is(top, pair, answer);
            }
            if (tree_.measure(pair, tree_.place().within_m, found)) {
                return WayDown::is_dead_end;
            }
            if (!tree_.divide(pair)) {
                answer.is_cut = true;
                return WayDown::has_no_time;
            }
        }
        opened_.add(pair);
        const std::int32_t child = find_deepest_child(pair);
        if (child == PairTree::kNone) {
            tree_.learn_from_children(pair, false);
            return WayDown::is_dead_end;
        }
        pair = child;
    }
}

// What else is below the top is left.
LevelPairs::WayDown LevelPairs::tell_as_it_is(std::int32_t top, std::int32_t pair,
                                              LevelAnswer& answer) noexcept {
    const int n_before = answer.n_patches;
    tell(pair, answer);
    if (answer.n_patches == n_before) {
        return WayDown::is_dead_end;
    }
    answer.n_coarser += is_fine_enough(tree_.at(pair)) ? 0 : 1;
    if (pair != top) {
        leave(top, answer);
    }
    return WayDown::is_told;
}

bool LevelPairs::is_usable(const PairTree::Pair& one) const noexcept {
    return tree_.is_leaf(one.nodes) ||
           (one.error_m < std::numeric_limits<float>::infinity() &&
            compute_off_m(one.nodes) <= std::max(settings_.tolerance_m, tree_.place().within_m));
}

std::int32_t LevelPairs::find_deepest_child(std::int32_t pair) const noexcept {
    std::int32_t best = PairTree::kNone;
    float deepest_m = PairTree::kNothing;
    double nearest_m = kNever;
    for (std::int32_t child = tree_.at(pair).first_child; child != PairTree::kNone;
         child = tree_.at(child).next) {
        if (tree_.is_beyond(child, tree_.place().within_m)) {
            continue;
        }
        const float told_m = tree_.at(child).told_m;
        const double spheres_m = tree_.compute_spheres_m(tree_.at(child).nodes);
        if (told_m > deepest_m || (told_m == deepest_m && spheres_m < nearest_m)) {
            best = child;
            deepest_m = told_m;
            nearest_m = spheres_m;
        }
    }
    return best;
}

void LevelPairs::leave(std::int32_t pair, LevelAnswer& answer) noexcept {
    const double spheres_m = tree_.compute_spheres_m(tree_.at(pair).nodes);
    if (tree_.is_beyond(pair, tree_.place().within_m) || spheres_m > tree_.place().within_m) {
        return;
    }
    ++answer.n_left;
    answer.left_m = std::max(answer.left_m, -spheres_m);
}

void LevelPairs::tell(std::int32_t pair, LevelAnswer& answer) noexcept {
    const LevelPlace& place = tree_.place();
    const NodePair nodes = tree_.at(pair).nodes;
    tree_.at(pair).told_m = PairTree::kNothing;
    HullPair found;
    if (tree_.measure(pair, place.within_m, found)) {
        return;
    }
    const PairContacts contacts({.object = tree_.object_node(nodes),
                                 .tool = tree_.tool_node(nodes),
                                 .object_hull = tree_.object().hull(nodes.object),
                                 .tool_hull = tree_.tool().hull(nodes.tool),
                                 .turn = place.turn,
                                 .shift = place.shift,
                                 .within_m = place.within_m,
                                 .spread_m = settings_.spread_m,
                                 .corners = tree_.at(pair).corners},
                                found);
    if (contacts.points().empty()) {
        return;
    }
    const double off_m = compute_off_m(nodes);
    answer.nearest_m = std::min(answer.nearest_m, found.gap_m);
    answer.error_m = std::max(answer.error_m, off_m);
    ++answer.n_patches;
    for (const PairPoint& point : contacts.points()) {
        tree_.at(pair).told_m = std::max(tree_.at(pair).told_m, static_cast<float>(point.depth_m));
        answer.is_cut =
            !contacts_.add({point.place_O, contacts.normal_O(), point.depth_m, off_m}) ||
            answer.is_cut;
    }
}

// Children came after their parents, so from the last to the first. What is measured for that has its time, too.
void LevelPairs::learn(const LevelAnswer& answer) noexcept {
    const bool has_budget = settings_.budget_us > 0.0;
    bool may_measure = answer.n_left + answer.n_coarser == 0;
    for (std::size_t i = opened_.count(); i-- > 0;) {
        may_measure = may_measure && !(has_budget && spent_us() > settings_.budget_us);
        tree_.learn_from_children(opened_[i], may_measure);
    }
}

}  // namespace fulcrum
