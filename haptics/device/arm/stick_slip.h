// Velocities of joints after a step in which dry friction and stops act: what sticks stands, exactly.
//
//   minimise over w:   w^T A w / 2 - b^T w + sum f_i |w_i|       low_i <= w_i <= high_i, low_i <= 0 <= high_i
// Its optimum says, with the impulse r = A w - b that friction and stop give joint i:
//   w_i > 0 within its bounds: r_i = -f_i      w_i < 0: r_i = f_i      w_i = 0: |r_i| <= f_i
//   at a stop:                 r_i beyond friction, away from the stop
// A is positive definite, so there is exactly one w. No velocity is "almost zero": nothing is regularised, so a joint held by
// friction does not creep, and does not chatter.
// First the sets of the last step are tried (which joints slide, stick or lie at a stop): one triangular solve, and if all
// conditions hold, that is the optimum, proved. If not, sets are mended a few times; then coordinate after coordinate is
// minimised, which converges for such a function whatever A is.
//
// Thread: any. Cost: 0.5 us for seven joints when the sets hold.
// Source: J. Moreau 1988, Unilateral contact and dry friction in finite freedom dynamics: velocities after a step as a convex
// minimum. P. Tseng 2001, Convergence of a block coordinate descent method for nondifferentiable minimization, J. Optimization
// Theory and Applications 109(3), theorem 4.1.
#pragma once

#include "haptics/device/arm/arm_model.h"

#include <array>
#include <cstdint>

namespace fulcrum {

struct StickSlipProblem {
    JointMatrix inertia;    ///< A, n x n, symmetric and positive definite
    JointVector push;       ///< b
    JointVector dry;        ///< f, 0 or more
    JointVector low, high;  ///< bounds of w
};

/// What a joint does.
enum class JointHold : std::uint8_t { forward, backward, stuck, at_low, at_high };
using JointHolds = std::array<JointHold, kMostJoints>;

struct StickSlipCount {
    int tries = 0;   ///< of sets
    int sweeps = 0;  ///< over the coordinates, 0 when a set was right
};

/// The optimum. `holds` are the sets to begin with, and those found.
StickSlipCount solve_stick_slip(const StickSlipProblem& problem, JointHolds& holds,
                                JointVector& w) noexcept;

/// By how much `w` misses the conditions above, in the unit of `push`; 0 at the optimum.
[[nodiscard]] double compute_stick_slip_residual(const StickSlipProblem& problem,
                                                 const JointVector& w) noexcept;

}  // namespace fulcrum
