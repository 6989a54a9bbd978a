// The step path of tool_stage.h.
#include "haptics/loop/tool_stage.h"

#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kStandsStill = 1.5;  // of the interval between two places

WrenchLoan::Way find_motion(const Pose& from_W, const Pose& to_W) noexcept {
    return {to_W.position - from_W.position,
            compute_log((to_W.orientation * from_W.orientation.conjugate()).normalized())};
}

// What is elsewhere is counted as moving there evenly since it was last told to be elsewhere.
Twist compute_twist(const Pose& from_W, const Pose& to_W, double dt_s) noexcept {
    const WrenchLoan::Way way_W = find_motion(from_W, to_W);
    return {way_W.shift_W / dt_s, way_W.turn_W / dt_s};
}

// Against a wrench about a place: its line, nearest to there.
SolidPush compute_push(const Wrench& against_W, const Vector3& about_W) noexcept {
    SolidPush push;
    push.touches = true;
    push.force_W = -against_W.force;
    push.at_W = about_W;
    const Vector3 torque_W = -against_W.torque;
    const double square = push.force_W.squaredNorm();
    if (!(square > 0.0)) {
        push.couple_W = torque_W;
        return push;
    }
    push.at_W += push.force_W.cross(torque_W) / square;
    push.couple_W = torque_W.dot(push.force_W) / square * push.force_W;
    return push;
}

// A wrench about a place `arm` from another, about that one.
Wrench move_about(const Wrench& wrench, const Vector3& arm) noexcept {
    return {wrench.force, wrench.torque + arm.cross(wrench.force)};
}

}  // namespace

void ToolStage::let_go(std::uint32_t put) noexcept {
    is_engaged_ = false;
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        tracks_[i].is_known = tracks_[i].is_known && (put >> i & 1U) == 0;
    }
}

void ToolStage::follow_solids(const ToolRound& round) noexcept {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        Track& track = tracks_[i];
        const Pose& pose_W = round.solid_poses_W[i];
        const double since_s = round.now_s - track.told_s;
        if (!track.is_known || !(since_s > 0.0)) {
            track = {{pose_W, {}}, round.now_s, 0.0, true};
        } else if (!is_same(pose_W, track.frame.pose_W)) {
            track.frame.velocity_W = compute_twist(track.frame.pose_W, pose_W, since_s);
            track.frame.pose_W = pose_W;
            track.told_s = round.now_s;
            track.interval_s = since_s;
        } else if (since_s > kStandsStill * track.interval_s) {
            track.frame.velocity_W = {};
        }
        frames_[i] = track.frame;
    }
}

// Nothing is felt; from the next round on, if nothing is touched there.
void ToolStage::follow_hand(const ToolRound& round) noexcept {
    tool_->place(round.hand.pose_W);
    is_engaged_ = round.is_fit && tool_->is_free(frames_);
    pose_W_ = round.hand.pose_W;
    hand_W_ = round.hand.pose_W;
    relief_loan_.settle();
    even_loan_.leave(round.dt_s);
    forget_hand();
    solid_ = kNoBody;
    std::ranges::fill(pushes_, SolidPush{});
    add_up({});
}

void ToolStage::add_lent(const WrenchLoan::Counted& lent, ToolForce& force) const noexcept {
    force.elastic_force += lent.force;
    force.elastic_torque += {lent.torque.now_W / scale_, lent.torque.held_W / scale_};
}

// The hand's, against what is pressed hardest; of what was not touched in the round before, as if that stood still.
WrenchLoan::Way ToolStage::find_way_against(const ToolRound& round) const noexcept {
    const Pose& hand_W = round.hand.pose_W;
    if (solid_ == kNoBody) {
        return find_motion(hand_W_, hand_W);
    }
    const auto i = static_cast<std::size_t>(solid_);
    return find_motion(tracks_[i].tells_hand ? round.solid_poses_W[i] * tracks_[i].hand_B : hand_W_,
                       hand_W);
}

void ToolStage::forget_hand() noexcept {
    for (Track& track : tracks_) {
        track.tells_hand = false;
    }
}

