// The step path of body_stage.h.
#include "haptics/loop/body_stage.h"

#include "haptics/coupling/virtual_coupling.h"
#include "haptics/math/length.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

// Longer than this nothing is moved on: the world is taken to stand. A world of the fewest steps that needs all of a step's time tells twice
// that late; half a step is for what comes between.
constexpr double kLongestAhead_s = 2.5 * kLongestRigidStep_s;
// Of a quaternion's length squared: further from one it was garbled on its way.
constexpr double kTurnTolerance = 2.0e-3;
const Vector3 kGone_W(0.0, -2.0e4, 0.0);  // out of every hand's reach

void scale_slopes(PushSlopes& slopes, const PushShare& left) noexcept {
    slopes.stiffness_N_per_m *= left.force;
    slopes.damping_Ns_per_m *= left.force;
    slopes.late_mass_kg *= left.force;
    slopes.turn_stiffness_Nm_per_rad *= left.couple;
    slopes.turn_damping_Nms_per_rad *= left.couple;
}

}  // namespace

Pose BodyStage::predict(const RigidSolid& told, double now_s) const noexcept {
    const double ahead_s =
        std::clamp(rate_ * (now_s - stamp_s_) + told.behind_s, 0.0, kLongestAhead_s);
    return {told.pose_W.position + ahead_s * told.velocity_W.linear,
            compute_exp(ahead_s * told.velocity_W.angular) * told.pose_W.orientation};
}

// Of the time within which the last correction goes.
double BodyStage::find_left_s(double now_s) const noexcept {
    return std::clamp(blend_s_ - (now_s - heard_s_ + period_s_), 0.0, blend_s_);
}

Pose BodyStage::find_pose(const Body& body, double now_s, double left_s) const noexcept {
    Pose pose_W = predict(body.told, now_s);
    if (left_s > 0.0) {
        const double left = left_s / blend_s_;
        pose_W.position += left * body.shift_W;
        pose_W.orientation = compute_exp(left * body.turn_W) * pose_W.orientation;
    }
    return pose_W;
}

bool BodyStage::is_usable(const RigidFrame& frame) const noexcept {
    const auto is_told = [&](const Body& body) {
        const RigidSolid& told = frame.solids[body.plan.solid];
        const double turned = told.pose_W.orientation.coeffs().squaredNorm();
        return is_finite(told.pose_W) && std::abs(turned - 1.0) <= kTurnTolerance &&
               is_finite(told.velocity_W.linear) && is_finite(told.velocity_W.angular) &&
               std::isfinite(told.behind_s) && told.behind_s >= 0.0;
    };
    return std::isfinite(frame.stamp_s) && frame.stamp_s >= 0.0 && frame.rate >= 0.0 &&
           frame.rate <= 1.0 && std::ranges::all_of(bodies_, is_told);
}

// A frame with anything in it that is no number, no time or no turning is passed over: an old one ages, and that is noticed.
void BodyStage::take_frame(double now_s) noexcept {
    const RigidFrame& frame = channels_->frame.value();
    if (!is_usable(frame)) {
        return;
    }
    // What goes of the last correction in this round is taken from the new one.
    const double left_s = find_left_s(now_s - period_s_);
    std::array<Pose, kMaxSolids> before_W{};
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        before_W[i] = find_pose(bodies_[i], now_s, left_s);
    }
    // Of a clock that stands or went back nobody knows when the next is due.
    const double gap_s = frame.stamp_s - stamp_s_;
    const double due_s = gap_s > 0.0 ? std::min(gap_s, kLongestAhead_s) : kLongestAhead_s;
    blend_s_ = stamp_s_ < 0.0 ? 0.0 : std::max(left_s, due_s);
    stamp_s_ = frame.stamp_s;
    rate_ = frame.rate;
    heard_s_ = now_s;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        Body& body = bodies_[i];
        const RigidSolid& told = frame.solids[body.plan.solid];
        const bool is_placed = told.n_placements != body.told.n_placements;
        const bool is_put = !body.is_known || is_placed || told.is_present != body.told.is_present;
        if (is_placed && i == held_) {
            putting_ = putting_ == Putting::asked ? Putting::done : Putting::wanted;
        }
        body.is_known = true;
        body.told = told;
        const Pose ahead_W = predict(told, now_s);
        body.shift_W = before_W[i].position - ahead_W.position;
        body.turn_W = compute_log(before_W[i].orientation * ahead_W.orientation.conjugate());
        if (is_put) {
            body.shift_W.setZero();
            body.turn_W.setZero();
            put_ |= i == held_ ? 0U : 1U << body.plan.solid;
            if (grip_.solid >= 0 && grip_.body == i) {
                grip_ = {};
            }
        }
    }
}

