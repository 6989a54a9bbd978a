#include "haptics/tool/god_force.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

constexpr double kNothing_N = 1.0e-4;
constexpr double kNothing_Nm = 1.0e-6;
constexpr double kFarthest_m = 2.0e4;
constexpr double kUnit = 1.0e-6;  // how far a quaternion's length may be off

}  // namespace

Vector6 find_way(const Pose& from_W, const Pose& to_W) noexcept {
    Vector6 way;
    way << to_W.position - from_W.position,
        compute_log((to_W.orientation * from_W.orientation.conjugate()).normalized());
    return way;
}

bool is_place(const Pose& pose) noexcept {
    return is_finite(pose) && pose.position.cwiseAbs().maxCoeff() <= kFarthest_m &&
           std::abs(pose.orientation.norm() - 1.0) < kUnit;
}

bool is_place(const MovingFrame& frame) noexcept {
    return is_finite(frame) && is_place(frame.pose_W);
}

Pose go_along(const Pose& from_W, const Vector6& way) noexcept {
    Pose to{from_W.position + way.head<3>(), compute_exp(way.tail<3>()) * from_W.orientation};
    to.orientation.normalize();
    return to;
}

GodForce::GodForce(const GodForceSettings& settings, std::size_t max_contacts)
    : settings_(settings),
      solver_(settings.has_friction ? 0 : max_contacts),
      dragging_(settings.has_friction ? max_contacts : 0),
      normals_W_(settings.has_friction ? 0 : max_contacts),
      scale_(settings.stiffness_N_per_m / (settings.step_share * settings.inertia.mass_kg)) {}

void GodForce::begin(const Pose& tool_W) noexcept {
    tool_W_ = tool_W;
    is_solved_ = false;
    const Matrix3 inertia_W = compute_inertia_W(settings_.inertia, tool_W.orientation);
    if (settings_.has_friction) {
        dragging_.set_inertia(settings_.inertia.mass_kg, inertia_W);
        dragging_.clear();
        return;
    }
    solver_.set_inertia(settings_.inertia.mass_kg, inertia_W);
    solver_.clear();
}

bool GodForce::add(const Vector3& arm_W, const Vector3& normal_W, double least_m,
                   double friction) noexcept {
    is_solved_ = false;
    if (settings_.has_friction) {
        return dragging_.add(arm_W, normal_W, least_m, friction);
    }
    const std::size_t k = solver_.size();
    if (!solver_.add(arm_W, normal_W, least_m)) {
        return false;
    }
    normals_W_[k] = normal_W;
    return true;
}

Wrench GodForce::compute_held(const Pose& wanted_W) noexcept {
    if (size() == 0) {
        presses_ = false;
        return {};
    }
    const Vector6 wanted = settings_.step_share * find_way(tool_W_, wanted_W);
    if (is_solved_ && wanted == solved_for_) {
        // Asked again it would go on from its answer, and find one with other last digits, or where it is not exact another.
        return solved_;
    }
    const LeastConstraint& held =
        settings_.has_friction ? dragging_.solve(wanted) : solver_.solve(wanted);
    presses_ = held.acting > 0;
    is_solved_ = true;
    solved_for_ = wanted;
    solved_ = {scale_ * held.force.head<3>(), scale_ * held.force.tail<3>()};
    return solved_;
}

// What is taken of a push goes with the push, so that it never becomes a pull and a tool that is lifted comes off without sticking; what is added
// fades by itself.
Vector3 GodForce::find_carried(const Blended& blended, const Vector3& held, bool presses) noexcept {
    if (blended.size.dot(blended.of) >= 0.0) {
        return blended.size;
    }
    const double now = presses ? held.norm() : 0.0;
    const double then = blended.of.norm();
    return now < then ? Vector3(blended.size * (now / then)) : blended.size;
}

Wrench GodForce::compute(const Pose& wanted_W) noexcept {
    Wrench felt = compute_held(wanted_W);
    felt.force += find_carried(blended_.force, felt.force, presses_);
    felt.torque += find_carried(blended_.torque, felt.torque, presses_);
    return felt;
}

Vector3 GodForce::force_W(std::size_t k) const noexcept {
    if (!presses_) {
        return Vector3::Zero();
    }
    return settings_.has_friction ? Vector3(scale_ * dragging_.force_W(k))
                                  : Vector3(scale_ * solver_.force_N(k) * normals_W_[k]);
}

void GodForce::blend(const Wrench& before, const Pose& wanted_W, double dt_s,
                     bool is_near) noexcept {
    if (!is_near) {
        forget_blend();
        return;
    }
    const Wrench now = compute_held(wanted_W);
    double kept = settings_.fade_s > 0.0 ? std::exp(-dt_s / settings_.fade_s) : 0.0;
    free_s_ = size() == 0 ? free_s_ + dt_s : 0.0;
    if (free_s_ > kMayTouchAgain_s) {
        // Evenly, to nothing.
        const double left_s = kMayTouchAgain_s + settings_.fade_s - (free_s_ - dt_s);
        kept = std::min(kept, std::max(1.0 - dt_s / left_s, 0.0));
    }
    if (free_s_ >= kMayTouchAgain_s + settings_.fade_s) {
        kept = 0.0;
    }
    blended_.force = {kept * (before.force - now.force), now.force};
    blended_.torque = {kept * (before.torque - now.torque), now.torque};
    // What cannot be felt any more is nothing.
    if (!presses_ && blended_.force.size.norm() < kNothing_N &&
        blended_.torque.size.norm() < kNothing_Nm) {
        blended_ = {};
    }
}

}  // namespace fulcrum
