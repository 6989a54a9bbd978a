// Mass, centre of mass and inertia of a body of even density, from its mesh.
//
//   m = density V,   I_B = density (trace(S) - S)  about the centre of mass        (solid_moments.h: V, S)
//   I_B = R diag(moments) R^T,   X_BP = (centre, R)    P the frame in which the integrators move the body
// Two rules, the first where it holds:
//   integrals   exact, to rounding. The mesh is closed, its neighbours agree which way is out (mesh_report.h), and it winds once,
//               or once the other way round, round each place where it winds at all (winding_number.h), of one by chance in each
//               of up to 24^3 cubes
//   samples     what the mesh winds round by at least a half (as the distance field has it), sampled at a place by chance in
//               each of up to 64^3 cubes: open, cracked and overlapping meshes, solids within solids, parts turned inside out. Off by
//               about 0.3 % for compact bodies, for thin ones by as much as few cubes tell; where there is a hole, by its bulge.
//               Where thousands of large triangles cross each other all over the mesh the cubes are fewer, at least 12^3
// What overlaps by less than a 24th of the mesh's length may pass as whole: it then counts twice.
//
// Thread: load. Cost: some ms and 1 us a triangle; by samples half a second.
// Source: solid_moments.h; sides of broken meshes: A. Jacobson, L. Kavan, O. Sorkine-Hornung 2013, Robust inside-outside
// segmentation using generalized winding numbers, ACM TOG 32(4).
#pragma once

#include "haptics/base/error.h"
#include "haptics/base/parallel_for.h"
#include "haptics/dynamics/rigid_state.h"
#include "haptics/geometry/solid_moments.h"
#include "haptics/geometry/triangle_mesh.h"

#include <cstdint>
#include <string_view>

namespace fulcrum {

/// By which rule a mesh's inertia was found.
enum class InertiaRule : std::uint8_t { integrals, samples };

/// "integrals", "samples".
[[nodiscard]] std::string_view to_string(InertiaRule rule) noexcept;

struct MeshInertia {
    Inertia inertia{};  ///< mass and principal moments, ascending
    Pose X_BP{};        ///< the centre of mass, and the principal axes, in the mesh's frame
    Matrix3 inertia_B{
        Matrix3::Zero()};    ///< kg m^2, about the centre of mass, along the mesh's axes
    double volume_m3 = 0.0;  ///< enclosed
    InertiaRule rule = InertiaRule::integrals;
};

/// What the mesh encloses, by the first rule that holds: what takes long of the rest. Refuses a mesh that encloses nothing, `where`
/// names it in the error; an error too where `progress` stops it.
[[nodiscard]] Expected<MeasuredSolid> measure_solid(const TriangleMesh& mesh,
                                                    const std::string& where = {},
                                                    const LoadProgress& progress = {});

/// The same filled evenly, so that it has this mass. Refuses a mass that is not a number above 0, and masses and moments that
/// `validate` of an inertia refuses; `where` names the mesh in the error.
[[nodiscard]] Expected<MeshInertia> fill_with_mass(const MeasuredSolid& solid, double mass_kg,
                                                   const std::string& where = {});

/// Of a mesh filled evenly, kg/m^3. Refuses a density that is not a number above 0, a mesh that encloses nothing, and masses and
/// moments that `validate` of an inertia refuses; `where` names the mesh in the error.
[[nodiscard]] Expected<MeshInertia> compute_inertia(const TriangleMesh& mesh,
                                                    double density_kg_per_m3,
                                                    const std::string& where = {});

}  // namespace fulcrum
