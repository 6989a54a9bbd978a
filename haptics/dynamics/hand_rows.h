// A hand that holds a body, as rows of the contact problem of the body's island.
//
//   p = h (F - h k u_before) - G (u - u_before)            u: how fast the place that is held moves along an axis; p: the hand's impulse
//   G = h^2 k + h b + m                                    m: of a damper that knows the velocity late
// The spring k and damper b of the hand pull with F where the step begins; an implicit step has them answer what the body does in it:
// h k u at its end, and what it is sped up, with this virtual mass, which is against the hand alone. So a hand that stands takes energy and
// gives none, however old its push. What else pushes the body, or hits it, moves its own mass.
//   a push     along the unit vector n:    0 <= p;    across it, where friction holds it: |p| <= h friction_N
//   a grip     along three axes;           of both |p| <= h most_N
//   a couple   about three axes, with k_turn, b_turn, no m: |p| <= h most_Nm
// Along n a push has two rows, for h^2 k and for h b + m, with their shares of F; the second gives no more than twice its share. So no hand
// gives more in a step than it may feel, however it lies to the axes; a push never draws, and what is touched without force meets its
// spring alone. A force beyond its bounds counts as the nearest within. As rows: J v - (J v_before + h (F - h k u_before) / G) + p / G = 0 between
// bounds of their own, which are drawn in where the answer's length is more than it may (island_solver.h).
//
// Thread: that of the island. Cost: 20 ns a row; no allocation.
// Source: an implicit spring as a soft bounded constraint: E. Catto 2011, Soft constraints, Game Developers Conference.
#pragma once

#include "haptics/constraint/contact_problem.h"
#include "haptics/dynamics/rigid_state.h"
#include "haptics/handover/rigid_messages.h"

#include <array>

namespace fulcrum {

inline constexpr int kMostHandRows = 7;

/// Rows whose impulses together are no longer than `most`.
struct HandBall {
    int first = 0;
    int count = 0;
    int n_along = 0;  ///< of them, the first: along one axis, which add up
    double most = 0.0;
};

struct HandRows {
    std::array<RowConstraint, kMostHandRows> rows{};
    int count = 0;
    std::array<HandBall, 3> balls{};  ///< what a push holds across, all of a force, a couple
};

/// Of a body in this state; all finite, slopes and bounds 0 or more, `dt_s` above 0. The rows' body_b is left to the caller.
[[nodiscard]] HandRows make_hand_rows(const BodyHold& hold, const Inertia& inertia,
                                      const RigidState& state, double dt_s) noexcept;

/// What a hand that stands still gives once the body has gone on, and where it holds it then.
void carry_hold(const RigidState& before, const RigidState& after, BodyHold& hold) noexcept;

}  // namespace fulcrum
