// The corners of a mesh's triangle, and where its front looks.
#pragma once

#include "haptics/geometry/triangle_mesh.h"

#include <array>

namespace fulcrum {

[[nodiscard]] inline std::array<Vector3, 3> corners_of(const TriangleMesh& mesh,
                                                       const TriangleCorners& triangle) {
    const auto at = [&](std::size_t i) {
        return mesh.vertices_B()[static_cast<std::size_t>(triangle[i])];
    };
    return {at(0), at(1), at(2)};
}

/// As long as twice the triangle's area.
[[nodiscard]] inline Vector3 front_of(const TriangleMesh& mesh, const TriangleCorners& triangle) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    return (b - a).cross(c - a);
}

}  // namespace fulcrum
