#include "haptics/levels/level_pairs.h"

#include "haptics/base/clock.h"
#include "haptics/levels/pair_contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Motion is summed anew where rounding of the sum could count.
constexpr double kMostMotion_m = 1.0e4;

}  // namespace

LevelAnswer LevelPairs::find(const Pose& X_OT, double within_m) noexcept {
    LevelAnswer answer{.nearest_m = kNever};
    contacts_.clear();
    if (!is_finite(X_OT)) {
        return answer;
    }
    const bool has_budget = settings_.budget_us > 0.0;
    const double began_s = has_budget ? monotonic_now_s() : 0.0;
    follow_motion(X_OT, within_m);
    waiting_.clear();
    opened_.clear();
    wait(root_);
    while (waiting_.count() > 0) {
        const std::int32_t at = take_waiting();
        if (has_budget && !is_bound_only(pair(at)) && is_time_up(began_s, answer)) {
            close(at, answer);
        } else {
            open(at, answer);
        }
    }
    rise(answer);
    answer.n_kept = n_kept_;
    answer.is_late = has_budget && 1.0e6 * (monotonic_now_s() - began_s) > settings_.budget_us;
    return answer;
}

// How far any of the tool has gone at most: |dx| + 2 sin(turn / 2) reach.
void LevelPairs::follow_motion(const Pose& X_OT, double within_m) noexcept {
    const double d_m = std::min(within_m, object_->settings().within_m);
    const Quaternion turn = X_OT.orientation.normalized();
    const double half_sine = (last_X_OT_.orientation.conjugate() * turn).vec().norm();
    moved_m_ += (X_OT.position - last_X_OT_.position).norm() +
                2.0 * std::min(half_sine, 1.0) * tool_->reach_m();
    if (d_m != last_within_m_ || !(moved_m_ < kMostMotion_m)) {
        clear();
    }
    last_within_m_ = d_m;
    last_X_OT_ = {X_OT.position, turn};
    place_ = {turn.toRotationMatrix(), X_OT.position, d_m};
}

std::int32_t LevelPairs::make_pair(std::int32_t object, std::int32_t tool) noexcept {
    if (free_ == kNone) {
        return kNone;
    }
    const std::int32_t at = free_;
    free_ = pair(at).next;
    pair(at) = Pair{.object = object, .tool = tool, .error_m = compute_error_m(object, tool)};
    ++n_kept_;
    return at;
}

void LevelPairs::free_children(std::int32_t at) noexcept {
    std::int32_t waiting = pair(at).first_child;
    pair(at).first_child = kNone;
    while (waiting != kNone) {
        const std::int32_t child = waiting;
        waiting = pair(child).next;
        // Its own before those that wait.
        for (std::int32_t below = pair(child).first_child; below != kNone;) {
            const std::int32_t next = pair(below).next;
            pair(below).next = waiting;
            waiting = below;
            below = next;
        }
        pair(child).next = free_;
        free_ = child;
        --n_kept_;
    }
}

// s* = max(phi) / max(D)
float LevelPairs::compute_error_m(std::int32_t object, std::int32_t tool) const noexcept {
    const LevelNode& a = object_->node(object);
    const LevelNode& b = tool_->node(tool);
    const double detail_m3 = std::max(a.detail_m3, b.detail_m3);
    const double support_m2 = std::max(a.support_m2, b.support_m2);
    if (!(detail_m3 > 0.0)) {
        return 0.0F;
    }
    return support_m2 > 0.0 ? static_cast<float>(detail_m3 / support_m2)
                            : std::numeric_limits<float>::infinity();
}

