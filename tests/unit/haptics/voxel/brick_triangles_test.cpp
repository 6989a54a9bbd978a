#include "haptics/voxel/brick_triangles.h"

#include "haptics/geometry/shape.h"
#include "haptics/voxel/distance_band.h"
#include "haptics/voxel/distance_field.h"
#include "tests/support/hard_meshes.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;

namespace {

constexpr double kReach_voxels = 3.0;
constexpr double kAny = 1.0e9;

}  // namespace

TEST_CASE("brick triangles: a brick has every triangle that comes within reach of it") {
    const TriangleMesh mesh = *make_bumpy_sphere(1.0, 8, 0.2, 5.0);
    const VoxelFrame frame = DistanceField::make_frame(mesh, 48).value();
    const auto list = list_brick_triangles(mesh, frame, kReach_voxels, kAny, {});
    REQUIRE(list);
    CHECK(std::is_sorted(list->bricks.begin(), list->bricks.end()));
    CHECK(list->n_pairs == static_cast<double>(list->triangles.size()));
    const int nx = frame.n_cells[0] / kBrickCells;
    const int ny = frame.n_cells[1] / kBrickCells;
    const int nz = frame.n_cells[2] / kBrickCells;
    std::size_t at = 0;
    for (int brick = 0; brick < nx * ny * nz; ++brick) {
        const Vector3 corner = kBrickCells * Vector3(brick % nx, brick / nx % ny, brick / nx / ny);
        const bool listed = at < list->bricks.size() && list->bricks[at] == brick;
        const auto begin = list->triangles.begin();
        const auto first = listed ? begin + static_cast<std::ptrdiff_t>(list->first[at]) : begin;
        const auto end = listed ? begin + static_cast<std::ptrdiff_t>(list->first[at + 1]) : begin;
        CHECK(std::is_sorted(first, end));
        for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
            // At the brick's own corners: what reaches those it must have.
            const TriangleAt triangle = find_lattice_triangle(mesh, frame, t);
            bool is_near = false;
            for (int c = 0; c < 8; ++c) {
                const Vector3 p = corner + kBrickCells * Vector3(c & 1, c / 2 & 1, c / 4);
                is_near = is_near ||
                          compute_square_distance(p, triangle) <= kReach_voxels * kReach_voxels;
            }
            if (is_near) {
                REQUIRE(std::find(first, end, static_cast<std::int32_t>(t)) != end);
            }
        }
        at += listed ? 1 : 0;
    }
    CHECK(at == list->bricks.size());
}

TEST_CASE("brick triangles: a list that grows too long is given up, and how long it were is told") {
    const TriangleMesh heap = *make_heap(1000, 3);
    const VoxelFrame frame = DistanceField::make_frame(heap, 128).value();
    const auto whole = list_brick_triangles(heap, frame, kReach_voxels, kAny, {});
    const auto given_up = list_brick_triangles(heap, frame, kReach_voxels, 20000.0, {});
    REQUIRE(whole);
    REQUIRE(given_up);
    REQUIRE(whole->n_pairs > 1.0e5);
    CHECK(given_up->bricks.empty());
    CHECK(given_up->triangles.empty());
    CHECK(given_up->n_pairs == Approx(whole->n_pairs).epsilon(0.2));
}

TEST_CASE("brick triangles: it stops where it is told to") {
    const TriangleMesh mesh = *make_sphere(1.0, 8);
    const VoxelFrame frame = DistanceField::make_frame(mesh, 48).value();
    CHECK_FALSE(
        list_brick_triangles(mesh, frame, kReach_voxels, kAny, [](double) { return false; }));
}
