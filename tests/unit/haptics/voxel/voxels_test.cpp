#include "haptics/geometry/shape.h"
#include "haptics/voxel/pointshell.h"
#include "haptics/voxel/rasterise.h"
#include "haptics/voxel/triangle_clusters.h"
#include "haptics/voxel/voxelise.h"
#include "haptics/voxel/voxmap.h"
#include "tests/support/edited_meshes.h"
#include "tests/support/hard_meshes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace fulcrum;

namespace {

VoxelGrid make_ball(int n) {
    const auto mesh = make_bumpy_sphere(0.05, 16, 0.1, 7.0).value();
    return voxelise(mesh, {.voxel_m = compute_voxel_m(mesh, n)}).value();
}

// Every voxel of its own kind, so that one read for another is seen.
VoxelGrid make_noise(const VoxelFrame::Cell& n_cells) {
    VoxelGrid grid;
    grid.frame.n_cells = n_cells;
    std::mt19937 random(3);  // NOLINT(cert-msc51-cpp): the same each time
    const auto [nx, ny, nz] = n_cells;
    for (std::int32_t i = 0; i < nx * ny * nz; ++i) {
        grid.cells.push_back(static_cast<VoxelClass>(random() & 3U));
    }
    return grid;
}

void check_same(const VoxelGrid& grid, const Voxmap& map) {
    const auto [nx, ny, nz] = grid.frame.n_cells;
    bool same = true;
    for_each_cell({{-2, -2, -2}, {nx + 2, ny + 2, nz + 2}}, [&](const VoxelFrame::Cell& cell) {
        same = same && map.find_class(cell) == grid.find_class(cell);
    });
    CHECK(same);
}

VoxelGrid make_grid(const TriangleMesh& mesh, const VoxeliseSettings& settings) {
    auto grid = voxelise(mesh, settings);
    REQUIRE(grid);
    return *grid;
}

std::size_t count(const VoxelGrid& grid, VoxelClass kind) {
    return static_cast<std::size_t>(std::count(grid.cells.begin(), grid.cells.end(), kind));
}

CellRange all_of(const VoxelGrid& grid) {
    const auto [nx, ny, nz] = grid.frame.n_cells;
    return {{0, 0, 0}, {nx - 1, ny - 1, nz - 1}};
}

}  // namespace

TEST_CASE(
    "voxmap: what the grid says at every depth, free far outside, in the least power of two") {
    for (const int depth : {1, 2, 3}) {
        for (const VoxelFrame::Cell& n_cells : std::vector<VoxelFrame::Cell>{
                 {1, 1, 1}, {8, 8, 8}, {9, 3, 17}, {64, 5, 64}, {65, 70, 33}}) {
            const VoxelGrid grid = make_noise(n_cells);
            check_same(grid, Voxmap::build(grid, depth).value());
        }
        const VoxelGrid ball = make_ball(80);
        check_same(ball, Voxmap::build(ball, depth).value());
    }
    const Voxmap map = Voxmap::build(make_ball(20), 2).value();
    constexpr std::int32_t kFar = 2'000'000'000;
    for (const VoxelFrame::Cell& cell : std::vector<VoxelFrame::Cell>{{kFar, 5, 5},
                                                                      {-kFar, 5, 5},
                                                                      {5, kFar, 5},
                                                                      {5, -kFar, 5},
                                                                      {5, 5, kFar},
                                                                      {5, 5, -kFar}}) {
        CHECK(map.find_class(cell) == VoxelClass::free);
    }
    const VoxelGrid grid = make_noise({80, 20, 20});
    CHECK(Voxmap::build(grid, 1).value().block_edge() == 16);
    CHECK(Voxmap::build(grid, 2).value().block_edge() == 2);
    CHECK(Voxmap::build(grid, 3).value().block_edge() == 1);
}