void LevelPairs::wait(std::int32_t at) noexcept {
    if (pair(at).until_m > moved_m_) {
        return;
    }
    waiting_.add({pair(at).error_m, at});  // as much room as there are pairs
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

bool LevelPairs::is_bound_only(const Pair& one) const noexcept {
    return object_->node(one.object).is_bound_only || tool_->node(one.tool).is_bound_only;
}

bool LevelPairs::is_fine_enough(const Pair& one) const noexcept {
    return object_->node(one.object).n_children + tool_->node(one.tool).n_children == 0 ||
           (!is_bound_only(one) && static_cast<double>(one.error_m) <= settings_.tolerance_m);
}

// What waits has still to be looked at, some 2 us each.
bool LevelPairs::is_time_up(double began_s, const LevelAnswer& answer) const noexcept {
    constexpr double kPair_us = 2.0;
    const double spent_us = 1.0e6 * (monotonic_now_s() - began_s);
    const double each_us =
        answer.n_looked_at > 16 ? std::min(kPair_us, spent_us / answer.n_looked_at) : kPair_us;
    return spent_us + each_us * static_cast<double>(waiting_.count() + 1) > settings_.budget_us;
}

void LevelPairs::open(std::int32_t at, LevelAnswer& answer) noexcept {
    if (pair(at).first_child != kNone) {
        wait_for_children(at);
        return;
    }
    HullPair found;
    if (is_left(at, found, answer)) {
        return;
    }
    if (!is_fine_enough(pair(at))) {
        if (divide(at)) {
            wait_for_children(at);
            return;
        }
        answer.is_cut = true;
    }
    add_contacts(pair(at), found, answer);
}

// As it is: there is no time for better.
void LevelPairs::close(std::int32_t at, LevelAnswer& answer) noexcept {
    HullPair found;
    const std::int32_t first_child = pair(at).first_child;
    if (!is_left(at, found, answer)) {
        add_contacts(pair(at), found, answer);
    } else if (first_child != kNone) {
        free_children(at);
    }
}

void LevelPairs::wait_for_children(std::int32_t at) noexcept {
    opened_.add(at);
    for (std::int32_t child = pair(at).first_child; child != kNone; child = pair(child).next) {
        wait(child);
    }
}

// The one that only bounds gives way, the larger of two such; else that of more detail.
bool LevelPairs::divide(std::int32_t at) noexcept {
    const Pair one = pair(at);
    const LevelNode& a = object_->node(one.object);
    const LevelNode& b = tool_->node(one.tool);
    bool divides_object = a.detail_m3 > b.detail_m3;
    if (a.is_bound_only == b.is_bound_only && a.detail_m3 == b.detail_m3) {
        divides_object = a.radius_m > b.radius_m;
    }
    divides_object = b.n_children == 0 || (divides_object && a.n_children > 0);
    const LevelNode& parent = divides_object ? a : b;
    for (std::int32_t i = 0; i < parent.n_children; ++i) {
        const std::int32_t child = parent.first_child + i;
        const std::int32_t made =
            divides_object ? make_pair(child, one.tool) : make_pair(one.object, child);
        if (made == kNone) {
            free_children(at);
            return false;
        }
        pair(made).axis = one.axis;
        pair(made).next = pair(at).first_child;
        pair(at).first_child = made;
    }
    return true;
}

bool LevelPairs::is_left(std::int32_t at, HullPair& found, LevelAnswer& answer) noexcept {
    Pair& one = pair(at);
    const LevelNode& a = object_->node(one.object);
    const LevelNode& b = tool_->node(one.tool);
    const double enough_m = place_.within_m + a.outside_m + b.outside_m;
    ++answer.n_looked_at;
    const auto leave = [&](double gap_m) noexcept {
        one.until_m = moved_m_ + (gap_m - enough_m);
        return true;
    };
    const Vector3 between = place_.turn * b.centre_B + place_.shift - a.centre_B;
    const double spheres_m = between.norm() - a.radius_m - b.radius_m;
    if (spheres_m > enough_m) {
        return leave(spheres_m);
    }
    const HullView hull_a = object_->hull(one.object);
    const HullView hull_b = tool_->hull(one.tool);
    const Vector3 axis(static_cast<double>(one.axis[0]), static_cast<double>(one.axis[1]),
                       static_cast<double>(one.axis[2]));
    found = find_hull_pair(hull_a, hull_b, place_.turn, place_.shift, axis, enough_m);
    one.axis = {static_cast<float>(found.normal.x()), static_cast<float>(found.normal.y()),
                static_cast<float>(found.normal.z())};
    one.until_m = 0.0;
    return found.is_far && leave(found.least_m);
}

// Children came after their parents, so from the last to the first.
void LevelPairs::rise(LevelAnswer& answer) noexcept {
    for (std::size_t i = opened_.count(); i-- > 0;) {
        const std::int32_t at = opened_[i];
        double soonest_m = kNever;
        bool are_ends = true;
        for (std::int32_t child = pair(at).first_child; child != kNone; child = pair(child).next) {
            soonest_m = std::min(soonest_m, pair(child).until_m);
            are_ends = are_ends && pair(child).first_child == kNone;
        }
        if (soonest_m > moved_m_ && are_ends) {
            HullPair found;
            const double before_m = pair(at).until_m;
            if (is_left(at, found, answer)) {
                free_children(at);
                continue;
            }
            pair(at).until_m = before_m;
        }
        pair(at).until_m = soonest_m;
    }
}

void LevelPairs::add_contacts(const Pair& one, const HullPair& found,
                              LevelAnswer& answer) noexcept {
    const LevelNode& a = object_->node(one.object);
    const LevelNode& b = tool_->node(one.tool);
    if (a.is_bound_only || b.is_bound_only) {
        return;
    }
    answer.error_m = std::max(answer.error_m, static_cast<double>(one.error_m));
    answer.deviation_m = std::max(answer.deviation_m, a.deviation_m + b.deviation_m);
    answer.nearest_m = std::min(answer.nearest_m, found.gap_m);
    const double rise_m = a.rise_m + b.rise_m;
    if (found.gap_m - rise_m > place_.within_m) {
        return;
    }
    PairContacts contacts({.object = a,
                           .tool = b,
                           .object_hull = object_->hull(one.object),
                           .tool_hull = tool_->hull(one.tool),
                           .turn = place_.turn,
                           .shift = place_.shift,
                           .within_m = place_.within_m,
                           .rise_m = rise_m,
                           .spread_m = settings_.spread_m},
                          found);
    for (const PairPoint& point : contacts.points()) {
        answer.is_cut = !contacts_.add({point.place_O, contacts.normal_O(), point.depth_m,
                                        static_cast<double>(one.error_m)}) ||
                        answer.is_cut;
    }
}

}  // namespace fulcrum
