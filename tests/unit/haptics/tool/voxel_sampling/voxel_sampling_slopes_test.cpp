#include "haptics/base/processor.h"
#include "haptics/tool/voxel_sampling/voxel_lanes.h"
#include "tests/support/adding_load.h"
#include "tests/support/differentiated_loads.h"
#include "tests/support/wander.h"
#include "tests/unit/haptics/tool/voxel_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

// Points on the bottom of a small tool; each lies well within its voxel, pushing or braking.
Pointshell make_feet() {
    Pointshell shell;
    shell.add({-0.010, -0.0060, -0.010}, Vector3(0.2, 1.0, 0.1).normalized());
    shell.add({0.010, -0.0065, -0.010}, Vector3(-0.3, 1.0, 0.2).normalized());
    shell.add({0.010, -0.0055, 0.010}, Vector3(0.1, 1.0, -0.4).normalized());
    shell.add({-0.020, 0.0060, 0.020}, Vector3(0.1, 1.0, 0.3).normalized());
    shell.add({0.020, 0.0050, 0.010}, Vector3(0.0, 1.0, -0.3).normalized());
    return shell;
}

RigidState make_state() {
    RigidState state;
    state.pose_W = {{0.0045, -0.0015, 0.0055}, compute_exp({0.01, -0.02, 0.015})};
    state.velocity_W = {{0.05, -0.2, 0.03}, {0.4, -0.3, 0.2}};
    return state;
}

// The largest difference from central differences, over the largest entry of its 6 x 6.
double compare(const VoxelSamplingLoad& load, const RigidState& state = make_state()) {
    Wrench wrench;
    WrenchJacobian jacobian;
    load.add_linearised_wrench(state, 0.0, wrench, jacobian);
    double worst = 0.0;
    for (int column = 0; column < 12; ++column) {
        // Steps far above single precision and far below a voxel.
        const double step = column < 3 ? 5.0e-5 : column < 6 ? 5.0e-3 : column < 9 ? 5.0e-3 : 0.1;
        const auto find_at = [&](double by) {
            const RigidState changed = perturb(state, column % 6, column >= 6, by);
            const VoxelContact contact = load.compute_contact(changed, 0.0);
            REQUIRE(contact.n_surface == 3);
            REQUIRE(contact.n_proximity == 2);
            return find_wrench(load, changed);
        };
        const Vector6 difference = (find_at(step) - find_at(-step)) / (2.0 * step);
        const Matrix6& matrix = column < 6 ? jacobian.pose : jacobian.velocity;
        for (int first = 0; first < 6; first += 3) {
            const Matrix3 block = matrix.block<3, 3>(first, column % 6 < 3 ? 0 : 3);
            const double size = std::max(block.cwiseAbs().maxCoeff(), 1.0e-12);
            for (int row = first; row < first + 3; ++row) {
                worst = std::max(worst, std::abs(difference[row] - matrix(row, column % 6)) / size);
            }
        }
    }
    return worst;
}

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

// The derivatives that voxel sampling gives to implicit integrators.

TEST_CASE(
    "voxel sampling: derivatives are those of finite differences, springs, averages and brakes") {
    for (const ContactAveraging averaging :
         {ContactAveraging::none, ContactAveraging::beyond, ContactAveraging::smooth}) {
        VoxelSamplingSettings settings = plain();
        settings.averaging = averaging;
        settings.full_contacts = 2.0;
        settings.plane = TangentPlane::both_sides;
        settings.braking = PreContactBraking::viscous;
        settings.braking_Ns_per_m = 0.4;
        const VoxelSampling sampling = make_sampling(make_feet(), settings);
        // Laws of the second order in the turn: differences are off by some 1e-3 of the largest.
        CHECK(compare(VoxelSamplingLoad(sampling)) < 3.0e-3);
        CHECK(find_adding_error(VoxelSamplingLoad(sampling), make_state()) < 1.0e-12);
    }
}

TEST_CASE("voxel sampling: derivatives of brakes hold where the object turns") {
    VoxelSamplingSettings settings = plain();
    settings.stiffness_N_per_m = 0.0;
    settings.braking = PreContactBraking::viscous;
    settings.braking_Ns_per_m = 0.4;
    // In the object's eyes the tool moves as ever; in the world both go round besides.
    MovingFrame object;
    object.velocity_W = {{0.1, 0.2, -0.1}, {30.0, -20.0, 40.0}};
    RigidState state = make_state();
    state.velocity_W.linear += compute_velocity_at(object, state.pose_W.position);
    state.velocity_W.angular += object.velocity_W.angular;
    const VoxelSampling sampling = make_sampling(make_feet(), settings);
    VoxelSamplingLoad load(sampling);
    load.set_object(object, 0.0);
    REQUIRE(load.compute_contact(state, 0.0).brakes_W.force.norm() > 0.01);
    CHECK(compare(load, state) < 3.0e-3);
}

