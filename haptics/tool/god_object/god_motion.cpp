#include "haptics/tool/god_object/god_motion.h"

#include "haptics/tool/god_object/god_force.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kSettledShare = 1.0e-4;  // of the gap at rest: a way as short is none
// What is left after the first round goes on in the next step, if it is shorter than this of the gap at rest, or of the step's longest way.
constexpr double kSettlesNext = 0.02;
constexpr double kTooNear = 0.75;    // of the gap at rest: with less the tool is pushed back first
constexpr double kSamePlace = 0.05;  // of a round's way: how near the tool comes back
constexpr double kBentShare = 0.1;   // a round that gets less far among what moves is carried
constexpr double kNoProgress = 1.0e-6;  // of the objects' way

}  // namespace

void GodMotion::place(const Pose& tool_W) noexcept {
    pairs_.place(tool_W);
    rounds_ = unsettled_ = 0;
    settled_ = true;
    wedged_ = false;
}

bool GodMotion::is_free(const Pose& tool_W, std::span<const MovingFrame> objects) const noexcept {
    return pairs_.is_free(tool_W, objects);
}

// Where a valley's walls meet at a small angle each sends it to the other, by less than the gap at rest: no round gets farther.
bool GodMotion::comes_back(double gone_m) const noexcept {
    const Pose& tool_W = pairs_.tool_W();
    const auto is_here = [&](const Pose& been_W) {
        return (been_W.position - tool_W.position).norm() <= kSamePlace * gone_m &&
               pairs_.reach_m() * been_W.orientation.angularDistance(tool_W.orientation) <=
                   kSamePlace * gone_m;
    };
    return n_been_ > 1 && pairs_.have_arrived() &&
           std::any_of(been_W_.begin() + 1, been_W_.begin() + static_cast<std::ptrdiff_t>(n_been_),
                       is_here);
}

void GodMotion::note_been() noexcept {
    std::rotate(been_W_.begin(), been_W_.end() - 1, been_W_.end());
    been_W_.front() = pairs_.tool_W();
    n_been_ = std::min(n_been_ + 1, been_W_.size());
}

// A way as short is none.
double GodMotion::find_none_m(bool recovers, double longest_m) const noexcept {
    return recovers || rounds_ == 0 || !allowed_.is_held(pairs_) ? settings_.gap_m * kSettledShare
                                                                 : longest_m * kSettlesNext;
}

// Nothing is left to go; once without what is recalled, that may no longer lie where the tool is.
bool GodMotion::settle() noexcept {
    settled_ = !allowed_.recalls() || is_checked_;
    is_checked_ = true;
    if (!settled_) {
        allowed_.forget();
    }
    return settled_;
}

// How much of the allowed way is free; where that is too little among what moves, another way.
void GodMotion::find_free(Way& way, bool recovers) noexcept {
    way.share = pairs_.find_free_share(way.way);
    if (recovers && !(way.share > 0.0)) {
        // So near any way on which an object goes too may touch at once: it waits.
        pairs_.wait();
        way.way = allowed_.find(pairs_, slips_, pairs_.tool_W());
        way.share = pairs_.find_free_share(way.way);
    } else if (!recovers && way.share < kBentShare && !pairs_.have_arrived()) {
        // On a way as bent as that what moves would take many rounds: the tool is carried first.
        const Vector6 carried = pairs_.find_carried();
        if (const double share = pairs_.find_free_share(carried); share > way.share) {
            way.way = carried;
            way.share = share;
        }
    }
}

// One round; whether another may get farther.
bool GodMotion::slide_once(const Pose& wanted_W, std::span<const MovingFrame> objects,
                           bool recovers, double& longest_m) noexcept {
    pairs_.set_goals(objects);
    Way way;
    way.way = allowed_.find(pairs_, slips_, recovers ? pairs_.tool_W() : wanted_W);
    way.way_m = way.way.head<3>().norm() + pairs_.reach_m() * way.way.tail<3>().norm();
    if (!recovers) {
        allowed_.forget_idle(pairs_);
    }
    if (way.way_m <= find_none_m(recovers, longest_m) && pairs_.have_arrived()) {
        return recovers || !settle();
    }
    longest_m = std::max(longest_m, recovers ? 0.0 : way.way_m);
    find_free(way, recovers);
    const double gone_m = way.share * way.way_m;
    if (recovers && !(way.share > 0.0)) {
        return true;
    }
    if (!(way.share > 0.0) ||
        (way.share < kNoProgress && gone_m < kSettledShare * settings_.gap_m)) {
        pairs_.look_nearer();
        return false;
    }
    if (!recovers && way.share < 1.0 && !pairs_.is_cut()) {
        allowed_.recall(pairs_);
    }
    note_been();
    pairs_.advance(way.way, way.share);
    pairs_.look_on(way.way_m, way.share, recovers);
    settled_ = !recovers && comes_back(gone_m);
    return !settled_;
}

void GodMotion::slide(const Pose& wanted_W, std::span<const MovingFrame> objects) noexcept {
    unsettled_ = settled_ ? 0 : unsettled_ + 1;
    settled_ = false;
    n_been_ = 0;
    allowed_.forget();
    is_checked_ = false;
    bool may_recover = true;
    double longest_m = settings_.gap_m;
    for (rounds_ = 0; rounds_ < settings_.most_rounds; ++rounds_) {
        // Where it was stopped short of the gap at rest it is pushed there first: so short a way is as straight as its contacts take it to be.
        const bool recovers =
            may_recover && pairs_.found().least_gap_m < kTooNear * settings_.gap_m;
        may_recover = !recovers;
        if (!slide_once(wanted_W, objects, recovers, longest_m)) {
            break;
        }
    }
    wedged_ = !pairs_.are_at(objects);
}

bool GodMotion::move(const Pose& held_W, std::span<const MovingFrame> objects,
                     bool asks_near) noexcept {
    if (!pairs_.is_begun()) {
        if (!pairs_.begin(objects)) {
            return false;
        }
        slips_.forget(pairs_);
    }
    // As far as it may go.
    const Pose& tool_W = pairs_.tool_W();
    slide(go_along(tool_W, settings_.step_share * find_way(tool_W, held_W)), objects);
    slips_.note(pairs_);
    presses_.look(pairs_, asks_near);
    return true;
}

bool GodMotion::tell(GodContactSet& set) const noexcept {
    const GodFound& found = pairs_.found();
    set.step = {.rounds = rounds_,
                .contacts = found.contacts,
                .least_gap_m = found.least_gap_m,
                .settled = settled_,
                .unsettled = unsettled_,
                .wedged = wedged_,
                .too_many = found.too_many};
    presses_.tell_places(pairs_, slips_, set);
    if (is_told()) {
        presses_.tell_presses(pairs_, slips_, set);
    }
    return is_told();
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