std::span<const Pose> BodyStage::place(std::span<const Pose> poses_W, double now_s) noexcept {
    put_ = 0;
    std::copy(poses_W.begin(), poses_W.end(), poses_W_.begin());
    if (channels_ != nullptr && channels_->frame.take()) {
        take_frame(now_s);
    }
    const double left_s = find_left_s(now_s);
    for (const Body& body : bodies_) {
        if (body.is_known) {
            Pose& pose_W = poses_W_[body.plan.solid];
            pose_W = find_pose(body, now_s, left_s);
            pose_W.position = body.told.is_present ? pose_W.position : kGone_W;
        }
    }
    if (held_ != kNothingHeld) {
        put_ |= (1U << poses_W.size()) - 1U;
    } else if (grip_.solid >= 0) {
        put_ |= 1U << grip_.solid;
    }
    return {poses_W_.data(), poses_W.size()};
}

double BodyStage::age_s(double now_s) const noexcept {
    if (channels_ == nullptr) {
        return 0.0;
    }
    return stamp_s_ < 0.0 ? std::numeric_limits<double>::infinity() : std::abs(now_s - stamp_s_);
}

void BodyStage::begin_grip(const ProxyContact& contact, const GrippingHand& hand) noexcept {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        const RigidSolidPlan& plan = bodies_[i].plan;
        if (contact.solid != static_cast<std::int32_t>(plan.solid) ||
            (plan.grip_buttons & hand.buttons) == 0) {
            continue;
        }
        const Pose& pose_W = poses_W_[plan.solid];
        grip_.solid = contact.solid;
        grip_.body = i;
        grip_.place_B = pose_W.inverse() * contact.position_W;
        grip_.turn_TB = hand.pose_W.orientation.conjugate() * pose_W.orientation;
    }
}

// Of what is held all the time.
void BodyStage::hold_on(const GrippingHand& hand) noexcept {
    const Body& body = bodies_[held_];
    hand_ = hand;
    grip_.force = {};
    if (!body.is_known || !body.told.is_present || putting_ != Putting::done) {
        grip_ = {};
        return;
    }
    grip_.solid = static_cast<std::int32_t>(body.plan.solid);
    grip_.body = held_;
    feel_grip(hand);
    if (!hand.feels) {
        grip_.force = {};
    }
}

GripForce BodyStage::grip(const ProxyContact& contact, const GrippingHand& hand) noexcept {
    if (held_ != kNothingHeld) {
        hold_on(hand);
        return grip_.force;
    }
    const bool was_gripped = grip_.solid >= 0;
    if (!was_gripped) {
        begin_grip(contact, hand);
    } else if (const Body& body = bodies_[grip_.body];
               (body.plan.grip_buttons & hand.buttons) == 0 || !body.told.is_present) {
        grip_.solid = kNoBody;
    }
    grip_.force = {};
    if (grip_.solid < 0 || !was_gripped) {
        // In its first round it is still the touch that is felt.
        return grip_.force;
    }
    feel_grip(hand);
    return grip_.force;
}

void BodyStage::feel_grip(const GrippingHand& hand) noexcept {
    const Body& body = bodies_[grip_.body];
    const Pose& pose_W = poses_W_[body.plan.solid];
    const Vector3 at_W = pose_W * grip_.place_B;
    const Twist& moves = body.told.velocity_W;
    const Vector3 velocity_W = rate_ * (moves.linear + moves.angular.cross(at_W - pose_W.position));
    const double k = body.slopes.stiffness_N_per_m;
    grip_.force.spring_W = k * (at_W - hand.pose_W.position);
    grip_.force.force_W =
        grip_.force.spring_W + body.slopes.damping_Ns_per_m * (velocity_W - hand.twist_W.linear);
    // Turned as it was in the hand.
    const double moment = body.plan.moment_kg_m2;
    PushSlopes slopes = body.slopes;
    slopes.turn_stiffness_Nm_per_rad = k * moment / body.plan.mass_kg;
    slopes.turn_damping_Nms_per_rad = 2.0 * std::sqrt(slopes.turn_stiffness_Nm_per_rad * moment);
    const Vector3 turn_W =
        compute_log(hand.pose_W.orientation * grip_.turn_TB * pose_W.orientation.conjugate());
    grip_.hold = {at_W,
                  {-grip_.force.force_W, slopes.turn_stiffness_Nm_per_rad * turn_W +
                                             slopes.turn_damping_Nms_per_rad *
                                                 (hand.twist_W.angular - rate_ * moves.angular)},
                  slopes,
                  {}};
    grip_.holds = true;
}

