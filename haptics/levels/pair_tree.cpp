#include "haptics/levels/pair_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {

namespace {

constexpr double kFarAway = std::numeric_limits<double>::infinity();
// Motion is summed anew where rounding of the sum could count.
constexpr double kMostMotion_m = 1.0e4;

}  // namespace

void PairTree::clear() noexcept {
    free_ = kNone;
    n_used_ = 0;
    n_kept_ = 0;
    moved_m_ = 0.0;
    root_ = make({0, 0});
}

// How far any of the tool has gone at most: |dx| + 2 sin(turn / 2) reach.
void PairTree::move_to(const Pose& X_OT, double within_m) noexcept {
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
    n_measured_ = 0;
}

std::int32_t PairTree::make(const NodePair& nodes) noexcept {
    std::int32_t made = free_;
    if (made != kNone) {
        free_ = at(made).next;
    } else if (n_used_ < pairs_.size()) {
        made = static_cast<std::int32_t>(n_used_++);
    } else {
        return kNone;
    }
    at(made) = Pair{.nodes = nodes, .bound_m = -kFarAway, .error_m = compute_error_m(nodes)};
    ++n_kept_;
    return made;
}

void PairTree::free_children(std::int32_t pair) noexcept {
    std::int32_t waiting = at(pair).first_child;
    at(pair).first_child = kNone;
    while (waiting != kNone) {
        const std::int32_t child = waiting;
        waiting = at(child).next;
        // Its own before those that wait.
        for (std::int32_t below = at(child).first_child; below != kNone;) {
            const std::int32_t next = at(below).next;
            at(below).next = waiting;
            waiting = below;
            below = next;
        }
        at(child).next = free_;
        free_ = child;
        --n_kept_;
    }
}

// s* = max(phi) / max(D)
float PairTree::compute_error_m(const NodePair& nodes) const noexcept {
    const LevelNode& a = object_node(nodes);
    const LevelNode& b = tool_node(nodes);
    const double detail_m3 = std::max(a.detail_m3, b.detail_m3);
    const double support_m2 = std::max(a.support_m2, b.support_m2);
    if (!(detail_m3 > 0.0)) {
        return 0.0F;
    }
    return support_m2 > 0.0 ? static_cast<float>(detail_m3 / support_m2)
                            : std::numeric_limits<float>::infinity();
}

HullPair PairTree::find_pair(Pair& one, double enough_m) const noexcept {
    const Vector3 axis(static_cast<double>(one.axis[0]), static_cast<double>(one.axis[1]),
                       static_cast<double>(one.axis[2]));
    return find_hull_pair(object_->hull(one.nodes.object), tool_->hull(one.nodes.tool), place_.turn,
                          place_.shift, axis, enough_m, one.corners);
}

double PairTree::compute_spheres_m(const NodePair& nodes) const noexcept {
    const LevelNode& a = object_node(nodes);
    const LevelNode& b = tool_node(nodes);
    const Vector3 between = place_.turn * b.centre_B + place_.shift - a.centre_B;
    return between.norm() - a.radius_m - b.radius_m - a.outside_m - b.outside_m;
}

bool PairTree::measure(std::int32_t pair, double enough_m, HullPair& found) noexcept {
    Pair& one = at(pair);
    const LevelNode& a = object_node(one.nodes);
    const LevelNode& b = tool_node(one.nodes);
    const double outside_m = a.outside_m + b.outside_m;
    ++n_measured_;
    if (const double spheres_m = compute_spheres_m(one.nodes); spheres_m > enough_m) {
        one.bound_m = moved_m_ + spheres_m;
        return true;
    }
    found = find_pair(one, enough_m + outside_m);
    one.axis = {static_cast<float>(found.normal.x()), static_cast<float>(found.normal.y()),
                static_cast<float>(found.normal.z())};
    one.bound_m = moved_m_ + found.least_m - outside_m;
    return found.is_far;
}

// The one that only bounds gives way, the larger of two such; else that of more detail.
bool PairTree::divide(std::int32_t pair) noexcept {
    const Pair one = at(pair);
    const LevelNode& a = object_node(one.nodes);
    const LevelNode& b = tool_node(one.nodes);
    bool divides_object = a.detail_m3 > b.detail_m3;
    if (a.is_bound_only == b.is_bound_only && a.detail_m3 == b.detail_m3) {
        divides_object = a.radius_m > b.radius_m;
    }
    divides_object = b.n_children == 0 || (divides_object && a.n_children > 0);
    const LevelNode& parent = divides_object ? a : b;
    for (std::int32_t i = 0; i < parent.n_children; ++i) {
        NodePair nodes = one.nodes;
        (divides_object ? nodes.object : nodes.tool) = parent.first_child + i;
        const std::int32_t made = make(nodes);
        if (made == kNone) {
            free_children(pair);
            return false;
        }
        at(made).axis = one.axis;
        at(made).next = at(pair).first_child;
        at(pair).first_child = made;
    }
    return true;
}

void PairTree::learn_from_children(std::int32_t pair, bool may_measure) noexcept {
    // What was opened more than once may have let go of them: it knows by itself how far it is.
    if (at(pair).first_child == kNone) {
        return;
    }
    double least_m = kFarAway;
    float told_m = kNothing;
    bool are_ends = true;
    for (std::int32_t child = at(pair).first_child; child != kNone; child = at(child).next) {
        least_m = std::min(least_m, at(child).bound_m);
        told_m = is_beyond(child, place_.within_m) ? told_m : std::max(told_m, at(child).told_m);
        are_ends = are_ends && at(child).first_child == kNone;
    }
    at(pair).told_m = told_m;
    const double before_m = at(pair).bound_m;
    HullPair found;
    if (are_ends && least_m - moved_m_ > place_.within_m) {
        const bool has_room = 4 * static_cast<std::size_t>(n_kept_) < 3 * pairs_.size();
        if (may_measure ? measure(pair, place_.within_m, found) : !has_room) {
            free_children(pair);
        }
    }
    at(pair).bound_m = std::max({at(pair).bound_m, before_m, least_m});
}

}  // namespace fulcrum
