// Moves a rigid body on by one step; five ways, chosen by name. h is the step, a = F/m, L the angular momentum in W,
// W(q, L) = R I^-1 R^T L the spin that belongs to it. Turns go by the exponential map of SO(3); q stays a unit quaternion.
//
//   explicit_euler       x' = x + h v,   q' = exp(h w) q,   v' = v + h a,  L' = L + h tau           all at the old state
//   semi_implicit_euler  v' = v + h a,  L' = L + h tau;   x' = x + h v',  q' = exp(h W(q, L')) q
//   verlet               position Verlet: half a drift, kick, half a drift. The drift turns the body freely: as a ball of its
//                        middle moment, which is exact, and about the axes of the least (half, at both ends) and the greatest
//                        by what 1/I_i exceeds 1/I_middle by: reversible and symplectic, |L| exact, and all of it exact
//                        where two moments are equal, so that a slender body gets no spin about itself. The kick takes the wrench at mid-step; forces that depend on velocity (dampers) need one there:
//                          start_of_step       v, W(q_mid, L): one evaluation; order 1 with damping, 2 without
//                          predicted_midpoint  v + h/2 a, likewise L, from a first evaluation: order 2
//   runge_kutta_4        Runge-Kutta-Munthe-Kaas: the classical four stages over (x, s, P, L) with q = exp(s) q_0,
//                        s' = w - [s] w / 2 + [s]^2 w / 12
//   backward_euler       x' = x + h v',  q' = exp(h w') q,  m v' = m v + h F(')  ,  L(q', w') = L + h tau(')
//                        Newton on the six unknowns (v', w'), all derivatives analytic (backward_euler.cpp). With
//                        newton_iterations = 1 it is one linear solve a step, as Otaduy & Lin do it.
// Order of convergence where loads are smooth: 1, 1, 2, 4, 1. The gyroscopic effect is in W(q, L), exactly.
//
// The default is backward Euler by full Newton, for what is held on a coupling and pressed on things: it stays stable at any
// stiffness, and it dissipates. A body that spins freely and must not lose energy wants verlet.
//
// Thread: that of the step. Cost: 0.1 to 3 us with a coupling (`fulcrum bench integrators`); no allocation.
// Source: M. Otaduy, M. Lin 2005, Stable and responsive six-degree-of-freedom haptic manipulation using implicit integration,
// World Haptics, sections 4.1, 4.2 (12 x 12 over momenta and quaternion; here reduced to 6 x 6). H. Munthe-Kaas 1998,
// Runge-Kutta methods on Lie groups, BIT 38. A. Dullweber, B. Leimkuhler, R. McLachlan 1997, Symplectic splitting methods for
// rigid body molecular dynamics, J. Chem. Phys. 107 (the split drift: a symmetric top and the rest). M. Tuckerman, B. Berne, G. Martyna 1992, J. Chem.
// Phys. 97 (position Verlet).
#pragma once

#include "haptics/base/error.h"
#include "haptics/dynamics/load.h"
#include "haptics/dynamics/rigid_state.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum {

enum class Integrator : std::uint8_t {
    explicit_euler,
    semi_implicit_euler,
    verlet,
    runge_kutta_4,
    backward_euler
};
inline constexpr std::array<Integrator, 5> kIntegrators{
    Integrator::explicit_euler, Integrator::semi_implicit_euler, Integrator::verlet,
    Integrator::runge_kutta_4, Integrator::backward_euler};

/// Which velocity Verlet gives to forces that depend on one.
enum class VerletVelocity : std::uint8_t { start_of_step, predicted_midpoint };

/// Fixed at load.
struct IntegratorSettings {
    Integrator integrator = Integrator::backward_euler;
    VerletVelocity verlet_velocity = VerletVelocity::predicted_midpoint;
    /// Backward Euler: solves and halvings a step at most, 1 to 100. 1 is the linearised step of Otaduy & Lin; smooth loads
    /// need 2 or 3, damped contacts that open and close within the step up to 8 solves and some halvings.
    int newton_iterations = 24;
    double newton_tolerance_m_per_s = 1.0e-9;  ///< the momentum still missing, over m; 1e-14 to 1
    double newton_tolerance_rad_per_s =
        1.0e-7;  ///< the same of L over the least moment; 1e-14 to 1
    /// Ways and turns too short for the loads to tell apart, as single precision places them, 0 to 1e-3: backward Euler ends where
    /// it can get no nearer. 0: by the tolerances alone.
    double least_way_m = 0.0;
    double least_turn_rad = 0.0;
};

/// How a step ended. After the last two the state is as it was before. Where a force jumps, as that of a damped contact
/// without a ramp, a step that ends at the jump may have no solution: its iterations are spent.
enum class StepStatus : std::uint8_t {
    done,  ///< explicit methods; backward Euler within its tolerances, or as near as the loads can tell
    iterations_spent,  ///< moved by the best guess; by the only one where newton_iterations is 1
    out_of_time,       ///< the loads had no time for another look (load.h): likewise
    singular,          ///< the linear system has no solution
    not_finite         ///< NaN or infinity in the state, the loads or the result
};

struct StepResult {
    StepStatus status = StepStatus::done;
    int n_solves = 0;  ///< linear solves; backward Euler makes at least one
    [[nodiscard]] bool moved() const noexcept {
        return status == StepStatus::done || status == StepStatus::iterations_spent ||
               status == StepStatus::out_of_time;
    }
};

/// "explicit Euler", "semi-implicit Euler", "Verlet", "RK4", "backward Euler".
[[nodiscard]] std::string_view to_string(Integrator integrator) noexcept;
/// The integrator of that name; an error that lists the names where there is none.
[[nodiscard]] Expected<Integrator> find_integrator(std::string_view name);
/// Refuses settings outside the ranges named above, NaN included.
[[nodiscard]] Expected<void> validate(const IntegratorSettings& settings);
/// Refuses inertia outside its ranges, NaN, and moments that no body has.
[[nodiscard]] Expected<void> validate(const Inertia& inertia);

/// Moves `state` from `time_s` by `dt_s` seconds under `load`. Settings and inertia are those that `validate` accepted;
/// `dt_s` may be 0 or more. A step that cannot be made leaves the state as it was and says so.
StepResult step_rigid_body(const IntegratorSettings& settings, const Inertia& inertia,
                           const Load& load, double time_s, double dt_s,
                           RigidState& state) noexcept;

// What that is made of: a free turn, and the two longer steps, which write their result to `next` and leave `state` alone.

/// Turns q freely for `dt_s`: with L / I_middle as a ball, and about the axes of the least and the greatest moment at the rates
/// L_i (1/I_i - 1/I_middle), forth and back so that it is reversible. L_W stays; seen from the body it turns back by the same angle.
[[nodiscard]] Quaternion compute_free_turn(const Inertia& inertia, const Quaternion& orientation,
                                           const Vector3& momentum_W, double dt_s) noexcept;

/// One Runge-Kutta-Munthe-Kaas step of order 4; four evaluations of the load.
void step_runge_kutta_4(const Inertia& inertia, const Load& load, double time_s, double dt_s,
                        const RigidState& state, RigidState& next) noexcept;

/// One backward Euler step by Newton. `next` counts only where the result says that it moved.
[[nodiscard]] StepResult step_backward_euler(const IntegratorSettings& settings,
                                             const Inertia& inertia, const Load& load,
                                             double time_s, double dt_s, const RigidState& state,
                                             RigidState& next) noexcept;

}  // namespace fulcrum
