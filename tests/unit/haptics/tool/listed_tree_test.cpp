// The thesis' way of looking up, which benchmarks have beside ours, finds the same voxels and the same force.
#include "tests/support/listed_tree.h"

#include "haptics/math/rotation.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/gear.h"

#include <catch2/catch.hpp>

#include <random>

using namespace fulcrum;

TEST_CASE("listed tree: finds the surface voxels that the grid has, at both depths") {
    const auto gear = make_gear({}).value();
    const VoxelGrid grid = voxelise(gear, {.voxel_m = compute_voxel_m(gear, 40)}).value();
    for (const int depth : {1, 2}) {
        const test::ListedTree tree(grid, depth);
        std::mt19937 random(9);  // NOLINT(cert-msc51-cpp): the same each time
        std::uniform_real_distribution<double> unit(-1.1, 1.1);
        for (int i = 0; i < 20000; ++i) {
            const Vector3 p(0.05 * unit(random), 0.05 * unit(random), 0.012 * unit(random));
            const VoxelFrame::Cell cell = grid.frame.find_cell(p);
            const Vector3* const found = tree.find_surface(p);
            REQUIRE((found != nullptr) == (grid.find_class(cell) == VoxelClass::surface));
            REQUIRE((found == nullptr || (*found - grid.frame.centre_of(cell)).norm() < 1.0e-12));
        }
    }
}

TEST_CASE(
    "listed tree: the thesis' sum over all points is what voxel sampling gives with its settings") {
    const auto gear = make_gear({}).value();
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(gear, {.voxel_m = compute_voxel_m(gear, 40)}).value());
    const Pointshell shell = make_surface_pointshell(gear, 4000).value();
    VoxelSamplingSettings settings;
    settings.plane = TangentPlane::both_sides;
    settings.braking = PreContactBraking::off;
    settings.full_contacts = 70.0;
    const VoxelSampling sampling = VoxelSampling::build({grid, nullptr, shell, settings}).value();
    std::vector<Vector3> points;
    std::vector<Vector3> normals;
    for (std::size_t i = 0; i < shell.size(); ++i) {
        points.push_back(shell.position_T(i));
        normals.push_back(shell.normal_T(i));
    }
    const test::ListedTree tree(*grid, 1);
    for (const double apart_m : {0.097, 0.093, 0.06}) {
        RigidState state;
        state.pose_W = {{apart_m, 0.001, 0.002}, compute_exp({0.02, 0.01, 0.2})};
        const VoxelContact contact = sampling.sample(state, {});
        const Wrench listed = test::sample_listed(tree, points, normals, state.pose_W,
                                                  settings.stiffness_N_per_m, 70.0);
        REQUIRE(contact.n_surface > 0);
        // A point at a wall may count for the neighbour in single precision: one of some hundred at most.
        CHECK((contact.wrench_W.force - listed.force).norm() <
              1.0e-3 * (1.0 + listed.force.norm()));
        CHECK((contact.wrench_W.torque - listed.torque).norm() <
              1.0e-4 * (1.0 + listed.torque.norm()));
    }
}
