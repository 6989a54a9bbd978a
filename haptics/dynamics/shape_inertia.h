// Mass, centre of mass and inertia of a body of even density, from its shape.
//
//   sphere    m = d 4/3 pi r^3,  I = 2/5 m r^2
//   box       m = d 8 a b c,     I_x = m (b^2 + c^2) / 3, half edges a, b, c
//   cylinder  m = d pi r^2 2h,   I_y = m r^2 / 2,  I_x = m (r^2 / 4 + h^2 / 3), half height h
//   capsule   a cylinder and two half balls m_b, whose own centres lie 3/8 r beyond its ends:
//             I_y = m_c r^2 / 2 + 2/5 m_b r^2,  I_x = m_c (r^2/4 + h^2/3) + m_b (2/5 r^2 + h^2 + 3/4 h r)
//   others    from their mesh (mesh_inertia.h); a distance function has none
// These lie along the shape's own axes, so X_BP is the identity but for what is made of triangles.
//
// Thread: load. Cost: some ten operations; of a mesh, see there.
// Source: textbook integrals; the capsule by the parallel axis theorem of its half balls.
#pragma once

#include "haptics/collision/solid_shape.h"
#include "haptics/dynamics/mesh_inertia.h"

namespace fulcrum {

/// Refuses what `validate` of a shape does, distance functions and height fields, densities that are not above 0, and masses and moments
/// that `validate` of an inertia refuses.
[[nodiscard]] Expected<MeshInertia> compute_shape_inertia(const SolidShape& shape,
                                                          double density_kg_per_m3);

/// The same with the density that gives this mass.
[[nodiscard]] Expected<MeshInertia> compute_shape_inertia_of_mass(const SolidShape& shape,
                                                                  double mass_kg);

}  // namespace fulcrum
