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
// How far upwards a contact must push to bear: three degrees from level.
constexpr double kBearing = 0.05;

bool is_touching(const ContactPair& pair) noexcept {
    return pair.meet_s == 0.0 &&
           std::ranges::any_of(pair.manifold.points(), [](const ContactPoint& point) {
               return point.gap_m <= kTouching_m;
           });
}

// What is left of a couple along its own way: never the other way. What is no number stays so.
Vector3 keep_way(const Vector3& told, const Vector3& left) noexcept {
    const double squared = told.squaredNorm();
    return squared > 0.0 ? Vector3(std::max(left.dot(told) / squared, 0.0) * told) : told;
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
        ++snapshot_.effort.n_steps;
        snapshot_.effort.n_unconverged += world_->report().n_unconverged > 0 ? 1 : 0;
        find_touching();
        if (carrier_ >= 0) {
            find_carried();
            notice_catches(now_s, due_s_);
        }
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
    if (command.kind == WorldCommand::Kind::release) {
        hide_carried();
        return;
    }
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
        put(body, Pose::at(command.position_W),
            {is_drop ? command.velocity_W : Vector3::Zero(), Vector3::Zero()});
    }
}

void RigidLoop::put(std::int32_t body, const Pose& shape_W, const Twist& velocity_W) noexcept {
    world_->place(body, shape_W, velocity_W);
    Told& told = told_[static_cast<std::size_t>(body)];
    ++told.n_placements;
    told.in_air_s = 0.0;
    told.is_carried = told.is_caught = false;
    told.changing_s = 0.0;
}

void RigidLoop::hide_carried() noexcept {
    for (std::size_t i = 0; i < told_.size(); ++i) {
        Told& told = told_[i];
        if ((told.is_carried || told.is_caught) && told.scene_body >= 0) {
            told.is_present = told.is_carried = told.is_caught = false;
            world_->set_present(static_cast<std::int32_t>(i), false);
        }
    }
}

void RigidLoop::take_pushes(double now_s) noexcept {
    for (Told& told : told_) {
        told.is_held = false;
    }
    for (RigidChannels* hand : hands_) {
        hand->pushes.take();
        const HandPushes& pushes = hand->pushes.value();
        if (!(std::abs(now_s - pushes.stamp_s) <= kStalePush_s) || pushes.stamp_s < 0.0) {
            continue;
        }
        const std::int32_t count = std::clamp(pushes.count, 0, kMaxSolids);
        for (std::int32_t i = 0; i < count; ++i) {
            take_push(pushes.pushes[static_cast<std::size_t>(i)]);
        }
    }
}

// A push on where it was before it was put elsewhere is no push on it any more.
void RigidLoop::take_push(const RigidPush& push) noexcept {
    const std::int32_t body = body_of_solid(push.solid);
    if (body < 0 || push.n_placements != told_[static_cast<std::size_t>(body)].n_placements) {
        return;
    }
    if (push.puts) {
        if (is_finite(push.pose_W)) {
            put(body, push.pose_W, {});
        }
        return;
    }
    BodyHold hold = push.hold;
    const bool is_grip = hold.bounds.along_W.isZero(0.0);
    hold.at_W = world_->shape_pose_W(body) * (push.pose_W.inverse() * push.hold.at_W);
    hold.push_W = find_push_W(push, hold.at_W);
    if (!is_grip) {
        hold.push_W.torque = keep_way(push.hold.push_W.torque, hold.push_W.torque);
        const double most_Nm = compute_length(push.hold.push_W.torque);
        hold.bounds.most_Nm =
            hold.push_W.torque.isZero(0.0) ? 0.0 : std::min(hold.bounds.most_Nm, most_Nm);
    }
    world_->hold(body, hold);
    told_[static_cast<std::size_t>(body)].is_held |= is_grip;
}

std::int32_t RigidLoop::body_of_solid(std::int32_t solid) const noexcept {
    const auto i = static_cast<std::size_t>(solid);
    return solid >= 0 && i < solids_.size() ? solids_[i] : kNoBody;
}

