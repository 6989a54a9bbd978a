#include "haptics/tool/god_object/god_pairs.h"

#include "haptics/tool/god_object/god_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kContactGaps = 4.0;  // what is within so many gaps at rest is a contact, at least
constexpr double kLookWidens =
    4.0;  // how far contacts are looked for, when the tool was stopped by another
constexpr double kStuckShare = 0.1;  // of its way, that is
constexpr double kStuckGaps = 32.0;  // and it is shorter than so many gaps at rest
constexpr int kManyContacts = 64;    // it does not turn between so many
constexpr double kLookWidest = 0.1;  // of the tool's reach
constexpr double kFreeGaps = 1.0;    // what is within is not free, beyond twice that it is
constexpr double kTouchShare =
    0.25;  // of the gap there is: the sweep stops between that and twice it
constexpr double kLeastTouch = 1.0 / 64.0;  // of the gap at rest: nearer than that nothing goes
constexpr double kObjectWay = 0.1;          // of the tool's reach, that an object goes in a round
constexpr double kObjectTurn_rad = 0.02;    // likewise
constexpr double kMostTurn_rad = 3.0;       // of the tool, in a round
constexpr int kMovingTries = 4;

// As near to length 1 as numbers can be: what is swept and what is looked at must be one place.
Pose clean(const Pose& pose) noexcept {
    return {pose.position, pose.orientation.normalized()};
}

Pose seen_from(const Pose& object_W, const Pose& tool_W) noexcept {
    return object_W.inverse() * tool_W;
}

}  // namespace

void GodPairs::place(const Pose& tool_W) noexcept {
    tool_W_ = tool_W;
    is_begun_ = false;
    for (GodPair& pair : pairs_) {
        pair.forget();
    }
    found_ = {};
}

bool GodPairs::is_free(const Pose& tool_W, std::span<const MovingFrame> objects) const noexcept {
    if (!is_apart(tool_W, objects)) {
        return false;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (pairs_[i].is_enclosed(seen_from(clean(objects[i].pose_W), tool_W))) {
            return false;
        }
    }
    return true;
}

bool GodPairs::is_apart(const Pose& tool_W, std::span<const MovingFrame> objects) const noexcept {
    if (objects.size() != pairs_.size() || !is_finite(tool_W) ||
        !std::ranges::all_of(objects, [](const MovingFrame& one) { return is_place(one); })) {
        return false;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (!pairs_[i].is_apart(seen_from(clean(objects[i].pose_W), tool_W), kFreeGaps * gap_m_)) {
            return false;
        }
    }
    return true;
}

bool GodPairs::begin(std::span<const MovingFrame> objects) noexcept {
    if (!is_apart(tool_W_, objects)) {
        return false;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        objects_W_[i] = clean(objects[i].pose_W);
    }
    is_begun_ = true;
    within_m_ = kContactGaps * gap_m_;
    collect();
    return true;
}

void GodPairs::collect() noexcept {
    collect_within();
    // More than there is room for, since they were looked for far away: then only those that hold it.
    if (const double least_m = kContactGaps * gap_m_; found_.too_many && within_m_ > least_m) {
        within_m_ = least_m;
        collect_within();
    }
}

void GodPairs::collect_within() noexcept {
    found_ = {0, std::numeric_limits<double>::infinity(), false};
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        pairs_[i].collect(seen_OT(i), within_m_);
        found_.contacts += static_cast<int>(pairs_[i].contacts().size());
        found_.least_gap_m = std::min(found_.least_gap_m, pairs_[i].least_gap_m());
        found_.too_many = found_.too_many || pairs_[i].is_full();
    }
}

Pose GodPairs::find_object_W(std::size_t i, double share) const noexcept {
    if (share == 1.0 || !moves(i)) {
        return goals_W_[i];
    }
    return go_along(objects_W_[i], share * find_way(objects_W_[i], goals_W_[i]));
}

