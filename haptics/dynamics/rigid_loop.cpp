// The step path of rigid_loop.h.
#include "haptics/dynamics/rigid_loop.h"

#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Contacts are known ahead of time; nearer than this is touching.
constexpr double kTouching_m = 5.0e-4;

Vector3 shorten(const Vector3& v, double most) noexcept {
    const double length = compute_length(v);
    return length > most ? Vector3(most / length * v) : v;
}

// Less by what of `taken` lies along it: no more than it was, and never the other way. What is no number stays so.
Vector3 give_way(const Vector3& push, const Vector3& taken) noexcept {
    const double length = compute_length(push);
    if (!(length > 0.0)) {
        return push;
    }
    return std::clamp(1.0 - (push / length).dot(taken) / length, 0.0, 1.0) * push;
}

// A force that gives way as far as the hand's bounds let it.
Vector3 give_way(const Vector3& force_W, const Vector3& taken_W,
                 const PushBounds& bounds) noexcept {
    const Vector3 left_W = force_W - taken_W;
    if (bounds.along_W.isZero(0.0)) {
        return shorten(left_W, bounds.most_N);
    }
    const Vector3& n = bounds.along_W;
    const Vector3 across_W = force_W - n.dot(force_W) * n;
    const double most_across_N = std::max(bounds.friction_N, compute_length(across_W));
    return std::clamp(n.dot(left_W), 0.0, bounds.most_N) * n +
           shorten(left_W - n.dot(left_W) * n, most_across_N);
}

}  // namespace

void RigidLoop::step(double now_s) noexcept {
    if (!std::isfinite(now_s)) {
        return;
    }
    const double since_s = started_ ? now_s - now_s_ : period_s_;
    started_ = true;
    now_s_ = now_s;
    passed_s_ += std::max(since_s, 0.0);
    due_s_ = std::min(passed_s_, kLongestRigidStep_s);
    take_commands();
    if (due_s_ >= kShortestRigidStep_s) {
        take_pushes(now_s);
        world_->step(due_s_);
        find_touching();
        notice_landings(now_s, due_s_);
        frame_.rate = due_s_ / passed_s_;
        due_s_ = passed_s_ = 0.0;
    }
    tell_hands(now_s);
    tell_lesson(now_s);
}

void RigidLoop::silence(double) noexcept {}

void RigidLoop::take_commands() noexcept {
    // As many as a ring holds: a lesson that never stops asking does not keep the world from moving.
    constexpr int kMostCommands = 256;
    WorldCommand command;
    for (int i = 0; i < kMostCommands && lesson_ != nullptr && lesson_->commands.pop(command);
         ++i) {
        apply(command);
    }
}

// What it does not know of is passed over.
void RigidLoop::apply(const WorldCommand& command) noexcept {
    if (command.body < 0 || command.body >= kMaxBodies || !is_finite(command.position_W) ||
        !is_finite(command.velocity_W)) {
        return;
    }
    const std::int32_t body = body_of_scene_[static_cast<std::size_t>(command.body)];
    const bool is_place = command.kind == WorldCommand::Kind::place;
    const bool is_drop = command.kind == WorldCommand::Kind::drop;
    const bool is_hide = command.kind == WorldCommand::Kind::hide;
    if (body < 0 || !(is_place || is_drop || is_hide)) {
        return;
    }
    Told& told = told_[static_cast<std::size_t>(body)];
    told.is_present = !is_hide;
    world_->set_present(body, told.is_present);
    if (!is_hide) {
        world_->place(body, Pose::at(command.position_W),
                      {is_drop ? command.velocity_W : Vector3::Zero(), Vector3::Zero()});
        ++told.n_placements;
        told.in_air_s = 0.0;
    }
}

void RigidLoop::take_pushes(double now_s) noexcept {
    for (Told& told : told_) {
        told.is_held = false;
    }
    for (std::size_t hand = 0; hand < hands_.size(); ++hand) {
        const bool is_new = hands_[hand]->pushes.take();
        const HandPushes& pushes = hands_[hand]->pushes.value();
        if (!(std::abs(now_s - pushes.stamp_s) <= kStalePush_s) || pushes.stamp_s < 0.0) {
            continue;
        }
        if (is_new) {
            aheads_s_[hand] = std::clamp(due_s_ - (now_s - pushes.stamp_s), 0.0, due_s_);
        }
        const std::int32_t count = std::clamp(pushes.count, 0, kMaxSolids);
        for (std::int32_t i = 0; i < count; ++i) {
            take_push(pushes.pushes[static_cast<std::size_t>(i)], aheads_s_[hand]);
        }
    }
}

// A push on where it was before it was put elsewhere is no push on it any more.
void RigidLoop::take_push(const RigidPush& push, double ahead_s) noexcept {
    const std::int32_t body = body_of_solid(push.solid);
    if (body < 0 || push.n_placements != told_[static_cast<std::size_t>(body)].n_placements) {
        return;
    }
    BodyHold hold = push.hold;
    hold.push_W = find_push_W(push, world_->behind_s(body) + ahead_s);
    world_->hold(body, hold);
    told_[static_cast<std::size_t>(body)].is_held |= hold.bounds.along_W.isZero(0.0);
}