TEST_CASE("voxel sampling: springs and brakes apart are both together") {
    VoxelSamplingSettings settings = plain();
    settings.braking = PreContactBraking::one_cycle;
    const VoxelSampling sampling = make_sampling(make_feet(), settings);
    WrenchJacobian both;
    WrenchJacobian springs;
    WrenchJacobian brakes;
    const VoxelContact together = sampling.sample_linearised(make_state(), {}, both);
    const VoxelContact apart = sampling.sample_linearised(make_state(), {}, springs, brakes);
    CHECK(apart.wrench_W.force == together.wrench_W.force);
    CHECK(together.n_proximity == 2);
    // Without derivatives the same.
    const VoxelContact without = sampling.sample(make_state(), {});
    CHECK(together.wrench_W.force == without.wrench_W.force);
    CHECK(together.wrench_W.torque == without.wrench_W.torque);
    CHECK((springs.pose + brakes.pose - both.pose).norm() < 1.0e-12 * both.pose.norm());
    CHECK((springs.velocity + brakes.velocity).isApprox(both.velocity));
    CHECK(springs.velocity.isZero());
    CHECK_FALSE(brakes.velocity.isZero());
    // Without brakes it is the springs that are left.
    settings.braking = PreContactBraking::off;
    const Wrench spring = make_sampling(make_feet(), settings).sample(make_state(), {}).wrench_W;
    CHECK((apart.wrench_W.force - apart.brakes_W.force - spring.force).norm() < 1.0e-12);
    CHECK((apart.wrench_W.torque - apart.brakes_W.torque - spring.torque).norm() < 1.0e-12);
}

TEST_CASE("voxel sampling: a load adds to what there is, and its object moves on along its twist") {
    const VoxelSampling sampling = make_sampling(make_feet(), plain());
    VoxelSamplingLoad load(sampling);
    MovingFrame rising;
    rising.velocity_W = {{0.0, 0.5, 0.0}, Vector3::Zero()};
    load.set_object(rising, 1.0);
    RigidState state = make_state();
    const VoxelContact now = load.compute_contact(state, 1.0);
    REQUIRE(now.n_surface == 3);
    CHECK(find_adding_error(load, state, 1.0) < 1.0e-12);
    // A step later it is 0.5 mm higher: the same as a tool that much lower.
    const VoxelContact later = load.compute_contact(state, 1.001);
    state.pose_W.position.y() -= 0.0005;
    const VoxelContact lower = load.compute_contact(state, 1.0);
    CHECK((later.wrench_W.force - lower.wrench_W.force).norm() <
          1.0e-4 * lower.wrench_W.force.norm());
    CHECK(later.wrench_W.force.y() > now.wrench_W.force.y());
}

TEST_CASE("voxel sampling: slopes of brakes stay bounded where points slide along what brakes") {
    VoxelSamplingSettings settings = plain();
    settings.braking = PreContactBraking::one_cycle;
    settings.inertia = make_box_inertia(0.05, {0.04, 0.02, 0.04});
    Pointshell shell;
    shell.add({0.0, 0.005, 0.0}, Vector3::UnitY());
    const VoxelSampling sampling = make_sampling(shell, settings);
    const double most_Ns_per_m = 0.05 / (2.0 * settings.cycle_s * 1.0e-3);
    for (const double share : {1.0e-1, 1.0e-2, 1.0e-4, 1.0e-6}) {
        CAPTURE(share);
        RigidState state;
        state.pose_W = Pose::at({0.005, 0.0, 0.005});
        state.velocity_W.linear = {0.1, -0.1 * share, 0.0};
        WrenchJacobian jacobian;
        const VoxelContact contact = sampling.sample_linearised(state, {}, jacobian);
        REQUIRE(contact.n_proximity == 1);
        // What brakes is half the motion, however little of it goes into the layer.
        CHECK(contact.wrench_W.force.x() ==
              Approx(-0.05 * 0.1 / (2.0 * settings.cycle_s)).epsilon(0.01));
        const double slope = jacobian.velocity.topLeftCorner<3, 3>().cwiseAbs().maxCoeff();
        CHECK(slope > 0.9 * std::min(most_Ns_per_m, 0.05 / (2.0 * settings.cycle_s * share)));
        CHECK(slope < 1.01 * most_Ns_per_m);
    }
}

TEST_CASE("voxel lanes: every version gives the same bits, and the processor's widest is taken") {
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
    const auto all = voxel_lanes::all_kernels();
    REQUIRE(all[0] != nullptr);
    CHECK((all[1] != nullptr) == has_avx2());
    CHECK(&voxel_lanes::best_kernels() == (has_avx2() ? all[1] : all[0]));
}