void GodPairs::set_goals(std::span<const MovingFrame> objects) noexcept {
    for (std::size_t i = 0; i < objects.size(); ++i) {
        goals_W_[i] = clean(objects[i].pose_W);
        if (found_.contacts == 0 || !moves(i)) {
            continue;
        }
        const Vector6 way = find_way(objects_W_[i], goals_W_[i]);
        const double parts = std::max(way.head<3>().norm() / (kObjectWay * reach_m_),
                                      way.tail<3>().norm() / kObjectTurn_rad);
        if (parts > 1.0) {
            goals_W_[i] = go_along(objects_W_[i], way / parts);
        }
    }
}

void GodPairs::wait() noexcept {
    std::ranges::copy(objects_W_, goals_W_.begin());
}

bool GodPairs::have_arrived() const noexcept {
    return std::ranges::equal(objects_W_, goals_W_, is_same);
}

bool GodPairs::are_at(std::span<const MovingFrame> objects) const noexcept {
    return std::ranges::equal(objects_W_, objects, [](const Pose& at_W, const MovingFrame& said) {
        return is_same(at_W, clean(said.pose_W));
    });
}

double GodPairs::find_free_share(const Vector6& way) noexcept {
    double touch_m = kTouchShare * std::min(gap_m_, found_.least_gap_m);
    const bool may_come_near = touch_m >= kLeastTouch * gap_m_;
    const bool objects_move = !have_arrived();
    is_cut_ = false;
    // A sweep takes the shorter way round: what is seen from one pose to the next must turn by less than half a turn.
    const double turn_rad = way.tail<3>().norm();
    double share = turn_rad > kMostTurn_rad ? kMostTurn_rad / turn_rad : 1.0;
    for (int i = 0; i < kMovingTries; ++i) {
        const Pose end_W = go_along(tool_W_, share * way);
        double free = 1.0;
        for (std::size_t k = 0; k < pairs_.size() && free > 0.0; ++k) {
            const Pose end_OT = seen_from(find_object_W(k, share), end_W);
            const double of_pair = pairs_[k].find_free_share(seen_OT(k), end_OT, touch_m);
            if (of_pair < free) {
                free = of_pair;
                is_cut_ = pairs_[k].is_cut();
            }
        }
        if (free == 1.0) {
            return share;
        }
        if (!may_come_near) {
            return 0.0;
        }
        share *= free;
        // Seen from an object that stands still, the shorter way is a part of the longer one. From one that moves it may be another: it is looked
        // at itself, with less room, for it ends where the longer one touched.
        if (!objects_move) {
            return share;
        }
        touch_m *= kTouchShare;
    }
    return 0.0;
}

Vector6 GodPairs::find_carried() const noexcept {
    std::size_t nearest = 0;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (pairs_[i].least_gap_m() < least_m && moves(i)) {
            least_m = pairs_[i].least_gap_m();
            nearest = i;
        }
    }
    return find_way(tool_W_, goals_W_[nearest] * seen_OT(nearest));
}

void GodPairs::advance(const Vector6& way, double share) noexcept {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        objects_W_[i] = find_object_W(i, share);
    }
    tool_W_ = go_along(tool_W_, share * way);
}

void GodPairs::look_on(double way_m, double share, bool recovers) noexcept {
    look_farther(way_m, share, recovers);
    collect();
}

// Stopped at once by what it did not know of, it would turn from one such contact to the next and back: so they are looked for ever farther, as
// far as it wants to go. Where it gets on, ever less far.
void GodPairs::look_farther(double way_m, double share, bool recovers) noexcept {
    const double least_m = kContactGaps * gap_m_;
    if (share < kStuckShare && share * way_m < kStuckGaps * gap_m_ && !is_cut_ &&
        found_.contacts < kManyContacts) {
        const double most_m = std::max(least_m, std::min(way_m, kLookWidest * reach_m_));
        within_m_ = std::clamp(kLookWidens * within_m_, least_m, most_m);
    } else if (!recovers) {
        within_m_ = std::max(0.5 * within_m_, least_m);
    }
}

void GodPairs::look_nearer() noexcept {
    if (within_m_ > kContactGaps * gap_m_) {
        within_m_ = kContactGaps * gap_m_;
        collect();
    }
}

bool GodPairs::has_within(double within_m) noexcept {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (pairs_[i].has_within(seen_OT(i), within_m)) {
            return true;
        }
    }
    return false;
}

}  // namespace fulcrum