std::int32_t RigidLoop::body_of_solid(std::int32_t solid) const noexcept {
    const auto i = static_cast<std::size_t>(solid);
    return solid >= 0 && i < solids_.size() ? solids_[i] : kNoBody;
}

Wrench RigidLoop::find_push_W(const RigidPush& push, double ahead_s) const noexcept {
    const std::int32_t body = body_of_solid(push.solid);
    const Pose shape_W = world_->shape_pose_W(body);
    const Twist moves = velocity_W(body);
    const Pose ahead_W{shape_W.position + ahead_s * moves.linear,
                       compute_exp(ahead_s * moves.angular) * shape_W.orientation};
    const BodyHold& hold = push.hold;
    const Vector3 at_W = ahead_W * (push.pose_W.inverse() * hold.at_W);
    const Vector3 sped_up = moves.linear + moves.angular.cross(at_W - ahead_W.position) -
                            push.velocity_W.linear -
                            push.velocity_W.angular.cross(hold.at_W - push.pose_W.position);
    const Vector3 turned = compute_log(ahead_W.orientation * push.pose_W.orientation.conjugate());
    const PushSlopes& slopes = hold.slopes;
    const Vector3 taken_N =
        slopes.stiffness_N_per_m * (at_W - hold.at_W) + slopes.damping_Ns_per_m * sped_up;
    const Vector3 taken_Nm =
        slopes.turn_stiffness_Nm_per_rad * turned +
        slopes.turn_damping_Nms_per_rad * (moves.angular - push.velocity_W.angular);
    const bool is_grip = hold.bounds.along_W.isZero(0.0);
    return {give_way(hold.push_W.force, taken_N, hold.bounds),
            is_grip ? shorten(hold.push_W.torque - taken_Nm, hold.bounds.most_Nm)
                    : give_way(hold.push_W.torque, taken_Nm)};
}

void RigidLoop::find_touching() noexcept {
    for (Told& told : told_) {
        told.touches = false;
    }
    const ContactPairs& pairs = world_->contacts();
    for (int i = 0; i < pairs.count(); ++i) {
        const ContactPair& pair = pairs.at(i);
        if (pair.meet_s == 0.0 &&
            std::ranges::any_of(pair.manifold.points(), [](const ContactPoint& point) {
                return point.gap_m <= kTouching_m;
            })) {
            told_[static_cast<std::size_t>(pair.bodies.first)].touches = true;
            told_[static_cast<std::size_t>(pair.bodies.second)].touches = true;
        }
    }
}

void RigidLoop::notice_landings(double now_s, double dt_s) noexcept {
    for (std::size_t i = 0; i < told_.size(); ++i) {
        Told& told = told_[i];
        const bool is_carried = told.touches || told.is_held || !told.is_present;
        if (told.touches && told.in_air_s >= kLeastFlight_s && told.scene_body >= 0 &&
            lesson_ != nullptr) {
            (void)lesson_->events.push({WorldEvent::Kind::landed, told.scene_body, now_s,
                                        std::max(told.speed_m_per_s, told.earlier_speed_m_per_s)});
        }
        told.in_air_s = is_carried ? 0.0 : told.in_air_s + dt_s;
        told.earlier_speed_m_per_s = told.speed_m_per_s;
        told.speed_m_per_s =
            compute_length(world_->state(static_cast<std::int32_t>(i)).velocity_W.linear);
    }
}

// Of the shape's origin.
Twist RigidLoop::velocity_W(std::int32_t body) const noexcept {
    const RigidState& state = world_->state(body);
    const Vector3 arm = world_->shape_pose_W(body).position - state.pose_W.position;
    return {state.velocity_W.linear + state.velocity_W.angular.cross(arm),
            state.velocity_W.angular};
}

void RigidLoop::tell_hands(double now_s) noexcept {
    frame_.stamp_s = now_s;
    for (std::size_t i = 0; i < solids_.size(); ++i) {
        const std::int32_t body = solids_[i];
        if (body >= 0) {
            const Told& told = told_[static_cast<std::size_t>(body)];
            frame_.solids[i] = {world_->shape_pose_W(body), velocity_W(body),
                                world_->behind_s(body) + due_s_, told.is_present,
                                told.n_placements};
        }
    }
    for (RigidChannels* hand : hands_) {
        hand->frame.publish(frame_);
    }
}

void RigidLoop::tell_lesson(double now_s) noexcept {
    if (lesson_ == nullptr) {
        return;
    }
    snapshot_.time_s = now_s;
    for (std::size_t i = 0; i < told_.size(); ++i) {
        const Told& told = told_[i];
        if (told.scene_body < 0) {
            continue;
        }
        const auto body = static_cast<std::int32_t>(i);
        BodyState& state = snapshot_.bodies[static_cast<std::size_t>(told.scene_body)];
        state.pose_W = world_->shape_pose_W(body);
        state.velocity_W = velocity_W(body).linear;
        state.where = !told.is_present          ? BodyWhere::hidden
                      : told.is_held            ? BodyWhere::held
                      : world_->is_asleep(body) ? BodyWhere::landed
                      : told.touches            ? BodyWhere::placed
                                                : BodyWhere::falling;
    }
    lesson_->snapshot.publish(snapshot_);
}

}  // namespace fulcrum
