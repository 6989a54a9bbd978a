// The least convex body that holds a cloud of points.
//
// Quickhull: from four points on, the point farthest outside a face takes the place of all faces that it sees; its new faces join it
// to the border of what it saw. Whether a point sees a face is decided by exact signs (orientation.h), strictly: so what a
// point sees is in one piece, no face is without area, and points in a face's plane, on an edge or given twice need no care.
//
// Thread: load. Cost: O(n log n) for clouds of points that chance scatters.
// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa 1996, The quickhull algorithm for convex hulls, ACM Trans. Math. Softw. 22(4).
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <vector>

namespace fulcrum {

/// The hull's surface, fronts outwards; its vertices are those of the points that are needed. Refuses points that are not finite or
/// too large, and clouds that lie in a plane.
[[nodiscard]] Expected<TriangleMesh> make_convex_hull(const std::vector<Vector3>& points_B);

}  // namespace fulcrum
