#include "haptics/voxel/brick_sides.h"

#include "haptics/geometry/shape.h"
#include "haptics/voxel/winding_number.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

constexpr double kVoxel_m = 0.05;
constexpr float kBound = 3.0F;  // voxels

BrickDistances measure(const TriangleClusters& clusters, const Vector3& corner) {
    BrickDistances distances;
    for (int z = 0; z < kBrickSide; ++z) {
        for (int y = 0; y < kBrickSide; ++y) {
            for (int x = 0; x < kBrickSide; ++x) {
                const double d = clusters.find_distance(corner + kVoxel_m * Vector3(x, y, z));
                distances[brick_corner_at(x, y, z)] =
                    std::min(static_cast<float>(d / kVoxel_m), kBound);
            }
        }
    }
    return distances;
}

// Corners whose side is not that of their own winding number, of those that are not on the surface.
int count_wrong(const TriangleMesh& mesh, int n_bricks) {
    const TriangleClusters clusters(mesh);
    const BrickSides sides(mesh, clusters, kVoxel_m);
    Random random(21);
    int n_wrong = 0;
    for (int i = 0; i < n_bricks; ++i) {
        const Vector3 corner =
            1.0 * random.direction() - Vector3::Constant(0.5 * kBrickCells * kVoxel_m);
        const BrickDistances distances = measure(clusters, corner);
        BrickDistances with_signs = distances;
        sides.put_signs(corner, with_signs);
        for (int c = 0; c < static_cast<int>(kBrickCorners); ++c) {
            const Vector3 at(c % 9, c / 9 % 9, c / 81);
            const double w = compute_winding_number(clusters, corner + kVoxel_m * at, 1.0e9);
            const auto j = static_cast<std::size_t>(c);
            CHECK(std::abs(with_signs[j]) == distances[j]);
            const bool is_clear = distances[j] > 1.0e-4F && std::abs(std::abs(w) - 0.5) > 0.03;
            n_wrong += is_clear && (with_signs[j] < 0.0F) != (std::abs(w) >= 0.5) ? 1 : 0;
        }
    }
    return n_wrong;
}

}  // namespace

TEST_CASE("brick sides: every corner has the side of its winding number, closed mesh") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 12, 0.1, 8.0);
    const TriangleClusters clusters(mesh);
    CHECK(BrickSides(mesh, clusters, kVoxel_m).n_open_edges() == 0);
    CHECK(count_wrong(mesh, 40) == 0);
}

TEST_CASE(
    "brick sides: every corner has the side of its winding number, by a hole and far from it") {
    TriangleMesh ball = *make_sphere(1.0, 8);
    std::vector<TriangleCorners> kept(ball.triangles().begin() + 40, ball.triangles().end());
    const TriangleMesh mesh = TriangleMesh::build(ball.vertices_B(), kept).value();
    const TriangleClusters clusters(mesh);
    CHECK(BrickSides(mesh, clusters, kVoxel_m).n_open_edges() > 8);
    CHECK(count_wrong(mesh, 60) == 0);
}
