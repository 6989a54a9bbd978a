// How far friction holds a point back that lies against a few planes.
//
// In lengths (forces over the coupling's stiffness k) the hand h pulls the point x, and each plane i gives a push l_i along its
// normal n_i and a drag f_i along itself:
//   x = h + sum_i (l_i n_i + f_i)
//   l_i >= 0,   n_i . (x - p_i) >= 0,   one of them zero                         it pushes only where it is touched
//   s_i = P_i (x - a_i)                                                          the slip over what was under it, P_i = I - n n^T
//   stuck:    s_i = 0 and |f_i| <= mu_s l_i
//   sliding:  f_i = -(mu_d l_i + beta |s_i|) s_i / |s_i|,   beta = b / (k T)     viscous part, backward in time: never overshoots
// A plane that slid keeps the dynamic circle until the drag that would hold it fits within it: the two states of the friction
// cone. One plane is solved in closed form. Of several, all pushes are solved together and exactly (plane_constraints.h), and the
// drags one after the other, each as if the point would follow it freely along its plane:
//   t = s_i - f_i;   |t| <= circle_i: f_i = -t,   else f_i = -t/|t| (mu_d l_i + beta |t|) / (1 + beta)
// The point follows by a projection of what it is given, so each step is one of steepest descent no longer than that
// allows, and the circles move with the pushes. (With the pushes in the same sweep as the drags two planes need a hundred rounds where this
// needs two or three: the drag along a plane and the push of its neighbour fight for the same direction.)
// What the rounds leave is never felt as a leak: where the point goes then, the pushes are solved anew.
//
// Thread: haptic loop. Cost: 20 ns on one plane, some 100 ns a plane and round on several; no allocation.
// Source: N. Melder, W. Harwin 2002, Improved haptic rendering for multi-finger manipulation using friction cone based
// god-objects, Eurohaptics; A. Barrow, W. Harwin, section 4.2 (surface object, friction circle). Several planes, one after the other: F. Jourdan, P. Alart,
// M. Jean 1998, A Gauss-Seidel like algorithm to solve frictional contact problems, Comput. Methods Appl. Mech. Engrg. 155.
#pragma once

#include "haptics/math/spatial.h"
#include "haptics/surface/friction.h"

#include <span>

namespace fulcrum {

/// Friction of one surface, in lengths.
struct FrictionLaw {
    double static_coefficient = 0.0;
    double dynamic_coefficient = 0.0;
    double viscous_ratio = 0.0;  ///< beta

    [[nodiscard]] bool any() const noexcept {
        return static_coefficient > 0.0 || dynamic_coefficient > 0.0 || viscous_ratio > 0.0;
    }
};

/// With a coupling of that stiffness (0: no viscous part), in rounds of `period_s`.
[[nodiscard]] FrictionLaw make_friction_law(const FrictionSettings& settings,
                                            double stiffness_N_per_m, double period_s) noexcept;

/// One plane that may hold the point.
struct FrictionPlane {
    Vector3 normal{Vector3::UnitY()};  ///< unit, away from the surface
    Vector3 point{Vector3::Zero()};    ///< p_i
    Vector3 anchor{Vector3::Zero()};   ///< a_i
    FrictionLaw law{};
    bool was_stuck = true;          ///< before: the static circle holds it, else the dynamic one
    bool stuck = true;              ///< out
    double push_m = 0.0;            ///< out: l_i
    Vector3 drag{Vector3::Zero()};  ///< out: f_i
};

/// Of what is held at rest the static one, else the dynamic one.
[[nodiscard]] double find_coefficient(const FrictionPlane& plane) noexcept;

/// Fills in what each plane does. Returns the largest change of the last round, metres: 0 when it is solved exactly.
double solve_friction(const Vector3& hand, std::span<FrictionPlane> planes,
                      int max_rounds) noexcept;

}  // namespace fulcrum
