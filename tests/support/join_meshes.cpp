#include "tests/support/join_meshes.h"

#include "tests/support/hard_meshes.h"

#include <cstdint>

namespace fulcrum {

std::vector<Vector2> make_slivered_square(double half_m) {
    constexpr double kWidth_m = 1.0e-6;
    constexpr int kSlivers = 20;
    std::vector<Vector2> corners;
    for (int side = 0; side < 4; ++side) {
        const Vector2 out = turn_quarters(Vector2::UnitX(), side);
        const Vector2 along = turn_quarters(Vector2::UnitY(), side);
        corners.emplace_back(half_m * out - half_m * along);
        for (int i = 0; i <= kSlivers; ++i) {
            corners.emplace_back(half_m * out + kWidth_m * (i - 0.5 * kSlivers) * along);
        }
    }
    return corners;
}

Expected<TriangleMesh> join_meshes(const std::vector<std::pair<TriangleMesh, Pose>>& parts,
                                   const MeshBuildSettings& settings) {
    std::vector<Vector3> corners;
    std::vector<TriangleCorners> triangles;
    for (const auto& [mesh, pose] : parts) {
        const auto first = static_cast<std::int32_t>(corners.size());
        for (const Vector3& corner : mesh.vertices_B()) {
            corners.push_back(pose * corner);
        }
        for (const TriangleCorners& t : mesh.triangles()) {
            triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
    }
    return TriangleMesh::build(std::move(corners), std::move(triangles), settings);
}

}  // namespace fulcrum
