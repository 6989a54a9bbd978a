// Cracks: places where a surface falls apart along edges that ought to be one, and how they are closed.
//
// Two open edges face each other when both their ends are within the tolerance and their triangles lie on different sides of them:
// with d the direction from an edge into its triangle, d1 . d2 < kFolded. The two faces of a thin plate, whose triangles lie on
// the same side, do not. The nearest edges are closed first, each with one other; the vertices of a pair become one unless a
// triangle would lose its area or turn over.
// Not closed are cracks that are wider, and edges of which one has a vertex where the other has none (T-junctions): as no ends
// face each other there, they stay open, and the report counts them.
//
// Thread: load. Cost: O(triangles); open edges that crowd within the tolerance look at kMostNear others each.
#pragma once

#include "haptics/geometry/mesh_edges.h"
#include "haptics/math/spatial.h"

#include <cstdint>
#include <span>
#include <vector>

namespace fulcrum {

/// Triangles at a smaller angle than some 25 degrees are two faces, not neighbours.
inline constexpr double kFolded = 0.9;
inline constexpr int kMostNear = 64;

struct ClosedCracks {
    /// For each vertex the one that it becomes; empty when nothing is closed.
    std::vector<std::int32_t> becomes;
    std::int64_t welded_vertices = 0;
    std::int64_t closed_edges = 0;  ///< pairs of edges that became one
    std::int64_t cracks = 0;        ///< those pairs, as often as they hang together
};

/// `tolerance_m` > 0; triangles have areas.
[[nodiscard]] ClosedCracks close_cracks(std::span<const Vector3> vertices,
                                        std::span<const TriangleCorners> triangles,
                                        double tolerance_m);

}  // namespace fulcrum
