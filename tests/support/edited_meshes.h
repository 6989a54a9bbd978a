// Meshes made of others: moved, joined, or with triangles taken away or turned.
#pragma once

#include "haptics/geometry/triangle_mesh.h"
#include "tests/support/join_meshes.h"

#include <utility>
#include <vector>

namespace fulcrum::test {

/// Nothing welded: corners stay as they are.
inline constexpr MeshBuildSettings kAsItIs{.weld_relative = 0.0, .crack_relative = 0.0};

/// Each corner where `move` takes it.
template <class Move>
TriangleMesh move_corners(const TriangleMesh& mesh, Move move,
                          const MeshBuildSettings& settings = {}) {
    std::vector<Vector3> vertices = mesh.vertices_B();
    for (Vector3& vertex : vertices) {
        vertex = move(vertex);
    }
    return TriangleMesh::build(std::move(vertices), mesh.triangles(), settings).value();
}

inline TriangleMesh shift(const TriangleMesh& mesh, const Vector3& way,
                          const MeshBuildSettings& settings = kAsItIs) {
    return move_corners(
        mesh, [&](const Vector3& v) { return Vector3(v + way); }, settings);
}

/// All surfaces in one mesh.
inline TriangleMesh join_meshes(const std::vector<TriangleMesh>& parts) {
    std::vector<std::pair<TriangleMesh, Pose>> placed;
    for (const TriangleMesh& part : parts) {
        placed.emplace_back(part, Pose{});
    }
    return fulcrum::join_meshes(placed, kAsItIs).value();
}

/// Only its first triangles, or, where the number is below 0, all but so many of the last.
inline TriangleMesh take_first(const TriangleMesh& mesh, std::ptrdiff_t n) {
    std::vector<TriangleCorners> triangles = mesh.triangles();
    triangles.resize(static_cast<std::size_t>(n < 0 ? std::ssize(triangles) + n : n));
    return TriangleMesh::build(mesh.vertices_B(), std::move(triangles)).value();
}

/// Without the triangles whose middle is one of those.
template <class Taken>
TriangleMesh take_away(const TriangleMesh& mesh, Taken is_taken,
                       const MeshBuildSettings& settings = {}) {
    std::vector<TriangleCorners> kept;
    for (const TriangleCorners& t : mesh.triangles()) {
        Vector3 middle = Vector3::Zero();
        for (const std::int32_t corner : t) {
            middle += mesh.vertices_B()[static_cast<std::size_t>(corner)] / 3.0;
        }
        if (!is_taken(middle)) {
            kept.push_back(t);
        }
    }
    return TriangleMesh::build(mesh.vertices_B(), std::move(kept), settings).value();
}

/// One triangle turned over, one twice, so that edges have three, and one taken away: open.
inline TriangleMesh make_broken(const TriangleMesh& mesh) {
    std::vector<TriangleCorners> triangles = mesh.triangles();
    std::swap(triangles[3][0], triangles[3][1]);
    triangles.push_back(triangles[10]);
    triangles.erase(triangles.begin() + 20);
    return TriangleMesh::build(mesh.vertices_B(), std::move(triangles)).value();
}

}  // namespace fulcrum::test
