// The nearest point of a triangle, of a mesh by asking every triangle, and of a convex polygon: what proxies are tested against.
#pragma once

#include "haptics/collision/collision_mesh.h"
#include "haptics/math/spatial.h"

#include <vector>

namespace fulcrum {

[[nodiscard]] Vector3 find_nearest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b,
                                               const Vector3& c);

/// Cost: O(triangles).
[[nodiscard]] Vector3 find_nearest_on_mesh(const CollisionMesh& mesh, const Vector3& p);

/// Of a convex polygon, corners counter-clockwise, its inside included.
[[nodiscard]] Vector2 find_nearest_in_polygon(const std::vector<Vector2>& corners,
                                              const Vector2& p);

}  // namespace fulcrum
