// The step path of axle.h.
#include "haptics/dynamics/axle.h"

#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

void move_evenly(double acceleration_rad_per_s2, double time_s, AxleState& state) noexcept {
    state.angle_rad += time_s * (state.spin_rad_per_s + 0.5 * time_s * acceleration_rad_per_s2);
    state.spin_rad_per_s += time_s * acceleration_rad_per_s2;
}

// While it turns friction brakes it, to a stop at most: what is left of the time then.
double turn_on(const AxleSettings& settings, double torque_Nm, double time_s,
               AxleState& state) noexcept {
    const double friction_Nm = std::copysign(settings.friction_Nm, state.spin_rad_per_s);
    const double acceleration = (torque_Nm - friction_Nm) / settings.inertia_kg_m2;
    const bool slows = acceleration * state.spin_rad_per_s < 0.0;
    const double stop_s =
        slows ? -state.spin_rad_per_s / acceleration : std::numeric_limits<double>::infinity();
    move_evenly(acceleration, std::min(time_s, stop_s), state);
    if (stop_s > time_s) {
        return 0.0;
    }
    state.spin_rad_per_s = 0.0;
    return time_s - stop_s;
}

}  // namespace

AxleSettings move_pivot(const AxleSettings& settings, const Vector3& pivot_B) noexcept {
    AxleSettings moved = settings;
    moved.pivot_B = pivot_B;
    const double before_m = compute_axle_distance_m(settings, settings.centre_B);
    const double after_m = compute_axle_distance_m(moved, settings.centre_B);
    moved.inertia_kg_m2 += settings.mass_kg * (after_m * after_m - before_m * before_m);
    return moved;
}

Vector3 compute_load_arm_W(const AxleSettings& settings, double angle_rad) noexcept {
    return compute_exp(angle_rad * settings.axis_W) * (settings.load_B - settings.pivot_B);
}

double compute_load_torque_Nm(const AxleSettings& settings, double angle_rad) noexcept {
    if (settings.load_N == 0.0) {
        return 0.0;
    }
    const Vector3 weight_W(0.0, -settings.load_N, 0.0);
    return settings.axis_W.dot(compute_load_arm_W(settings, angle_rad).cross(weight_W));
}

Pose compute_turned_pose(const AxleSettings& settings, double angle_rad,
                         const Pose& pose_W) noexcept {
    const Quaternion turn = compute_exp(angle_rad * settings.axis_W);
    return {pose_W.position + settings.pivot_B - turn * settings.pivot_B,
            turn * pose_W.orientation};
}

double compute_axle_energy_J(const AxleSettings& settings, const AxleState& state) noexcept {
    const double height_m = compute_load_arm_W(settings, state.angle_rad).y();
    return 0.5 * settings.inertia_kg_m2 * state.spin_rad_per_s * state.spin_rad_per_s +
           settings.load_N * height_m;
}

void step_axle(const AxleSettings& settings, double torque_Nm, double dt_s,
               AxleState& state) noexcept {
    if (!(dt_s > 0.0) || !std::isfinite(dt_s)) {
        return;
    }
    const double halfway_rad = state.angle_rad + 0.5 * dt_s * state.spin_rad_per_s;
    const double total_Nm = (std::isfinite(torque_Nm) ? torque_Nm : 0.0) +
                            compute_load_torque_Nm(settings, halfway_rad);
    double left_s = dt_s;
    if (state.spin_rad_per_s != 0.0) {
        left_s = turn_on(settings, total_Nm, left_s, state);
    }
    // From rest, where friction does not hold it.
    if (left_s > 0.0 && std::abs(total_Nm) > settings.friction_Nm) {
        move_evenly(
            (total_Nm - std::copysign(settings.friction_Nm, total_Nm)) / settings.inertia_kg_m2,
            left_s, state);
    }
    // The ends of its range.
    if (state.angle_rad < settings.lowest_rad || state.angle_rad > settings.highest_rad) {
        state.angle_rad = std::clamp(state.angle_rad, settings.lowest_rad, settings.highest_rad);
        state.spin_rad_per_s = 0.0;
    }
}

}  // namespace fulcrum
