#include "haptics/tool/god_object/god_force.h"

#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

namespace {

constexpr double kNothing_N = 1.0e-4;
constexpr double kNothing_Nm = 1.0e-6;
// A set turns what it holds, by v dt over a radius of curvature, where it changes it by no more than this share, and its size by no more than that.
constexpr double kTurns = 0.4;
constexpr double kKeeps = 0.1;
constexpr double kTurnsTorque = 0.05;
constexpr double kEndsAway_s = 0.01;
constexpr double kFarthest_m = 2.0e4;
constexpr double kUnit = 1.0e-6;  // how far a quaternion's length may be off

// What of a change is not felt at once.
Vector3 find_lost(const Vector3& before, const Vector3& now, double turns) noexcept {
    const Vector3 lost = before - now;
    const double size = before.norm();
    const bool is_turned =
        lost.norm() <= turns * size && std::abs(now.norm() - size) <= kKeeps * size;
    return is_turned ? Vector3(Vector3::Zero()) : lost;
}

// What ends evenly within a time, of what it was a step ago: it has been ending for so long, or not yet.
double find_share_left(double ending_s, double ends_s, double dt_s) noexcept {
    return ending_s <= 0.0 ? 1.0 : std::max(1.0 - dt_s / (ends_s + dt_s - ending_s), 0.0);
}

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
        is_exact_ = true;
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
    is_exact_ = held.exact;
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

Wrench GodForce::limit(const Wrench& wrench) const noexcept {
    return {limit_length(wrench.force, settings_.most_N),
            limit_length(wrench.torque, settings_.most_Nm)};
}

void GodForce::keep(const Pose& wanted_W) noexcept {
    kept_held_ = limit(compute_held(wanted_W));
    kept_ = {find_carried(blended_.force, kept_held_.force, presses_),
             find_carried(blended_.torque, kept_held_.torque, presses_)};
}

Wrench GodForce::compute(const Pose& wanted_W) noexcept {
    Wrench felt = limit(compute_held(wanted_W));
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

void GodForce::blend(const Pose& wanted_W, double dt_s, bool is_near) noexcept {
    const Wrench now = limit(compute_held(wanted_W));
    free_s_ = size() == 0 ? free_s_ + dt_s : 0.0;
    away_s_ = is_near ? 0.0 : away_s_ + dt_s;
    const double kept =
        settings_.fade_s > 0.0
            ? std::min({std::exp(-dt_s / settings_.fade_s),
                        find_share_left(free_s_ - kMayTouchAgain_s, settings_.fade_s, dt_s),
                        find_share_left(away_s_, kEndsAway_s, dt_s)})
            : 0.0;
    const auto fade = [&](const Vector3& carried, const Vector3& lost) {
        return Vector3(kept * (carried + lost));
    };
    blended_.force = {fade(kept_.force, find_lost(kept_held_.force, now.force, kTurns)), now.force};
    blended_.torque = {fade(kept_.torque, find_lost(kept_held_.torque, now.torque, kTurnsTorque)),
                       now.torque};
    // What cannot be felt any more is nothing.
    if (!presses_ && blended_.force.size.norm() < kNothing_N &&
        blended_.torque.size.norm() < kNothing_Nm) {
        blended_ = {};
    }
}

}  // namespace fulcrum
