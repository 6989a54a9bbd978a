// How far impulses and velocities are from fitting each other: zero for an answer, and small for one that is near.
//
//   contact:  w max |p - P(p - y / w)|,   y = u + R p,   P: p_n >= 0 and p_t within mu p_n      m/s
//   row:      w |p - P(p - y / w)|,       P: least <= p <= most                                in the unit of u
// the natural map, w the constraint's weight (contact_motion.h): where a contact pushes it is the velocity that is left, where
// it does not the velocity by which bodies approach. It does not matter how an answer was found, so all solvers are judged by it.
//
// Thread: that of the solver. Cost: some 60 multiplications a constraint.
// Source: J.-S. Pang 1997, Error bounds in mathematical programming, Math. Programming 79, section 6 (the natural map).
#pragma once

#include "haptics/constraint/contact_motion.h"
#include "haptics/constraint/contact_problem.h"
#include "haptics/constraint/friction_shape.h"

#include <cmath>
#include <span>

namespace fulcrum {

/// The greater; no number where either is none.
inline double take_worse(double a, double b) noexcept {
    return std::isnan(a) || b <= a ? a : b;
}

/// `y` along the axes, less the target; `impulse_Ns` as it is.
inline double compute_residual(FrictionShape shape, double friction, double weight,
                               const Vector3& y, const Vector3& impulse_Ns) noexcept {
    Vector3 nearest = impulse_Ns - y / weight;
    // Friction's bound is that of the impulse which is there.
    nearest.x() = std::max(impulse_Ns.x(), 0.0);
    clamp_friction(shape, friction, nearest);
    nearest.x() = std::max(impulse_Ns.x() - y.x() / weight, 0.0);
    const Vector3 away = impulse_Ns - nearest;
    return weight *
           take_worse(std::abs(away.x()), take_worse(std::abs(away.y()), std::abs(away.z())));
}
/// `y` less the target.
inline double compute_residual(const RowConstraint& row, double weight, double y,
                               double impulse) noexcept {
    const double nearest = std::clamp(impulse - y / weight, row.least, row.most);
    return weight * std::abs(impulse - nearest);
}

/// Sets every body's velocity to what the problem's impulses make of it, exactly: no momentum is lost.
void apply_impulses(ContactProblem& problem, BodyMotion& motion) noexcept;

/// The largest of all constraints, for the problem's impulses and velocities; no number where one of them is none. `friction`: the coefficient of each contact.
[[nodiscard]] double compute_residual(const ContactProblem& problem, FrictionShape shape,
                                      std::span<const double> friction) noexcept;

}  // namespace fulcrum
