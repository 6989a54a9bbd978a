#include "haptics/voxel/voxel_frame.h"

#include <catch2/catch.hpp>

using fulcrum::Vector3;
using fulcrum::VoxelFrame;

namespace {

VoxelFrame make_frame() {
    VoxelFrame frame;
    frame.lower_O = {-1.0, 2.0, 0.5};
    frame.voxel_m = 0.25;
    frame.n_cells = {4, 8, 2};
    return frame;
}

}  // namespace

TEST_CASE("voxel frame: the cell of a centre is the cell itself, for all of them") {
    const VoxelFrame frame = make_frame();
    for (std::int32_t x = -2; x < 6; ++x) {
        for (std::int32_t y = -2; y < 10; ++y) {
            for (std::int32_t z = -2; z < 4; ++z) {
                const VoxelFrame::Cell cell{x, y, z};
                REQUIRE(frame.find_cell(frame.centre_of(cell)) == cell);
                const bool inside = x >= 0 && x < 4 && y >= 0 && y < 8 && z >= 0 && z < 2;
                REQUIRE(frame.contains(cell) == inside);
            }
        }
    }
}

TEST_CASE("voxel frame: the least corner is lattice 0, the greatest its number of cells") {
    const VoxelFrame frame = make_frame();
    CHECK(frame.to_lattice(frame.lower_O) == Vector3(0.0, 0.0, 0.0));
    CHECK(frame.to_lattice(frame.upper_O()) == Vector3(4.0, 8.0, 2.0));
    CHECK(frame.find_cell(frame.lower_O) == VoxelFrame::Cell{0, 0, 0});
    CHECK_FALSE(frame.contains(frame.find_cell(frame.upper_O())));
    CHECK(frame.find_cell(Vector3(-1.01, 2.0, 0.5)) == VoxelFrame::Cell{-1, 0, 0});
}
