// A hand that holds a body, as rows of the contact problem of the body's island.
//
//   p = h F - G (u - u_before),   least <= p <= most        u: how fast the place that is held moves along an axis; p: the hand's impulse
//   G = h^2 k + h b + m           m: of a damper that knows the velocity late
// The spring k and damper b of the hand pull with F where the step begins; what the body does in the step, an implicit step has them answer
// with this virtual mass, which is against the hand alone. What else pushes the body, or hits it, moves its own mass.
//   a push     along the unit vector n:    0 <= p <= h most_N;    across it, where friction holds it: |p| <= h friction_N
//   a grip     along three axes:           |p| <= h most_N
//   a couple   about three axes, with k_turn, b_turn, no m: |p| <= h most_Nm of a grip, h |couple| of a push
// So no hand gives more in a step than it may feel, a push never draws, and what is touched without force falls freely. A force that is
// greater than its bound counts as the bound. As rows: J v - (J v_before + h F / G) + p / G = 0 between the bounds.
//
// Thread: that of the island. Cost: 20 ns a row; no allocation.
// Source: an implicit spring as a soft bounded constraint: E. Catto 2011, Soft constraints, Game Developers Conference.
#pragma once

#include "haptics/constraint/contact_problem.h"
#include "haptics/dynamics/rigid_state.h"
#include "haptics/handover/rigid_messages.h"

#include <array>

namespace fulcrum {

inline constexpr int kMostHandRows = 6;

struct HandRows {
    std::array<RowConstraint, kMostHandRows> rows{};
    int count = 0;
};

/// Of a body in this state; all finite, slopes and bounds 0 or more, `dt_s` above 0. The rows' body_b is left to the caller.
[[nodiscard]] HandRows make_hand_rows(const BodyHold& hold, const Inertia& inertia,
                                      const RigidState& state, double dt_s) noexcept;

}  // namespace fulcrum
