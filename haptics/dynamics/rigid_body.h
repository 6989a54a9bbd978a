// A body that falls: state, and one step of free flight with air drag and a constant spin. See
// world.h for the law.
//
// Thread: the world loop. Cost: about 20 ns a step of a falling body.
#pragma once

#include "haptics/dynamics/world_plan.h"
#include "haptics/handover/messages.h"
#include "haptics/math/spatial.h"

#include <cstdint>

namespace fulcrum {

inline constexpr double kAirDensity_kg_per_m3 = 1.204;  ///< dry air at 20 degrees C and 1013 hPa

/// A body of the world while it runs.
struct RigidBody {
    // Fixed by the plan.
    double mass_kg = 1.0;
    double felt_mass_kg = 1.0;
    double radius_m = 0.05;
    double drag_per_m = 0.0;  ///< c = rho C_d A / 2m, one over metres
    // Flight.
    BodyWhere where = BodyWhere::hidden;
    Pose pose_W{};
    std::uint32_t n_placements = 0;  ///< how often it was put elsewhere at once
    Vector3 velocity_W{Vector3::Zero()};
    Vector3 spin_W{Vector3::Zero()};  ///< radians per second
    bool moving = false;              ///< falls, bounces or glides
    // Held.
    Pose pose_T{};                             ///< in the tool's frame
    Vector3 resting_place_T{Vector3::Zero()};  ///< where it glides to
};

/// The body of a plan, hidden.
[[nodiscard]] RigidBody make_rigid_body(const WorldBodyPlan& plan) noexcept;

/// v after `dt_s` of gravity and drag: (v + dt g) / (1 + dt c |v|).
[[nodiscard]] Vector3 compute_falling_velocity(const Vector3& velocity_W, const Vector3& gravity_W,
                                               double drag_per_m, double dt_s) noexcept;

/// Moves position, velocity and orientation on by `dt_s`.
void step_flight(RigidBody& body, const Vector3& gravity_W, double dt_s) noexcept;

/// sqrt(|g| / c) in metres per second; infinite without drag.
[[nodiscard]] double compute_terminal_speed_m_per_s(double gravity_m_per_s2,
                                                    double drag_per_m) noexcept;

}  // namespace fulcrum
