// The step path of kite_flight.h.
#include "haptics/flight/kite_flight.h"

#include "haptics/dynamics/rigid_body.h"
#include "haptics/flight/kite_load.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// K for a spine that leans into the wind by `lean_rad`: front upwind and down, as it flies.
Quaternion compute_attitude(const WindSettings& wind, double lean_rad) noexcept {
    const Vector3 up = Vector3::UnitY();
    const Vector3 upwind = -wind.downwind_W;
    const Vector3 spine = std::cos(lean_rad) * up + std::sin(lean_rad) * upwind;
    const Vector3 front = std::cos(lean_rad) * upwind - std::sin(lean_rad) * up;
    Matrix3 R;
    R << spine.cross(front), spine, front;
    return Quaternion(R);
}

}  // namespace

void KiteFlight::launch(const Vector3& hand_W, double elevation_rad, double lean_rad) noexcept {
    if (!is_finite(hand_W) || !std::isfinite(elevation_rad) || !std::isfinite(lean_rad)) {
        return;
    }
    const Vector3 along_W = std::cos(elevation_rad) * settings_.wind.downwind_W +
                            std::sin(elevation_rad) * Vector3::UnitY();
    const Vector3 knot_W = hand_W + line_.length_m() * along_W;
    line_.lay(hand_W, knot_W);
    state_ = {};
    state_.pose_W.orientation = compute_attitude(settings_.wind, lean_rad) * kite_.X_KB.orientation;
    state_.pose_W.position = knot_W - state_.pose_W.orientation * kite_.knot_B;
    describe(compute_wind_W(settings_.wind, gusts_, state_.pose_W.position));
}

void KiteFlight::set_wind_speed_m_per_s(double speed_m_per_s) noexcept {
    if (std::isfinite(speed_m_per_s)) {
        settings_.wind.speed_m_per_s = std::clamp(speed_m_per_s, 0.0, kFastestWind_m_per_s);
    }
}

void KiteFlight::step(double dt_s, const Vector3& hand_W) noexcept {
    if (!(dt_s > 0.0) || !std::isfinite(dt_s) || !is_finite(hand_W)) {
        return;
    }
    if (n_steps_ == 0) {
        step_gusts(settings_.wind, state_.pose_W.position.y() - settings_.wind.ground_m,
                   settings_.steps_a_gust * dt_s, gusts_);
    }
    n_steps_ = (n_steps_ + 1) % settings_.steps_a_gust;
    const Vector3 wind_W = compute_wind_W(settings_.wind, gusts_, state_.pose_W.position);
    report_.air_way_m += settings_.wind.speed_m_per_s * dt_s;
    const Vector3 gravity_W(0.0, -settings_.gravity_m_per_s2, 0.0);
    const LinePull pull = line_.begin_step(hand_W, dt_s, {gravity_W, settings_.wind, gusts_});
    move_kite(dt_s, pull, wind_W);
    line_.end_step(state_.pose_W * kite_.knot_B);
    if (compute_length(line_.end_force_W()) > line_.settings().strength_N) {
        line_.snap();
    }
    describe(wind_W);
}

void KiteFlight::move_kite(double dt_s, const LinePull& pull, const Vector3& wind_W) noexcept {
    const KiteAirLoad air(kite_, wind_W, kAirDensity_kg_per_m3);
    const ConstantLoad weight(
        {.force = Vector3(0.0, -settings_.gravity_m_per_s2 * kite_.inertia.mass_kg, 0.0)});
    const LinePullLoad line(kite_.knot_B, pull);
    const PlaneContactsLoad ground(corners_);
    const Loads<KiteAirLoad, ConstantLoad, LinePullLoad, PlaneContactsLoad> loads(air, weight, line,
                                                                                  ground);
    if (!step_rigid_body(integrator_, kite_.inertia, loads, 0.0, dt_s, state_).moved()) {
        ++report_.n_failed;
        state_.velocity_W = {};
    }
}

void KiteFlight::describe(const Vector3& wind_W) noexcept {
    report_.pose_W = state_.pose_W * kite_.X_KB.inverse();
    report_.centre_W = state_.pose_W.position;
    report_.knot_W = state_.pose_W * kite_.knot_B;
    report_.weight_W = {0.0, -settings_.gravity_m_per_s2 * kite_.inertia.mass_kg, 0.0};
    report_.tension_W = line_.end_force_W();
    report_.hand_force_W = line_.hand_force_W();
    report_.line_m = line_.length_m();
    report_.is_snapped = line_.is_snapped();
    report_.wind_W = wind_W;
    report_.velocity_W = state_.velocity_W.linear;
    // The air's force along and across its stream, and the height on the spine at which it acts.
    Wrench air_W;
    KiteAirLoad(kite_, wind_W, kAirDensity_kg_per_m3).add_wrench(state_, 0.0, air_W);
    const Vector3 stream_W = compute_direction(Vector3(wind_W - state_.velocity_W.linear));
    report_.drag_W = air_W.force.dot(stream_W) * stream_W;
    report_.lift_W = air_W.force - report_.drag_W;
    const Vector3 spine_W = report_.pose_W.orientation * Vector3::UnitY();
    const Vector3 front_W = report_.pose_W.orientation * Vector3::UnitZ();
    const double across_N = air_W.force.dot(front_W);
    constexpr double kLeast_N = 1.0e-6;
    const Vector3 side_W = spine_W.cross(front_W);
    const double up_m = std::abs(across_N) > kLeast_N ? air_W.torque.dot(side_W) / across_N : 0.0;
    report_.pressure_W = report_.centre_W + up_m * spine_W;
    report_.angle_of_attack_rad = std::acos(std::clamp(-stream_W.dot(spine_W), -1.0, 1.0));
}

}  // namespace fulcrum