TEST_CASE("voxmap: what is all alike is not stored") {
    VoxelGrid grid;
    grid.frame.n_cells = {300, 200, 100};
    grid.cells.assign(std::size_t{300} * 200 * 100, VoxelClass::free);
    for (const int depth : {1, 2, 3}) {
        const Voxmap map = Voxmap::build(grid, depth).value();
        CHECK(map.n_nodes() == 1);
        CHECK(map.n_blocks() == 0);
    }
    // One voxel costs one node a level, or its block.
    grid.cells[grid.index_of({123, 45, 67})] = VoxelClass::surface;
    CHECK(Voxmap::build(grid, 1).value().n_blocks() == 1);
    CHECK(Voxmap::build(grid, 2).value().n_nodes() == 2);
    CHECK(Voxmap::build(grid, 3).value().n_nodes() == 3);
    CHECK(Voxmap::build(grid, 3).value().n_blocks() == 0);
}

TEST_CASE("voxmap: memory is counted, and a thin surface takes less than two bits a voxel") {
    const VoxelGrid grid = make_ball(200);
    const Voxmap two = Voxmap::build(grid, 2).value();
    CHECK(two.memory_bytes() < grid.cells.size() / 4);
    const std::size_t block_bytes = 64 / 4;
    CHECK(two.block_edge() == 4);
    CHECK(two.memory_bytes() ==
          sizeof(Voxmap) + two.n_nodes() * 512 * 4 + two.n_blocks() * block_bytes);
}

TEST_CASE("voxmap: a depth or a size that no tree has is refused") {
    const VoxelGrid grid = make_ball(10);
    CHECK_FALSE(Voxmap::build(grid, 0));
    CHECK_FALSE(Voxmap::build(grid, 4));
    VoxelGrid large;
    large.frame.n_cells = {513, 1, 1};
    large.cells.resize(513);
    CHECK_FALSE(Voxmap::build(large, 3));
    large.frame.n_cells = {0, 1, 1};
    CHECK_FALSE(Voxmap::build(large, 1));
}

TEST_CASE("voxelise: a ball's voxels are surface, interior and free where its distance says so") {
    const double radius_m = 0.05;
    const auto mesh = make_sphere(radius_m, 24).value();
    const VoxelGrid grid = make_grid(mesh, {.voxel_m = 0.004, .proximity_layers = 0});
    // Flat triangles of this sphere lie at most this much inside it.
    const double sagitta_m = 1.0e-4;
    const double half_diagonal_m = 0.5 * std::sqrt(3.0) * grid.frame.voxel_m;
    for_each_cell(all_of(grid), [&](const VoxelFrame::Cell& cell) {
        const double distance_m = grid.frame.centre_of(cell).norm() - radius_m;
        const VoxelClass kind = grid.find_class(cell);
        if (distance_m > half_diagonal_m) {
            REQUIRE(kind == VoxelClass::free);
        } else if (distance_m < -half_diagonal_m - sagitta_m) {
            REQUIRE(kind == VoxelClass::interior);
        } else if (std::abs(distance_m) < 0.5 * grid.frame.voxel_m - sagitta_m) {
            // The surface passes nearer than the voxel's inscribed ball.
            REQUIRE(kind == VoxelClass::surface);
        }
    });
    const double cell_m3 = std::pow(grid.frame.voxel_m, 3);
    const double volume_m3 = 4.0 / 3.0 * 3.14159265 * std::pow(radius_m, 3);
    const auto inside = static_cast<double>(count(grid, VoxelClass::interior));
    const auto surface = static_cast<double>(count(grid, VoxelClass::surface));
    CHECK(inside * cell_m3 < volume_m3);
    CHECK((inside + surface) * cell_m3 > volume_m3);
    CHECK((inside + 0.5 * surface) * cell_m3 == Approx(volume_m3).epsilon(0.03));
}

TEST_CASE("voxelise: a box is counted voxel by voxel") {
    // 10 x 6 x 4 voxels and a half: 11 x 7 x 5 touched, all but a shell of one voxel inside.
    const auto mesh = make_box({10.5, 6.5, 4.5}).value();
    const VoxelGrid grid = make_grid(mesh, {.voxel_m = 1.0, .proximity_layers = 1});
    CHECK(count(grid, VoxelClass::interior) == 9 * 5 * 3);
    CHECK(count(grid, VoxelClass::surface) == 11 * 7 * 5 - 9 * 5 * 3);
    CHECK(count(grid, VoxelClass::proximity) == 13 * 9 * 7 - 11 * 7 * 5);
    CHECK(grid.frame.n_cells == VoxelFrame::Cell{15, 11, 9});
}

