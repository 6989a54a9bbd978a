#include "haptics/tool/god_motion.h"

#include "haptics/tool/god_force.h"

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
constexpr double kSettledShare = 1.0e-4;    // of the gap at rest: a way as short is none
// What is left after the first round goes on in the next step, if it is shorter than this of the gap at rest, or of the step's longest way.
constexpr double kSettlesNext = 0.02;
constexpr double kTooNear = 0.75;   // of the gap at rest: with less the tool is pushed back first
constexpr double kObjectWay = 0.1;  // of the tool's reach, that an object goes in a round
constexpr double kObjectTurn_rad = 0.02;  // likewise
constexpr double kMostTurn_rad = 3.0;     // of the tool, in a round
constexpr double kSamePlace = 0.05;       // of a round's way: how near the tool comes back
constexpr int kMovingTries = 4;
constexpr double kNoProgress = 1.0e-6;  // of the objects' way

// As near to length 1 as numbers can be: what is swept and what is looked at must be one place.
Pose clean(const Pose& pose) noexcept {
    return {pose.position, pose.orientation.normalized()};
}

Pose seen_from(const Pose& object_W, const Pose& tool_W) noexcept {
    return object_W.inverse() * tool_W;
}

}  // namespace

void GodMotion::place(const Pose& tool_W) noexcept {
    pose_W_ = tool_W;
    is_begun_ = false;
    for (GodPair& pair : pairs_) {
        pair.forget();
    }
    step_ = {};
}

bool GodMotion::is_free(const Pose& tool_W, std::span<const MovingFrame> objects) const noexcept {
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

bool GodMotion::is_apart(const Pose& tool_W, std::span<const MovingFrame> objects) const noexcept {
    if (objects.size() != pairs_.size() || !is_finite(tool_W) ||
        !std::ranges::all_of(objects, [](const MovingFrame& one) { return is_place(one); })) {
        return false;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (!pairs_[i].is_apart(seen_from(clean(objects[i].pose_W), tool_W),
                                kFreeGaps * settings_.gap_m)) {
            return false;
        }
    }
    return true;
}

bool GodMotion::begin(std::span<const MovingFrame> objects) noexcept {
    if (is_begun_) {
        return true;
    }
    if (!is_apart(pose_W_, objects)) {
        return false;
    }
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        objects_W_[i] = clean(objects[i].pose_W);
    }
    is_begun_ = true;
    forget_slips();
    within_m_ = kContactGaps * settings_.gap_m;
    collect();
    return true;
}

void GodMotion::collect() noexcept {
    collect_within();
    // More than there is room for, since they were looked for far away: then only those that hold it.
    if (const double least_m = kContactGaps * settings_.gap_m;
        step_.too_many && within_m_ > least_m) {
        within_m_ = least_m;
        collect_within();
    }
}

void GodMotion::collect_within() noexcept {
    step_.contacts = 0;
    step_.least_gap_m = std::numeric_limits<double>::infinity();
    step_.too_many = false;
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        pairs_[i].collect(seen_from(objects_W_[i], pose_W_), within_m_);
        step_.contacts += static_cast<int>(pairs_[i].contacts().size());
        step_.least_gap_m = std::min(step_.least_gap_m, pairs_[i].least_gap_m());
        step_.too_many = step_.too_many || pairs_[i].is_full();
    }
}

Pose GodMotion::find_object_W(std::size_t i, double share) const noexcept {
    if (share == 1.0 || is_same(objects_W_[i], goals_W_[i])) {
        return goals_W_[i];
    }
    return go_along(objects_W_[i], share * find_way(objects_W_[i], goals_W_[i]));
}