void BodyStage::begin_pushes(double now_s) noexcept {
    pushes_.stamp_s = now_s;
    pushes_.count = 0;
}

BodyHold& BodyStage::add_hold(const Body& body) noexcept {
    RigidPush& told = pushes_.pushes[static_cast<std::size_t>(pushes_.count++)];
    told.solid = static_cast<std::int32_t>(body.plan.solid);
    told.pose_W = poses_W_[body.plan.solid];
    told.velocity_W = {rate_ * body.told.velocity_W.linear, rate_ * body.told.velocity_W.angular};
    told.n_placements = body.told.n_placements;
    told.puts = false;
    return told.hold;
}

void BodyStage::add_push(const Body& body, const MostFelt& most, SolidPush push) noexcept {
    if (!push.touches || !body.told.is_present) {
        return;
    }
    // What presses nowhere, a couple alone, may not press.
    const bool presses = compute_length(push.normal_W) > 0.0;
    const Vector3 along_W = presses ? compute_direction(push.normal_W) : Vector3::UnitY();
    // A force that is cut off has no slope; that of its secant is enough to hold it.
    const double share = limit_push(most, push).force;
    BodyHold& told = add_hold(body);
    told = {push.at_W,
            {push.force_W, push.couple_W},
            body.slopes,
            {along_W, body.friction * std::max(along_W.dot(push.force_W), 0.0),
             presses ? most.force_N : 0.0, most.torque_Nm}};
    scale_slopes(told.slopes, {share, 1.0});
}

void BodyStage::publish() noexcept {
    if (channels_ != nullptr) {
        channels_->pushes.publish(pushes_);
    }
}

void BodyStage::tell_put() noexcept {
    if (!hand_.is_there) {
        return;
    }
    (void)add_hold(bodies_[held_]);
    RigidPush& told = pushes_.pushes[static_cast<std::size_t>(pushes_.count - 1)];
    told.pose_W = hand_.pose_W;
    told.puts = true;
    putting_ = putting_ == Putting::wanted ? Putting::asked : putting_;
}

void BodyStage::tell_grip(double most_N) noexcept {
    const Body& body = bodies_[grip_.body];
    const MostFelt most{most_N, most_N * std::sqrt(body.plan.moment_kg_m2 / body.plan.mass_kg)};
    BodyHold& told = add_hold(body);
    told = grip_.hold;
    SolidPush push{.touches = true,
                   .at_W = told.at_W,
                   .force_W = told.push_W.force,
                   .couple_W = told.push_W.torque};
    const PushShare left = limit_push(most, push);
    told.push_W = {push.force_W, push.couple_W};
    told.bounds.most_N = most.force_N;
    told.bounds.most_Nm = most.torque_Nm;
    scale_slopes(told.slopes, left);
}

// Touch and grip together give no more than the hand may feel: each its part of it.
void BodyStage::push(const ProxyContact& contact, const HandPush& hand, double now_s) noexcept {
    begin_pushes(now_s);
    const double touch_N = compute_length(hand.force_W);
    const double grip_N = grip_.holds ? compute_length(grip_.hold.push_W.force) : 0.0;
    const double sum_N = touch_N + grip_N;
    const double share = sum_N > hand.most_N ? hand.most_N / sum_N : 1.0;
    const double spare_N = hand.most_N - share * sum_N;
    for (const Body& body : bodies_) {
        const auto solid = static_cast<std::int32_t>(body.plan.solid);
        add_push(body, {.force_N = share * touch_N + spare_N},
                 compute_solid_push(contact, solid, hand.force_W, cursor_m_));
    }
    if (held_ != kNothingHeld && putting_ != Putting::done) {
        tell_put();
    } else if (grip_.solid >= 0 && grip_.holds) {
        tell_grip(held_ == kNothingHeld ? share * grip_N + spare_N : most_held_N_);
    }
    grip_.holds = false;
    publish();
}

void BodyStage::push_by_tool(std::span<const SolidPush> pushes, const MostFelt& most,
                             double now_s) noexcept {
    begin_pushes(now_s);
    for (const Body& body : bodies_) {
        SolidPush push = pushes[body.plan.solid];
        push.normal_W = push.force_W;
        add_push(body, most, push);
    }
    publish();
}

}  // namespace fulcrum