TEST_CASE("voxelise: a layer pushed outwards leaves what it held to the inside") {
    const auto mesh = make_box({10.5, 6.5, 4.5}).value();
    const VoxelGrid grid =
        make_grid(mesh, {.voxel_m = 1.0, .offset_layers = 2, .proximity_layers = 3});
    CHECK(count(grid, VoxelClass::interior) == 13 * 9 * 7);
    CHECK(count(grid, VoxelClass::surface) == 15 * 11 * 9 - 13 * 9 * 7);
    CHECK(count(grid, VoxelClass::proximity) == 21 * 17 * 15 - 15 * 11 * 9);
}

TEST_CASE(
    "voxelise: the outermost voxels are free, whatever the layers and however the sides end") {
    for (const double side : {4.0, 4.0 - 1.0e-12, 4.0 + 1.0e-12, 4.3}) {
        for (const int layers : {0, 1, 3}) {
            const VoxelGrid grid =
                make_grid(make_box(Vector3::Constant(side)).value(),
                          {.voxel_m = 1.0, .offset_layers = layers, .proximity_layers = layers});
            const auto [nx, ny, nz] = grid.frame.n_cells;
            for_each_cell(all_of(grid), [&, nx = nx, ny = ny, nz = nz](const VoxelFrame::Cell& c) {
                if (c[0] == 0 || c[1] == 0 || c[2] == 0 || c[0] == nx - 1 || c[1] == ny - 1 ||
                    c[2] == nz - 1) {
                    REQUIRE(grid.find_class(c) == VoxelClass::free);
                }
            });
        }
    }
}

TEST_CASE(
    "voxelise: cracks narrower than a voxel do not leak, and a mesh turned inside out is the "
    "same") {
    const auto mesh = make_sphere(0.05, 16).value();
    const VoxeliseSettings settings{.voxel_m = 0.004};
    const VoxelGrid whole = make_grid(mesh, settings);
    CHECK(make_grid(make_inverted(mesh).value(), settings).cells == whole.cells);
    // Each triangle drawn in by half a percent towards its middle: open along every edge.
    std::vector<Vector3> corners;
    std::vector<TriangleCorners> triangles;
    for (const TriangleCorners& t : mesh.triangles()) {
        Vector3 middle = Vector3::Zero();
        for (const std::int32_t corner : t) {
            middle += mesh.vertices_B()[static_cast<std::size_t>(corner)] / 3.0;
        }
        const auto first = static_cast<std::int32_t>(corners.size());
        for (const std::int32_t corner : t) {
            corners.emplace_back(
                middle + 0.995 * (mesh.vertices_B()[static_cast<std::size_t>(corner)] - middle));
        }
        triangles.push_back({first, first + 1, first + 2});
    }
    const auto cracked =
        TriangleMesh::build(corners, triangles, {.weld_relative = 0.0, .crack_relative = 0.0})
            .value();
    // Leaked, it would have none; a little smaller it has a little less.
    CHECK(static_cast<double>(count(make_grid(cracked, settings), VoxelClass::interior)) ==
          Approx(static_cast<double>(count(whole, VoxelClass::interior))).epsilon(0.02));
}

TEST_CASE("voxelise: a bowl has an inside that is free, and no voxel but its wall pushes") {
    const auto bowl = test::take_away(
        make_sphere(0.05, 16).value(), [](const Vector3& middle) { return middle.y() > 0.0; },
        test::kAsItIs);
    const VoxelGrid grid = make_grid(bowl, {.voxel_m = 0.004, .proximity_layers = 0});
    CHECK(grid.find_class(grid.frame.find_cell({0.0, -0.02, 0.0})) == VoxelClass::free);
    CHECK(grid.find_class(grid.frame.find_cell({0.0, -0.05, 0.0})) == VoxelClass::surface);
    CHECK(count(grid, VoxelClass::interior) < count(grid, VoxelClass::surface) / 20);
}