// Where an object may be at most at the end of this round: a turn so short that what it pushes goes straight.
void GodMotion::set_goals(std::span<const MovingFrame> objects) noexcept {
    for (std::size_t i = 0; i < objects.size(); ++i) {
        goals_W_[i] = clean(objects[i].pose_W);
        if (step_.contacts == 0 || is_same(objects_W_[i], goals_W_[i])) {
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

double GodMotion::find_free_share(const Vector6& way) noexcept {
    double touch_m = kTouchShare * std::min(settings_.gap_m, step_.least_gap_m);
    const bool may_come_near = touch_m >= kLeastTouch * settings_.gap_m;
    const bool objects_move = !have_arrived();
    is_cut_ = false;
    // A sweep takes the shorter way round: what is seen from one pose to the next must turn by less than half a turn.
    const double turn_rad = way.tail<3>().norm();
    double share = turn_rad > kMostTurn_rad ? kMostTurn_rad / turn_rad : 1.0;
    for (int i = 0; i < kMovingTries; ++i) {
        const Pose end_W = go_along(pose_W_, share * way);
        double free = 1.0;
        for (std::size_t k = 0; k < pairs_.size() && free > 0.0; ++k) {
            const Pose object_W = find_object_W(k, share);
            const double of_pair = pairs_[k].find_free_share(seen_from(objects_W_[k], pose_W_),
                                                             seen_from(object_W, end_W), touch_m);
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

// With the object that is nearest of those that move: seen from that one it stands still, and touches nothing on the way.
Vector6 GodMotion::find_carried() const noexcept {
    std::size_t nearest = 0;
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        if (pairs_[i].least_gap_m() < least_m && !is_same(objects_W_[i], goals_W_[i])) {
            least_m = pairs_[i].least_gap_m();
            nearest = i;
        }
    }
    return find_way(pose_W_, goals_W_[nearest] * seen_from(objects_W_[nearest], pose_W_));
}

void GodMotion::advance(const Vector6& way, double share) noexcept {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
        objects_W_[i] = find_object_W(i, share);
    }
    pose_W_ = go_along(pose_W_, share * way);
}

bool GodMotion::have_arrived() const noexcept {
    return std::ranges::equal(objects_W_, goals_W_, is_same);
}

// Stopped at once by what it did not know of, it would turn from one such contact to the next and back: so they are looked for ever farther, as
// far as it wants to go. Where it gets on, ever less far.
void GodMotion::look_farther(double way_m, double share, bool recovers) noexcept {
    const double least_m = kContactGaps * settings_.gap_m;
    if (share < kStuckShare && share * way_m < kStuckGaps * settings_.gap_m && !is_cut_ &&
        step_.contacts < kManyContacts) {
        const double most_m = std::max(least_m, std::min(way_m, kLookWidest * reach_m_));
        within_m_ = std::clamp(kLookWidens * within_m_, least_m, most_m);
    } else if (!recovers) {
        within_m_ = std::max(0.5 * within_m_, least_m);
    }
}

// Where a valley's walls meet at a small angle each sends it to the other, by less than the gap at rest: no round gets farther.
bool GodMotion::comes_back(double gone_m) noexcept {
    const auto is_here = [&](const Pose& been_W) {
        return (been_W.position - pose_W_.position).norm() <= kSamePlace * gone_m &&
               reach_m_ * been_W.orientation.angularDistance(pose_W_.orientation) <=
                   kSamePlace * gone_m;
    };
    return n_been_ > 1 && have_arrived() &&
           std::any_of(been_W_.begin() + 1, been_W_.begin() + static_cast<std::ptrdiff_t>(n_been_),
                       is_here);
}

// What was looked for far away may be what holds it.
void GodMotion::look_nearer() noexcept {
    if (within_m_ > kContactGaps * settings_.gap_m) {
        within_m_ = kContactGaps * settings_.gap_m;
        collect();
    }
}

void GodMotion::note_been() noexcept {
    std::rotate(been_W_.begin(), been_W_.end() - 1, been_W_.end());
    been_W_.front() = pose_W_;
    n_been_ = std::min(n_been_ + 1, been_W_.size());
}

// A way as short is none.
double GodMotion::find_none_m(bool recovers, double longest_m) const noexcept {
    return recovers || step_.rounds == 0 || !is_held() ? settings_.gap_m * kSettledShare
                                                       : longest_m * kSettlesNext;
}

// Nothing is left to go; once without what is recalled, that may no longer lie where the tool is.
bool GodMotion::settle() noexcept {
    step_.settled = n_recalled_ == 0 || is_checked_;
    is_checked_ = true;
    n_recalled_ = step_.settled ? n_recalled_ : 0;
    return step_.settled;
}

// One round; whether another may get farther.
bool GodMotion::slide_once(const Pose& wanted_W, std::span<const MovingFrame> objects,
                           bool recovers, double& longest_m) noexcept {
    set_goals(objects);
    Vector6 way = find_allowed(recovers ? pose_W_ : wanted_W);
    const double way_m = way.head<3>().norm() + reach_m_ * way.tail<3>().norm();
    if (!recovers) {
        forget_idle();
    }
    if (way_m <= find_none_m(recovers, longest_m) && have_arrived()) {
        return recovers || !settle();
    }
    longest_m = std::max(longest_m, recovers ? 0.0 : way_m);
    double share = find_free_share(way);
    if (recovers && !(share > 0.0)) {
        // So near any way on which an object goes too may touch at once: it waits.
        std::ranges::copy(objects_W_, goals_W_.begin());
        way = find_allowed(pose_W_);
        share = find_free_share(way);
        if (!(share > 0.0)) {
            return true;
        }
    } else if (!recovers && share < kStuckShare && !have_arrived()) {
        // On a way as bent as that what moves would take many rounds: the tool is carried first.
        const Vector6 carried = find_carried();
        if (const double carried_share = find_free_share(carried); carried_share > share) {
            way = carried;
            share = carried_share;
        }
    }
    if (!(share > 0.0) ||
        (share < kNoProgress && share * way_m < kSettledShare * settings_.gap_m)) {
        look_nearer();
        return false;
    }
    if (!recovers && share < 1.0 && !is_cut_) {
        recall();
    }
    note_been();
    advance(way, share);
    look_farther(way_m, share, recovers);
    collect();
    step_.settled = !recovers && comes_back(share * way_m);
    return !step_.settled;
}

void GodMotion::slide(const Pose& wanted_W, std::span<const MovingFrame> objects) noexcept {
    step_.unsettled = step_.settled ? 0 : step_.unsettled + 1;
    step_.settled = false;
    n_been_ = n_recalled_ = 0;
    is_checked_ = false;
    bool may_recover = true;
    double longest_m = settings_.gap_m;
    for (step_.rounds = 0; step_.rounds < settings_.most_rounds; ++step_.rounds) {
        // Where it was stopped short of the gap at rest it is pushed there first: so short a way is as straight as its contacts take it to be.
        const bool recovers = may_recover && step_.least_gap_m < kTooNear * settings_.gap_m;
        may_recover = !recovers;
        if (!slide_once(wanted_W, objects, recovers, longest_m)) {
            break;
        }
    }
    step_.wedged = false;
    for (std::size_t i = 0; i < objects.size(); ++i) {
        step_.wedged = step_.wedged || !is_same(objects_W_[i], clean(objects[i].pose_W));
    }
}

bool GodMotion::move(const Pose& held_W, std::span<const MovingFrame> objects,
                     bool asks_near) noexcept {
    if (!begin(objects)) {
        return false;
    }
    // As far as it may go.
    slide(go_along(pose_W_, settings_.step_share * find_way(pose_W_, held_W)), objects);
    note_slips();
    is_near_ = find_near(asks_near);
    return true;
}

bool GodMotion::run_once() noexcept {
    if (channels_ == nullptr || !channels_->goal.take()) {
        return false;
    }
    const GodGoal& goal = channels_->goal.value();
    if (goal.n_placements != n_placements_) {
        place(goal.placed_W);
        n_placements_ = goal.n_placements;
    }
    const auto n_objects = static_cast<std::size_t>(goal.n_objects);
    const bool moved = move(goal.held_W, std::span(goal.objects).first(n_objects), true);
    if (moved && !is_told()) {
        return true;
    }
    told_->publish(
        ThriftyWriter<GodContactSet>::kNoRevision,
        [&](GodContactSet& set) {
            (void)tell(set);
            set.stamp_s = goal.stamp_s;
            set.n_placements = goal.n_placements;
            set.is_apart = moved;
        },
        [](GodContactSet& /*set*/) {});
    return true;
}

}  // namespace fulcrum
