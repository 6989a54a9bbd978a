// Meshes made by rule: for tests, benchmarks and lessons. All are centred on the origin of the
// body's frame and their fronts look outwards.
//
// Thread: load. Cost: O(triangles). Errors: sizes that are not finite and above zero, or counts out
// of range.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <span>

namespace fulcrum {

/// A box with the given edge lengths, 12 triangles.
[[nodiscard]] Expected<TriangleMesh> make_box(const Vector3& size_m);

/// A box somewhere: its middle and its edges, metres.
struct PlacedBox {
    Vector3 at_B{Vector3::Zero()};
    Vector3 size_m{Vector3::Zero()};

    bool operator==(const PlacedBox&) const = default;
};

/// Boxes in one mesh, 12 triangles each, none welded to another; at least one. Where boxes overlap, what lies inside another is
/// never reached from outside.
[[nodiscard]] Expected<TriangleMesh> make_boxes(std::span<const PlacedBox> boxes);

/// A flat rectangle in the plane y = 0, of n x n squares of two triangles each. n from 1 to 4096.
[[nodiscard]] Expected<TriangleMesh> make_plate(double width_m, double depth_m, int n);

/// An icosahedron whose faces are divided into frequency^2 triangles each, drawn out to the sphere:
/// 20 frequency^2 triangles. frequency from 1 to 512.
[[nodiscard]] Expected<TriangleMesh> make_sphere(double radius_m, int frequency);

/// A sphere by longitude and latitude: fine slivers at the poles. 3 to 4096 round the equator, 2 to
/// 4096 from pole to pole.
[[nodiscard]] Expected<TriangleMesh> make_globe(double radius_m, int n_round, int n_across);

/// As `make_sphere`, with the radius times 1 + height (sin(w x) + sin(w y) + sin(w z)) / 3 along
/// the unit vector (x, y, z), w = bumps. height from 0 to 0.5, bumps from 0 to 1000.
[[nodiscard]] Expected<TriangleMesh> make_bumpy_sphere(double radius_m, int frequency,
                                                       double height, double bumps);

/// A cylinder along y with flat ends. 3 to 4096 sides.
[[nodiscard]] Expected<TriangleMesh> make_cylinder(double radius_m, double height_m, int n_round);

/// All points within `radius_m` of a segment along y of `straight_m`; its ends are halves of a globe of n_round sides with
/// `n_across` rows each. 3 to 4096 sides, 1 to 2048 rows.
[[nodiscard]] Expected<TriangleMesh> make_capsule(double radius_m, double straight_m, int n_round,
                                                  int n_across);

/// A ring round the y axis: a tube of `tube_radius_m` whose middle runs at `ring_radius_m`, above
/// tube_radius_m.
[[nodiscard]] Expected<TriangleMesh> make_torus(double ring_radius_m, double tube_radius_m,
                                                int n_ring, int n_tube);

/// A cup about the y axis, open upwards: within it depth_m deep below its rim at y = 0, rim_m wide there and foot_m at the bottom; walls and floor
/// are wall_m thick. 3 to 4096 sides, which touch these radii from outside; 8 triangles a side.
[[nodiscard]] Expected<TriangleMesh> make_cup(double rim_m, double foot_m, double depth_m,
                                              double wall_m, int n_round);

/// The same surface with every triangle turned over.
[[nodiscard]] Expected<TriangleMesh> make_inverted(const TriangleMesh& mesh);

}  // namespace fulcrum
