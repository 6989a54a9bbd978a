// What dampers between a hand and what it touches add to the springs of a contact.
//
// Plane i has the unit normal n_i, away from the surface, and is pushed with q_i by its spring; friction holds the spring's part T_i along it. u_i:
// velocity of the hand against the solid's own matter there, never against a proxy, which has no mass and jumps wherever the set
// of its planes changes, at each edge and each slip. While that set stays the springs' rate is d/dt sum q_i n_i = -K w with
//   w in the span of the n_i,   n_i . w = n_i . u_i                 the hand's velocity, less what leads along all planes
// and a damper beside them asks for -b w (b: the planes', weighed by their pushes). No plane pulls, so the hand gets
//   sum N_i n_i,  N_i >= 0:  what lies nearest to  sum q_i n_i - b w  in the cone of the normals
//   t_i = T_i - (b_i / m) (u_i - n_i (n_i . u_i)), shortened to mu_i N_i + max(|T_i| - mu_i q_i, 0)      m planes with friction
// So nothing is asked along a surface without friction, the force lies where the normals are, shaded ones too, and friction stays in its
// cone, with what is viscous in it. Planes whose normals are one to 1e-3 are one plane, of all their pushes and drags: at the edge of an even
// mesh, where a proxy leans on two faces, how these share the push is chance, and a circle about either's share would let through as much again.
//
// Passive for solids at rest: u = u_i, and w is the projection of u. A projection onto a convex set that holds S = sum q_i n_i gives
// (F - S) . (-b w) >= |F - S|^2, and F - S lies in the span, so what is added takes at least |F - S|^2 / b from the hand. Likewise along a
// plane as long as its disc holds T_i; where a plane is pushed less than by its spring it may not, and friction takes less than the spring
// claims, by `eased_W`: that much is the passivity stage's to count (passivity.h), or lent (contact_stage.h). Sampled, the line is that of Colgate
// and Schenkel along each direction of the span, as for one wall: b > K T / 2.
//
// Thread: haptic loop. Cost: about 10 ns for one plane, 100 ns for more; no allocation.
// Source: derived here. J. J. Moreau 1962, Decomposition orthogonale d'un espace hilbertien selon deux cones mutuellement polaires, C. R.
// Acad. Sci. 255 (the nearest in a cone, by the nearest in front of planes); J. E. Colgate, G. Schenkel 1997, Passivity of a class of
// sampled-data systems, J. Robotic Systems 14(1).
#pragma once

#include "haptics/math/spatial.h"

#include <span>

namespace fulcrum {

/// One plane that holds the proxy, in world axes.
struct DampedPlane {
    Vector3 normal_W{Vector3::UnitY()};   ///< n: unit, away from the surface
    double push_N = 0.0;                  ///< q: of the spring along it, 0 or more
    Vector3 drag_N_W{Vector3::Zero()};    ///< T: of the spring along the plane, newtons
    double friction_coefficient = 0.0;    ///< mu
    Vector3 velocity_W{Vector3::Zero()};  ///< u: of the hand against the solid, m/s
    double damping_Ns_per_m = 0.0;        ///< b
};

struct ContactDamping {
    /// All normal and tangential forces less the springs' own sum of q_i n_i + T_i: newtons on the hand.
    Vector3 force_W{Vector3::Zero()};
    /// What of it is no damper's: planes that are pushed less than by their springs hold less of T_i.
    Vector3 eased_W{Vector3::Zero()};
};
/// At most three planes.
[[nodiscard]] ContactDamping compute_contact_damping(std::span<const DampedPlane> planes) noexcept;

}  // namespace fulcrum
