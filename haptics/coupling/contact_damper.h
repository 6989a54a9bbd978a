// What dampers between a hand and what it touches add to the springs of a contact.
//
// Plane i has the unit normal n_i, away from the surface, and is pushed with q_i by its spring; friction holds the spring's part T_i along it,
// of T_i,most = mu q_i at most. u_i: velocity of the hand against the solid's own matter there, never against a proxy, which has no mass
// and jumps wherever the set of its planes changes, at each edge and each slip.
//   N_i = max(q_i - (b_i / g) n_i . u_i, 0)                               g = max over i of the sum over j of |n_i . n_j|
//   t_i = T_i - (b_i / m) (u_i - n_i (n_i . u_i)),  shortened to (T_i,most / q_i) N_i                  m planes
//   F   = sum of N_i n_i + t_i
// Along the normals this is what the spring's own rate gives while the planes stay the same: with F = K P s and P the projector on the span
// of the n_i, dF/dt = -K P u. A plane alone has g = 1; planes at right angles have P; of two that are nearly one, as in a shallow valley, sum
// of n_i n_i^T is twice that of one, and g takes it back: (1/g) sum of n_i n_i^T never has an eigenvalue above 1 (Gershgorin's circles
// of the Gram matrix). So nothing is asked along a surface without friction, and the force lies where the normals are, shaded ones too.
// Along it the damper holds with friction, and no more than friction may: what slides stays on the circle mu N_i.
//
// Passive: what is added gives the hand  - (b_i / g) (n_i . u_i)^2  while plane i pushes. Where N_i is cut off at 0 it takes q_i from a hand that
// leaves faster than (g / b_i) q_i, less than that damper would. Along the plane t_i - T_i is the step of a projection onto a disc that T_i
// lies in, so (t_i - T_i) . u_i <= 0; where N_i < q_i the disc may be smaller than T_i, and friction takes less, as of a lighter push.
// Sampled, held for T and with u known late, the line is that of Colgate and Schenkel along each n_i as for one wall: b > K T / 2
// (passivity.h counts what is beyond it).
//
// Thread: haptic loop. Cost: about 10 ns a plane, no allocation.
// Source: derived here. J. E. Colgate, G. Schenkel 1997, Passivity of a class of sampled-data systems, J. Robotic Systems 14(1), for the
// sampled wall; S. A. Gerschgorin 1931, Ueber die Abgrenzung der Eigenwerte einer Matrix, Izv. Akad. Nauk SSSR 6.
#pragma once

#include "haptics/math/spatial.h"

#include <span>

namespace fulcrum {

/// One plane that holds the proxy, in world axes.
struct DampedPlane {
    Vector3 normal_W{Vector3::UnitY()};  ///< n: unit, away from the surface
    double push_N = 0.0;                 ///< q: of the spring along it, 0 or more
    Vector3 drag_N_W{Vector3::Zero()};   ///< T: of the spring along the plane, newtons
    double most_drag_N = 0.0;  ///< T_most: that friction holds at this push; 0 without friction
    Vector3 velocity_W{Vector3::Zero()};  ///< u: of the hand against the solid, m/s
    double damping_Ns_per_m = 0.0;        ///< b
};

/// F less the springs' own sum of q_i n_i + T_i: newtons on the hand. No plane ever pulls.
[[nodiscard]] Vector3 compute_contact_damping(std::span<const DampedPlane> planes) noexcept;

}  // namespace fulcrum