TEST_CASE("voxelise: a hollow that nothing reaches is inside") {
    // A ball in a ball: the shell between them and the hollow are both beyond the surface.
    const auto hollow = make_hollow(*make_sphere(0.05, 12), *make_sphere(0.025, 12)).value();
    const VoxelGrid grid = make_grid(hollow, {.voxel_m = 0.004});
    CHECK(grid.find_class(grid.frame.find_cell(Vector3::Zero())) == VoxelClass::interior);
    CHECK(grid.find_class(grid.frame.find_cell({0.0, 0.0375, 0.0})) == VoxelClass::interior);
}

TEST_CASE(
    "voxelise: what is not interior is farther than k - 1 voxels from the mesh, and no more") {
    const auto mesh = make_bumpy_sphere(0.05, 12, 0.1, 7.0).value();
    const TriangleClusters clusters(mesh);
    for (const int k : {1, 2, 3}) {
        const VoxelGrid grid = make_grid(mesh, {.voxel_m = 0.004, .offset_layers = k});
        const double s = grid.frame.voxel_m;
        double nearest_m = 1.0;
        for_each_cell(all_of(grid), [&](const VoxelFrame::Cell& cell) {
            if (grid.find_class(cell) != VoxelClass::surface) {
                return;
            }
            // Its corners and the middles of its edges and sides.
            for_each_cell({{-1, -1, -1}, {1, 1, 1}}, [&](const VoxelFrame::Cell& at) {
                const Vector3 p =
                    grid.frame.centre_of(cell) + 0.5 * s * Vector3(at[0], at[1], at[2]);
                nearest_m = std::min(nearest_m, clusters.find_distance(p));
            });
        });
        INFO(k << ": " << nearest_m / s);
        CHECK(nearest_m >= (k - 1) * s - 1.0e-9);
        CHECK(nearest_m < (k - 1 + 0.15) * s);
    }
}

TEST_CASE("voxelise: with two layers surfaces cannot meet while no point is interior") {
    const auto mesh = make_bumpy_sphere(0.05, 12, 0.1, 7.0).value();
    const auto tool = make_box({0.03, 0.02, 0.04}).value();
    const TriangleClusters clusters(mesh);
    const auto places = make_surface_pointshell(tool, 2000).value();
    Random random(3);
    // Whether a pose is found where no point is interior and the surfaces are within `near_m` of each other.
    const auto can_come_near = [&](int k, double shell_voxel_m, double near_m) {
        const VoxelGrid grid = make_grid(mesh, {.voxel_m = 0.004, .offset_layers = k});
        const auto shell = make_voxel_pointshell(tool, shell_voxel_m).value();
        for (int i = 0; i < 3000; ++i) {
            const Pose X_OT{(0.058 + 0.022 * random.uniform()) * random.direction(),
                            random.turn(3.0)};
            const auto is_interior = [&](std::size_t j) {
                const auto cell = grid.frame.find_cell(X_OT * shell.position_T(j));
                return grid.frame.contains(cell) && grid.find_class(cell) == VoxelClass::interior;
            };
            bool penetrates = false;
            for (std::size_t j = 0; j < shell.size() && !penetrates; ++j) {
                penetrates = is_interior(j);
            }
            for (std::size_t j = 0; j < places.size() && !penetrates; ++j) {
                if (clusters.find_distance(X_OT * places.position_T(j)) < near_m) {
                    return true;
                }
            }
        }
        return false;
    };
    // Within a tenth of a voxel of each other; the bound leaves 1 - sqrt(3)/2 = 0.13 of one.
    CHECK_FALSE(can_come_near(2, 0.004, 0.0004));
    CHECK(can_come_near(1, 0.004, 0.0004));
    CHECK(can_come_near(0, 0.004, 0.0004));
    // Points too far apart do not see it.
    CHECK(can_come_near(2, 0.016, 0.0004));
}