// What of springs and reliefs in the coming period gives back the hand's work: of the springs all but what even normals turn of them, and of
// that and the reliefs as much as is lent.
void ToolStage::count(const ToolFelt& felt, const ToolRound& round, ToolForce& force) noexcept {
    const Pose& hand_W = round.hand.pose_W;
    force.elastic_force = {force.spring_W.force, force.spring_W.force};
    force.elastic_torque = {force.spring_W.torque, force.spring_W.torque};
    if (!has_texture_ && !has_shading_) {
        return;
    }
    const WrenchLoan::Way motion_W = find_motion(hand_W_, hand_W);
    if (has_texture_) {
        relief_loan_.allow(felt.bumps_J, round.dt_s);
        add_lent(relief_loan_.step(felt.texture_W, motion_W), force);
    }
    if (has_shading_) {
        even_loan_.allow(felt.even_J, round.dt_s);
        const WrenchLoan::Counted lent =
            even_loan_.step_evenly(felt.even_W, motion_W, find_way_against(round));
        // The springs' part has it already.
        add_lent({{Vector3::Zero(), lent.force.held_W - lent.force.now_W},
                  {Vector3::Zero(), lent.torque.held_W - lent.torque.now_W}},
                 force);
        for (std::size_t i = 0; i < tracks_.size(); ++i) {
            tracks_[i].tells_hand = pushes_[i].touches;
            if (pushes_[i].touches) {
                tracks_[i].hand_B = round.solid_poses_W[i].inverse() * hand_W;
            }
        }
    }
    hand_W_ = hand_W;
}

void ToolStage::add_up(const ToolEffort& step) noexcept {
    const ToolEffort before = effort_;
    effort_ = step;
    effort_.most_error_N = std::max(before.most_error_N, step.error_N);
    effort_.n_inexact = before.n_inexact + (step.error_N > 0.0 ? 1 : 0);
    effort_.n_cut = before.n_cut + (step.in_time ? 0 : 1);
    for (std::size_t i = 0; i < kToolLacks; ++i) {
        effort_.n_lacking[i] = before.n_lacking[i] + (step.lacks[i] ? 1 : 0);
    }
}

void ToolStage::tell_pushes(const Wrench& felt_W) noexcept {
    const std::span<const ToolTouch> touches = tool_->touches();
    // What the hand feels beyond what the solids push, about the grip.
    const Vector3 arm_W = tool_->centre_W() - pose_W_.position;
    Wrench rest_W = felt_W;
    double sizes_N = 0.0;
    double n_touched = 0.0;
    for (const ToolTouch& touch : touches) {
        if (touch.touches) {
            const Wrench own_W = move_about(touch.wrench_W, arm_W);
            rest_W.force -= own_W.force;
            rest_W.torque -= own_W.torque;
            sizes_N += compute_length(own_W.force);
            n_touched += 1.0;
        }
    }
    // Which is pressed hardest, and each with what?
    solid_ = kNoBody;
    double most_N = -1.0;
    for (std::size_t i = 0; i < pushes_.size(); ++i) {
        pushes_[i] = {};
        if (!touches[i].touches) {
            continue;
        }
        const Wrench own_W = move_about(touches[i].wrench_W, arm_W);
        const double force_N = compute_length(own_W.force);
        const double share = sizes_N > 0.0 ? force_N / sizes_N : 1.0 / n_touched;
        pushes_[i] =
            compute_push({own_W.force + share * rest_W.force, own_W.torque + share * rest_W.torque},
                         pose_W_.position);
        if (force_N > most_N) {
            most_N = force_N;
            solid_ = static_cast<std::int32_t>(i);
        }
    }
}

ToolForce ToolStage::step(const ToolRound& round) noexcept {
    ToolForce force;
    if (round.solid_poses_W.size() != tracks_.size()) {
        // The poses are no numbers in this round.
        is_engaged_ = false;
        pose_W_ = round.hand.pose_W;
        solid_ = kNoBody;
        std::ranges::fill(pushes_, SolidPush{});
        return force;
    }
    // Where the solids are and how they move.
    follow_solids(round);
    if (!is_engaged_ || !round.is_fit) {
        follow_hand(round);
        return force;
    }
    // The tool among them.
    const ToolFelt felt = tool_->move(round.hand, frames_, round.now_s, round.dt_s);
    if (!felt.moved || !is_finite(felt.felt_W) || !is_finite(felt.spring_W)) {
        force.failed = true;
        follow_hand(round);
        is_engaged_ = false;
        return force;
    }
    add_up(felt.effort);
    if (lateness_) {
        lateness_->add(beside_->contact_age());
        if (beside_->contact_age().is_lost()) {
            // What was felt has faded.
            follow_hand(round);
            return force;
        }
    }
    pose_W_ = tool_->grip_W();
    tell_pushes(felt.felt_W);
    // What the hand feels of it.
    force.wrench_W = {felt.felt_W.force, felt.felt_W.torque / scale_};
    force.spring_W = {felt.spring_W.force, felt.spring_W.torque / scale_};
    force.texture_W = {felt.texture_W.force, felt.texture_W.torque / scale_};
    count(felt, round, force);
    force.contact.force = felt.spring_W.force;
    force.contact.energy_J = felt.spring_energy_J;
    force.contact.normal = compute_direction(felt.spring_W.force);
    force.contact.push = felt.felt_W.force.dot(force.contact.normal);
    return force;
}

}  // namespace fulcrum
