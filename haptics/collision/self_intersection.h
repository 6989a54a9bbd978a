// Where a mesh passes through itself: triangles of which one has an edge that crosses the other's inside.
//
// An edge (p, q) crosses (a, b, c) when p and q lie on different sides of its plane and a, b, c wind round the line p q all one way,
// by exact signs; so what only touches, neighbours above all, is not counted. Pairs come from the bounding tree.
//
// Thread: load. Cost: O(n log n); about a quarter of a second for a million triangles. It stops at a number of crossings, and at a number of
// pairs looked at, which a sound mesh does not reach, so that a mesh all of whose triangles cross does not take for ever.
// Source: signs as in segment_triangle.h.
#pragma once

#include "haptics/geometry/mesh_report.h"
#include "haptics/geometry/triangle_mesh.h"

#include <cstdint>

namespace fulcrum {

struct SelfIntersectionLimits {
    std::int64_t most_crossings = 1000;
    std::int64_t most_pairs_a_triangle = 256;  ///< times the number of triangles
};

struct SelfIntersections {
    std::int64_t count = 0;  ///< pairs of triangles that pass through each other
    bool more = false;       ///< a limit was reached: there may be more
};

[[nodiscard]] SelfIntersections find_self_intersections(const TriangleMesh& mesh,
                                                        const SelfIntersectionLimits& limits = {});

/// `compute_mesh_report`, and the places where the mesh passes through itself.
[[nodiscard]] MeshReport compute_full_mesh_report(const TriangleMesh& mesh);

}  // namespace fulcrum