TEST_CASE("voxelise: the longest side fills as asked; bad settings and large meshes are refused") {
    for (const int n : {1, 7, 80}) {
        const auto mesh = make_box({0.3, 0.1, 0.2}).value();
        const VoxelGrid grid =
            make_grid(mesh, {.voxel_m = compute_voxel_m(mesh, n), .proximity_layers = 0});
        CHECK(grid.frame.n_cells[0] == n + 2);
    }
    const auto mesh = make_box({0.3, 0.1, 0.2}).value();
    CHECK_FALSE(voxelise(mesh, {.voxel_m = 0.0}));
    CHECK_FALSE(voxelise(mesh, {.voxel_m = std::nan("")}));
    CHECK_FALSE(voxelise(mesh, {.voxel_m = 0.01, .offset_layers = -1}));
    CHECK_FALSE(voxelise(mesh, {.voxel_m = 0.01, .proximity_layers = 9}));
    CHECK_FALSE(voxelise(mesh, {.voxel_m = 0.0005}));
    CHECK(voxelise(mesh, {.voxel_m = 0.0006}));
}

TEST_CASE("rasterise: each voxel once, and blocks change nothing") {
    VoxelFrame frame;
    frame.lower_O = {-1.3, -2.1, 0.2};
    frame.voxel_m = 0.1;
    frame.n_cells = {40, 37, 29};
    const TrianglePoints triangle{Vector3(-1.0, -2.0, 0.3), Vector3(2.5, 1.2, 1.1),
                                  Vector3(0.1, 1.4, 2.9)};
    std::vector<VoxelFrame::Cell> found;
    rasterise(frame, triangle, [&found](const VoxelFrame::Cell& cell) { found.push_back(cell); });
    std::vector<VoxelFrame::Cell> expected;
    for_each_cell({{0, 0, 0}, {39, 36, 28}}, [&](const VoxelFrame::Cell& cell) {
        if (overlaps_box(triangle, frame.centre_of(cell), Vector3::Constant(0.05))) {
            expected.push_back(cell);
        }
    });
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    CHECK(found.size() > 500);
    CHECK(found == expected);
}

TEST_CASE("voxelise: it tells how far it is, and stops where it is told to") {
    const TriangleMesh mesh = make_sphere(1.0, 4).value();
    std::vector<double> told;
    const auto tell = [&](double most) {
        told.clear();
        return voxelise(mesh, {.voxel_m = 0.1}, [&told, most](double share) {
            told.push_back(share);
            return share < most;
        });
    };
    CHECK(tell(2.0)->cells == voxelise(mesh, {.voxel_m = 0.1})->cells);
    CHECK(std::is_sorted(told.begin(), told.end()));
    CHECK(told.back() == 1.0);
    for (const double most : {0.1, 0.5, 1.0}) {
        CHECK_FALSE(tell(most));
    }
    CHECK(told.size() >= 3);  // one a step, and one each 50 ms
}

TEST_CASE("voxelise: triangles that cross each other all over fill what each of them fills") {
    // Blocks that are full are passed over: that may change nothing.
    const TriangleMesh heap = make_heap(60, 5).value();
    const VoxelGrid grid = voxelise(heap, {.voxel_m = 0.05, .offset_layers = 0}).value();
    std::vector<std::uint8_t> touched(grid.cells.size(), 0);
    for (const auto& [a, b, c] : heap.triangles()) {
        const auto at = [&](std::int32_t i) {
            return heap.vertices_B()[static_cast<std::size_t>(i)];
        };
        rasterise(grid.frame, {at(a), at(b), at(c)},
                  [&](const VoxelFrame::Cell& cell) { touched[grid.index_of(cell)] = 1; });
    }
    std::size_t n_touched = 0;
    for (std::size_t i = 0; i < touched.size(); ++i) {
        n_touched += touched[i];
        REQUIRE((grid.cells[i] == VoxelClass::surface) == (touched[i] != 0));
    }
    CHECK(n_touched > grid.cells.size() / 8);
}