// Where it is held now.
Wrench RigidLoop::find_push_W(const RigidPush& push, const Vector3& at_W) const noexcept {
    const std::int32_t body = body_of_solid(push.solid);
    const Pose shape_W = world_->shape_pose_W(body);
    const Twist moves = velocity_W(body);
    const BodyHold& hold = push.hold;
    const Vector3 sped_up = moves.linear + moves.angular.cross(at_W - shape_W.position) -
                            push.velocity_W.linear -
                            push.velocity_W.angular.cross(hold.at_W - push.pose_W.position);
    const Vector3 turned = compute_log(shape_W.orientation * push.pose_W.orientation.conjugate());
    const PushSlopes& slopes = hold.slopes;
    return {hold.push_W.force - slopes.stiffness_N_per_m * (at_W - hold.at_W) -
                slopes.damping_Ns_per_m * sped_up,
            hold.push_W.torque - slopes.turn_stiffness_Nm_per_rad * turned -
                slopes.turn_damping_Nms_per_rad * (moves.angular - push.velocity_W.angular)};
}

// Where nothing is heavy whatever touches does.
bool RigidLoop::bears(const ContactPair& pair, bool is_second) const noexcept {
    const double upwards = pair.manifold.normal_W.dot(up_W_);
    return is_touching(pair) && (up_W_.isZero(0.0) || (is_second ? -upwards : upwards) >= kBearing);
}

void RigidLoop::find_touching() noexcept {
    for (Told& told : told_) {
        told.touches = told.is_stopped = told.meets_caught = false;
    }
    const ContactPairs& pairs = world_->contacts();
    for (int i = 0; i < pairs.count(); ++i) {
        const ContactPair& pair = pairs.at(i);
        if (is_touching(pair)) {
            Told& a = told_[static_cast<std::size_t>(pair.bodies.first)];
            Told& b = told_[static_cast<std::size_t>(pair.bodies.second)];
            a.touches = b.touches = true;
            a.is_stopped |= b.stays;
            b.is_stopped |= a.stays;
            a.meets_caught |= b.is_caught || pair.bodies.second == carrier_;
            b.meets_caught |= a.is_caught || pair.bodies.first == carrier_;
        }
    }
}

// From the carrier on, a touch farther each time. A round in which nothing is new is the last: a pile has no more than it is high.
void RigidLoop::find_carried() noexcept {
    for (std::size_t i = 0; i < told_.size(); ++i) {
        told_[i].is_carried = static_cast<std::int32_t>(i) == carrier_;
    }
    const ContactPairs& pairs = world_->contacts();
    for (bool is_new = true; is_new;) {
        is_new = false;
        for (int i = 0; i < pairs.count(); ++i) {
            const ContactPair& pair = pairs.at(i);
            Told& a = told_[static_cast<std::size_t>(pair.bodies.first)];
            Told& b = told_[static_cast<std::size_t>(pair.bodies.second)];
            Told& next = a.is_carried ? b : a;
            if (a.is_carried != b.is_carried && !next.stays && !next.is_stopped &&
                bears(pair, a.is_carried)) {
                next.is_carried = is_new = true;
            }
        }
    }
}

void RigidLoop::notice_catches(double now_s, double dt_s) noexcept {
    for (Told& told : told_) {
        if (told.scene_body < 0 || told.is_carried == told.is_caught) {
            told.changing_s = 0.0;
            continue;
        }
        if (told.changing_s == 0.0) {
            told.caught_m_per_s = std::max(told.speed_m_per_s, told.earlier_speed_m_per_s);
        }
        told.changing_s += dt_s;
        const bool may_bounce = told.is_caught && !told.is_stopped;
        if (told.changing_s >= (may_bounce ? kLost_s : kCaught_s)) {
            told.is_caught = told.is_carried;
            if (told.is_caught && lesson_ != nullptr) {
                (void)lesson_->events.push(
                    {WorldEvent::Kind::caught, told.scene_body, now_s, told.caught_m_per_s});
            }
        }
    }
}

void RigidLoop::notice_landings(double now_s, double dt_s) noexcept {
    for (std::size_t i = 0; i < told_.size(); ++i) {
        Told& told = told_[i];
        const bool is_carried = told.touches || told.is_held || !told.is_present;
        const bool is_stopped = told.touches && (told.is_stopped || !told.meets_caught);
        if (is_stopped && told.in_air_s >= kLeastFlight_s && told.scene_body >= 0 &&
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
        state.where = !told.is_present                 ? BodyWhere::hidden
                      : told.is_held || told.is_caught ? BodyWhere::held
                      : world_->is_asleep(body)        ? BodyWhere::landed
                      : told.touches                   ? BodyWhere::placed
                                                       : BodyWhere::falling;
    }
    lesson_->snapshot.publish(snapshot_);
}

}  // namespace fulcrum
