#include "haptics/tool/voxel_lanes.h"

#include "haptics/base/processor.h"
#include "tests/support/wander.h"
#include "tests/unit/haptics/tool/voxel_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

// Points all over a cube of ten voxels, in voxels.
voxel_lanes::Shell make_shell(Random& random) {
    voxel_lanes::Shell shell;
    shell.n_points = 3 * voxel_lanes::kChunk / 2;
    for (std::size_t i = 0; i < shell.n_points; ++i) {
        const Vector3 place = 5.0 * random.in_cube();
        const Vector3 normal = random.direction();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            shell.place[axis].push_back(static_cast<float>(place[static_cast<Index>(axis)]));
            shell.normal[axis].push_back(static_cast<float>(normal[static_cast<Index>(axis)]));
        }
    }
    return shell;
}

// About the floor's middle, on the move.
voxel_lanes::Motion draw_motion(Random& random) {
    voxel_lanes::Motion motion;
    const Matrix3 turn = random.turn(3.0).toRotationMatrix();
    const auto draw = [&](float middle, double size) {
        const Vector3 v = size * random.in_cube();
        return std::array<float, 3>{middle + static_cast<float>(v.x()),
                                    middle + static_cast<float>(v.y()),
                                    middle + static_cast<float>(v.z())};
    };
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            motion.turn[row][column] =
                static_cast<float>(turn(static_cast<Index>(row), static_cast<Index>(column)));
        }
    }
    motion.shift = draw(8.0F, 6.0);
    motion.last = {15.5F, 15.5F, 15.5F};
    motion.velocity_T = draw(0.0F, 30.0);
    motion.spin_T = draw(0.0F, 3.0);
    motion.object_spin_T = draw(0.0F, 1.0);
    motion.least_depth = random.uniform() > 0.0 ? 0.0F : -1.0F;
    motion.brakes = random.uniform() > -0.5;
    motion.ahead_s = random.uniform() > 0.0 ? 0.0F : 0.02F;
    return motion;
}

void require_same(const voxel_lanes::Sums& a, const voxel_lanes::Sums& b) {
    REQUIRE(a.push == b.push);
    REQUIRE(a.fullness == b.fullness);
    REQUIRE(a.brake == b.brake);
    REQUIRE(a.brake_share == b.brake_share);
    REQUIRE(a.n_surface == b.n_surface);
    REQUIRE(a.n_interior == b.n_interior);
    REQUIRE(a.n_proximity == b.n_proximity);
    REQUIRE(a.push_by_pose == b.push_by_pose);
    REQUIRE(a.fullness_by_pose == b.fullness_by_pose);
    REQUIRE(a.brake_by.pose == b.brake_by.pose);
    REQUIRE(a.brake_by.velocity == b.brake_by.velocity);
}

}  // namespace

TEST_CASE("voxel lanes: every version gives the same bits, by grid and by tree") {
    Random random(7);
    const voxel_lanes::Shell shell = make_shell(random);
    const auto grid = test::make_floor();
    const Voxmap map = Voxmap::build(*grid, 2).value();
    std::int64_t n_surface = 0;
    double brake_share = 0.0;
    for (int k = 0; k < 100; ++k) {
        const voxel_lanes::Motion motion = draw_motion(random);
        const bool linear = k % 2 == 1;
        voxel_lanes::Sums plain;
        voxel_lanes::all_kernels()[0]->sample_grid(shell, *grid, motion, linear, plain);
        for (const voxel_lanes::Kernels* kernels : voxel_lanes::all_kernels()) {
            if (kernels == nullptr) {
                continue;
            }
            INFO(kernels->name << ", motion " << k);
            voxel_lanes::Sums by_grid;
            kernels->sample_grid(shell, *grid, motion, linear, by_grid);
            require_same(by_grid, plain);
            voxel_lanes::Sums by_tree;
            kernels->sample_tree(shell, map, motion, linear, by_tree);
            require_same(by_tree, plain);
        }
        n_surface += plain.n_surface;
        brake_share += plain.brake_share;
    }
    CHECK(n_surface > 1000);
    CHECK(brake_share > 100.0);
}

TEST_CASE("voxel lanes: the widest that the processor has is taken") {
    const auto all = voxel_lanes::all_kernels();
    REQUIRE(all[0] != nullptr);
    CHECK((all[1] != nullptr) == has_avx2());
    CHECK(&voxel_lanes::best_kernels() == (has_avx2() ? all[1] : all[0]));
}
