// A body that turns about an axis fixed in the world, and nothing else: a wheel, a globe, a lever.
//
//   I a = tau + tau_load(theta) - sign(spin) tau_f          spin not 0
//   I a = T - sign(T) tau_f,  T = tau + tau_load            spin 0 and |T| > tau_f; otherwise it stands
//   tau_load(theta) = a . (R(theta) r_load x (0, -W, 0))     a weight W that hangs at r_load from the pivot
//   I(p) = I(p0) + m (|a x (c - p)|^2 - |a x (c - p0)|^2)    on another pivot p than p0; c the centre of mass (Huygens, Steiner)
// The body's own weight turns nothing: where it should, it hangs as the load.
// A step of h holds the torque: tau_load is taken half-way, theta + h/2 spin. For that torque the step is exact, the moment
// at which friction stops the body included: theta + h spin + h^2 a/2, spin + h a. So spin and angle under a constant torque
// have no error but rounding, friction takes tau_f |angle| to the last digit, and with a hanging weight the step is the
// leapfrog, whose energy stays in bounds (order 2) however long it swings.
// At an end of its range it stops dead: the end takes what energy there is.
//
// Thread: any. Cost: 30 ns; with a hanging weight 60 ns. No allocation.
// Source: Coulomb's friction as a set-valued torque, e.g. R. Leine, H. Nijmeijer 2004, Dynamics and Bifurcations of
// Non-Smooth Mechanical Systems, section 5.2; leapfrog: E. Hairer, C. Lubich, G. Wanner 2006, Geometric Numerical
// Integration, section I.1.4. The exact step with its stop is derived above.
#pragma once

#include "haptics/base/error.h"
#include "haptics/math/length.h"
#include "haptics/math/spatial.h"

namespace fulcrum {

/// The range of angles of an axle without ends.
inline constexpr double kAnyAngle_rad = 1.0e9;
/// From a body's origin, of pivot, load and centre of mass.
inline constexpr double kFarthestOnAxle_m = 100.0;
inline constexpr double kLeastAxleInertia_kg_m2 = 1.0e-4;
inline constexpr double kMostAxleInertia_kg_m2 = 1.0e6;
inline constexpr double kMostAxleMass_kg = 1.0e4;
inline constexpr double kMostAxleFriction_Nm = 1.0e6;
inline constexpr double kMostAxleLoad_N = 1.0e6;

/// Places are from the body's origin as it lies at angle 0, along the world's axes, however its own lie then.
struct AxleSettings {
    Vector3 axis_W{Vector3::UnitZ()};    ///< unit; it turns counter-clockwise about it
    Vector3 pivot_B{Vector3::Zero()};    ///< a point of the axis
    double inertia_kg_m2 = 0.1;          ///< about the axis through the pivot
    double mass_kg = 0.0;                ///< 0: the same inertia on every pivot
    Vector3 centre_B{Vector3::Zero()};   ///< of mass
    double friction_Nm = 0.0;            ///< of its bearing
    double lowest_rad = -kAnyAngle_rad;  ///< below `highest_rad`
    double highest_rad = kAnyAngle_rad;
    double load_N = 0.0;              ///< a weight, downwards
    Vector3 load_B{Vector3::Zero()};  ///< where it hangs
};

struct AxleState {
    double angle_rad = 0.0;
    double spin_rad_per_s = 0.0;
};

/// Refuses settings outside the limits above, numbers below 0, an axis that is not of length one, NaN.
[[nodiscard]] Expected<void> validate(const AxleSettings& settings);

/// How far a place lies from the axis.
[[nodiscard]] inline double compute_axle_distance_m(const AxleSettings& settings,
                                                    const Vector3& place_B) noexcept {
    return compute_length(settings.axis_W.cross(place_B - settings.pivot_B));
}
/// The same body on another pivot, its inertia that about it.
[[nodiscard]] AxleSettings move_pivot(const AxleSettings& settings,
                                      const Vector3& pivot_B) noexcept;

/// Where the weight hangs at that angle, from the pivot, along the world's axes.
[[nodiscard]] Vector3 compute_load_arm_W(const AxleSettings& settings, double angle_rad) noexcept;
/// The hanging weight's torque about the axis at that angle.
[[nodiscard]] double compute_load_torque_Nm(const AxleSettings& settings,
                                            double angle_rad) noexcept;
/// The torque about the axis of a force at a place, for a pivot at `pivot_W`: axis . (r x F).
[[nodiscard]] inline double compute_axle_torque_Nm(const AxleSettings& settings,
                                                   const Vector3& pivot_W, const Vector3& at_W,
                                                   const Vector3& force_W) noexcept {
    return settings.axis_W.dot((at_W - pivot_W).cross(force_W));
}
/// Where a body is that stands at `pose_W` at angle 0 and is turned to `angle_rad`.
[[nodiscard]] Pose compute_turned_pose(const AxleSettings& settings, double angle_rad,
                                       const Pose& pose_W) noexcept;
/// Kinetic energy and that of the hanging weight, which is 0 at the height of the pivot.
[[nodiscard]] double compute_axle_energy_J(const AxleSettings& settings,
                                           const AxleState& state) noexcept;

/// Moves on by `dt_s` under a torque about the axis. A dt that is not above 0 and finite moves nothing; a torque that is
/// not finite is none.
void step_axle(const AxleSettings& settings, double torque_Nm, double dt_s,
               AxleState& state) noexcept;

}  // namespace fulcrum
