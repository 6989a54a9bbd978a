// Meshes that are hard to touch: grooves, sockets, prisms of slivers, surfaces that fall apart into triangles or at a seam, or have
// T-junctions.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <vector>

namespace fulcrum {

/// A groove along z, its bottom on the z axis, from z = -1 to 1: two walls of one metre that rise by `slope` radians
/// from the horizontal, each of n strips. Its opening angle is pi - 2 slope.
[[nodiscard]] Expected<TriangleMesh> make_trench(double slope, int n);

/// A convex polygon round the origin, corners counter-clockwise, drawn out along z to `length_m`; closed, nothing welded.
[[nodiscard]] Expected<TriangleMesh> make_prism(const std::vector<Vector2>& corners,
                                                double length_m);

/// A quarter turn counter-clockwise, so often; the numbers stay exact.
[[nodiscard]] Vector2 turn_quarters(Vector2 v, int quarters);

/// The same surface, with corners of each triangle's own, every triangle twice and every third copy turned over, and for each
/// a triangle without area between two of its corners. Built with the given weld.
[[nodiscard]] Expected<TriangleMesh> make_messy(const TriangleMesh& mesh, double weld_relative);

/// The same surface in two halves, cut where triangles of the upper half y > 0 end; along the seam the lower half's corners are
/// moved by up to `crack_m`. Built with the given weld.
[[nodiscard]] Expected<TriangleMesh> make_cracked(const TriangleMesh& mesh, double crack_m,
                                                  unsigned seed, double weld_relative);

/// So many loose triangles by chance in a cube of 2 m round the origin, each as large as it: they cross each other all over.
[[nodiscard]] Expected<TriangleMesh> make_heap(int n_triangles, unsigned seed);

/// The same surface with T-junctions: of every third triangle an edge is cut in its middle, which its neighbour over that edge knows
/// nothing of; as the middle is rounded, neither surface need contain the other's edge. Nothing is welded.
[[nodiscard]] Expected<TriangleMesh> make_t_junctions(const TriangleMesh& mesh);

/// What lies between two closed surfaces, `hollow` wholly inside `outside`: that one turned over, nothing welded.
[[nodiscard]] Expected<TriangleMesh> make_hollow(const TriangleMesh& outside,
                                                 const TriangleMesh& hollow);

}  // namespace fulcrum
