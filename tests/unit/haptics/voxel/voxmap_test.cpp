#include "haptics/voxel/voxmap.h"

#include "haptics/geometry/shape.h"
#include "haptics/voxel/rasterise.h"
#include "haptics/voxel/voxelise.h"

#include <catch2/catch.hpp>

#include <random>

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

}  // namespace

TEST_CASE("voxmap: says what the grid says, for every voxel at every depth") {
    for (const int depth : {1, 2, 3}) {
        for (const VoxelFrame::Cell& n_cells : std::vector<VoxelFrame::Cell>{
                 {1, 1, 1}, {8, 8, 8}, {9, 3, 17}, {64, 5, 64}, {65, 70, 33}}) {
            const VoxelGrid grid = make_noise(n_cells);
            check_same(grid, Voxmap::build(grid, depth).value());
        }
        const VoxelGrid ball = make_ball(80);
        check_same(ball, Voxmap::build(ball, depth).value());
    }
}

TEST_CASE("voxmap: what is far outside is free") {
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
}

TEST_CASE("voxmap: the block's edge is the least power of two that covers the grid") {
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
