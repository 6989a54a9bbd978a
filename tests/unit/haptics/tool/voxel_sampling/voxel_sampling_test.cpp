#include "haptics/tool/voxel_sampling/voxel_sampling.h"

#include "haptics/geometry/shape.h"
#include "haptics/voxel/voxelise.h"
#include "tests/support/refused.h"
#include "tests/unit/haptics/tool/voxel_fixture.h"

#include <catch2/catch.hpp>

#include <random>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

const MovingFrame kStill{};

RigidState at(const Vector3& position, const Vector3& turn = Vector3::Zero()) {
    RigidState state;
    state.pose_W = {position, compute_exp(turn)};
    return state;
}

Pointshell one_point(const Vector3& place, const Vector3& normal, int copies = 1) {
    Pointshell shell;
    for (int i = 0; i < copies; ++i) {
        shell.add(place, normal.normalized());
    }
    return shell;
}

RigidState moving(RigidState state, const Twist& velocity) {
    state.velocity_W = velocity;
    return state;
}

// What such points feel on the floor.
VoxelContact find_contact(const Pointshell& shell, const VoxelSamplingSettings& settings,
                          const RigidState& state) {
    return make_sampling(shell, settings).sample(state, kStill);
}

bool is_zero(const Wrench& wrench) {
    return wrench.force == Vector3::Zero() && wrench.torque == Vector3::Zero();
}

// Single precision places: 1e-6 of a voxel here, so 1e-6 of a force.
constexpr double kExact = 1.0e-5;

}  // namespace

TEST_CASE(
    "voxel sampling: a point is pushed along its normal by its depth under its voxel's plane") {
    const Vector3 place(0.03, 0.01, -0.02);
    const Vector3 normal = Vector3(0.3, 0.9, -0.2).normalized();
    const VoxelSampling sampling = make_sampling(one_point(place, normal), plain());
    // The point comes to (0.0021, -0.0088, 0.0063), in the voxel whose middle is (0.005, -0.005, 0.005).
    const Vector3 turn(0.2, -0.4, 0.3);
    const Vector3 p(0.0021, -0.0088, 0.0063);
    const Vector3 arm = compute_exp(turn) * place;
    const Vector3 n = compute_exp(turn) * normal;
    const double depth_m = n.dot(Vector3(0.005, -0.005, 0.005) - p);
    REQUIRE(depth_m > 0.001);
    const VoxelContact contact = sampling.sample(at(p - arm, turn), kStill);
    const Vector3 force = 100.0 * depth_m * n;
    CHECK((contact.wrench_W.force - force).norm() < kExact * force.norm());
    CHECK((contact.wrench_W.torque - arm.cross(force)).norm() < kExact * force.norm() * arm.norm());
    CHECK(contact.n_surface == 1);
    CHECK(contact.deepest() == VoxelClass::surface);
}

TEST_CASE(
    "voxel sampling: above its plane a point is not pulled, unless both sides are asked for") {
    VoxelSamplingSettings settings = plain();
    const Pointshell shell = one_point(Vector3::Zero(), Vector3::UnitY());
    const RigidState above = at({0.005, -0.002, 0.005});
    const VoxelContact contact = find_contact(shell, settings, above);
    CHECK(is_zero(contact.wrench_W));
    CHECK(contact.n_surface == 1);
    settings.plane = TangentPlane::both_sides;
    CHECK(find_contact(shell, settings, above).wrench_W.force.y() ==
          Approx(-100.0 * 0.003).epsilon(kExact));
}

TEST_CASE("voxel sampling: free, near, touching and inside; nothing far out or at no number") {
    const VoxelSampling sampling =
        make_sampling(one_point(Vector3::Zero(), Vector3::UnitY()), plain());
    const auto deepest = [&](double y) {
        const VoxelContact contact = sampling.sample(at({0.005, y, 0.005}), kStill);
        CHECK(is_zero(contact.wrench_W) == (contact.deepest() != VoxelClass::surface));
        return contact.deepest();
    };
    CHECK(deepest(0.011) == VoxelClass::free);
    CHECK(deepest(0.009) == VoxelClass::proximity);
    CHECK(deepest(-0.007) == VoxelClass::surface);
    CHECK(deepest(-0.011) == VoxelClass::interior);
    const VoxelSampling of_block = make_sampling(
        make_surface_pointshell(make_box({0.02, 0.02, 0.02}).value(), 100).value(), plain());
    for (const double far_m : {0.2, 1.0, 1.0e6, 1.0e300, HUGE_VAL}) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const double sign : {-1.0, 1.0}) {
                Vector3 place = Vector3::Constant(0.003);
                place[axis] = sign * far_m;
                const VoxelContact contact = of_block.sample(at(place, {0.1, 0.2, 0.3}), kStill);
                CHECK(is_zero(contact.wrench_W));
                CHECK(contact.deepest() == VoxelClass::free);
            }
        }
    }
    const VoxelContact nowhere = of_block.sample(at(Vector3::Constant(std::nan(""))), kStill);
    CHECK(is_zero(nowhere.wrench_W));
    CHECK(nowhere.deepest() == VoxelClass::free);
}

TEST_CASE("voxel sampling: beyond N contacts their sum counts as N; smoothly there is no corner") {
    VoxelSamplingSettings settings = plain();
    const auto push_N = [&settings](int n, double y = -0.0075) {
        const Pointshell shell = one_point(Vector3::Zero(), Vector3::UnitY(), n);
        return find_contact(shell, settings, at({0.005, y, 0.005})).wrench_W.force.y();
    };
    const double one_N = 0.25;  // 100 N/m at 2.5 mm
    CHECK(push_N(5) == Approx(5 * one_N).epsilon(kExact));
    CHECK(push_N(4000) == Approx(4000 * one_N).epsilon(kExact));
    settings.averaging = ContactAveraging::beyond;
    CHECK(push_N(9) == Approx(9 * one_N).epsilon(kExact));
    CHECK(push_N(10) == Approx(10 * one_N).epsilon(kExact));
    CHECK(push_N(11) == Approx(10 * one_N).epsilon(kExact));
    CHECK(push_N(4000) == Approx(10 * one_N).epsilon(kExact));
    settings.full_contacts = 70.0;
    CHECK(push_N(69) == Approx(69 * one_N).epsilon(kExact));
    CHECK(push_N(140) == Approx(70 * one_N).epsilon(kExact));
    // Half deep, each point counts for a half.
    settings.averaging = ContactAveraging::smooth;
    settings.full_contacts = 10.0;
    const auto expected_N = [one_N](int n) {
        return n * one_N * std::pow(1.0 + std::pow(0.05 * n, 4), -0.25);
    };
    for (const int n : {1, 9, 20, 21, 400}) {
        CHECK(push_N(n) == Approx(expected_N(n)).epsilon(kExact));
    }
    CHECK(push_N(4000) == Approx(20 * one_N).epsilon(1.0e-4));
}

TEST_CASE("voxel sampling: brakes act while a point approaches, and only in proximity") {
    VoxelSamplingSettings settings = plain();
    settings.braking = PreContactBraking::viscous;
    settings.braking_Ns_per_m = 3.0;
    const Vector3 place(0.02, 0.0, 0.01);
    const auto brake = [&](double y, const Twist& velocity) {
        const RigidState state = moving(at(Vector3(0.005, y, 0.005) - place), velocity);
        return find_contact(one_point(place, Vector3::UnitY()), settings, state).wrench_W;
    };
    // u = v + w x r, F = -b (-n.u/|u|) u.
    const Twist approaching{{0.3, -0.2, 0.1}, {0.5, 2.0, 1.0}};
    const Vector3 u = approaching.linear + approaching.angular.cross(place);
    const Vector3 force = 3.0 * (u.y() / u.norm()) * u;
    REQUIRE(u.y() < 0.0);
    const Wrench felt = brake(0.005, approaching);
    CHECK((felt.force - force).norm() < kExact * force.norm());
    CHECK((felt.torque - place.cross(force)).norm() < kExact * force.norm());
    CHECK(felt.force.dot(u) < 0.0);
    CHECK(is_zero(brake(0.005, {{0.3, 0.2, 0.1}, Vector3::Zero()})));
    CHECK(is_zero(brake(0.005, {{0.3, 0.0, 0.1}, Vector3::Zero()})));
    CHECK(is_zero(brake(0.005, {})));
    CHECK(is_zero(brake(0.015, approaching)));
    CHECK(is_zero(brake(-0.002, approaching)));
    settings.braking = PreContactBraking::off;
    CHECK(is_zero(brake(0.005, approaching)));
}

TEST_CASE(
    "voxel sampling: looking ahead, what glides along is not braked, and what comes is as ever") {
    VoxelSamplingSettings settings = plain();
    settings.braking = PreContactBraking::one_cycle;
    const Vector3 place(0.02, 0.0, 0.01);
    // A side's normal: its point leads a motion along x.
    const Pointshell leading = one_point(place, -Vector3::UnitX());
    const Pointshell below = one_point(place, Vector3::UnitY());
    const RigidState near = at(Vector3::Constant(0.005) - place);  // in proximity, 5 mm up
    const auto brake = [&](const Pointshell& shell, double look_ahead, const Vector3& velocity) {
        settings.look_ahead_cycles = look_ahead;
        return find_contact(shell, settings, moving(near, {velocity, Vector3::Zero()})).wrench_W;
    };
    // Along the floor McNeely's brake pulls; looking ahead nothing does, nor while the way there takes longer than the look.
    const Vector3 along(0.5, 0.0, 0.0);
    CHECK(brake(leading, 0.0, along).force.x() < -0.1);
    CHECK(is_zero(brake(leading, 2.0, along)));
    CHECK(is_zero(brake(below, 2.0, {0.0, -2.4, 0.0})));
    // Down, through what pushes within two steps, and also where one step and two end beyond it: the half way counts.
    for (const double speed_m_per_s : {2.6, 4.0, 9.0}) {
        const Vector3 down(0.1, -speed_m_per_s, 0.0);
        const Wrench as_ever = brake(below, 0.0, down);
        const Wrench ahead = brake(below, 2.0, down);
        CHECK(as_ever.force.y() > 0.1);
        CHECK(ahead.force == as_ever.force);
        CHECK(ahead.torque == as_ever.torque);
    }
    // With derivatives the same.
    settings.look_ahead_cycles = 2.0;
    WrenchJacobian jacobian;
    CHECK(is_zero(make_sampling(leading, settings)
                      .sample_linearised(moving(near, {along, Vector3::Zero()}), kStill, jacobian)
                      .wrench_W));
    CHECK(jacobian.velocity.isZero());
    settings.look_ahead_cycles = -1.0;
    CHECK_FALSE(validate(settings));
}

TEST_CASE(
    "voxel sampling: the one-cycle brake takes the motion's energy in one step, however many "
    "points") {
    VoxelSamplingSettings settings = plain();
    settings.braking = PreContactBraking::one_cycle;
    settings.inertia.mass_kg = 0.02;
    settings.cycle_s = 0.0005;
    for (const int n : {1, 7, 500}) {
        const RigidState state =
            moving(at({0.005, 0.005, 0.005}), {{0.1, -0.4, 0.2}, Vector3::Zero()});
        const VoxelContact contact =
            find_contact(one_point(Vector3::Zero(), Vector3(0.1, 1.0, 0.0), n), settings, state);
        const double taken_J =
            -contact.wrench_W.force.dot(state.velocity_W.linear) * settings.cycle_s;
        CHECK(taken_J ==
              Approx(0.5 * settings.inertia.mass_kg * state.velocity_W.linear.squaredNorm())
                  .epsilon(kExact));
        CHECK(contact.n_proximity == n);
    }
}

TEST_CASE(
    "voxel sampling: no brake throws the tool back, far from the middle or with many points") {
    for (const PreContactBraking braking :
         {PreContactBraking::viscous, PreContactBraking::one_cycle}) {
        VoxelSamplingSettings settings = plain();
        settings.braking = braking;
        settings.braking_Ns_per_m = 1.0e4;
        for (const double arm_m : {0.0, 0.01, 0.06}) {
            const Vector3 place(arm_m, 0.0, 0.0);
            const RigidState state =
                moving(at(Vector3::Constant(0.005) - place), {{0.1, -0.4, 0.05}, {0.0, 1.0, -2.0}});
            const Wrench brake =
                find_contact(one_point(place, Vector3::UnitY(), 40), settings, state).wrench_W;
            // One explicit step: less energy, and none where all of it was along the brake.
            RigidState next = state;
            const Inertia& inertia = settings.inertia;
            next.velocity_W.linear += settings.cycle_s / inertia.mass_kg * brake.force;
            next.velocity_W.angular +=
                settings.cycle_s * brake.torque.cwiseQuotient(inertia.moments_kg_m2);
            CHECK(brake.force.norm() > 0.1);
            CHECK(compute_kinetic_energy_J(inertia, next) <
                  compute_kinetic_energy_J(inertia, state));
            if (braking == PreContactBraking::viscous) {
                const double left = next.velocity_W.linear.dot(brake.force) +
                                    next.velocity_W.angular.dot(brake.torque);
                const double before = state.velocity_W.linear.dot(brake.force) +
                                      state.velocity_W.angular.dot(brake.torque);
                CHECK(std::abs(left) < 1.0e-4 * std::abs(before));
            }
        }
    }
}

TEST_CASE("voxel sampling: the same as all points one by one, and as every tree, in any pose") {
    const auto object = make_bumpy_sphere(0.05, 24, 0.15, 6.0).value();
    const auto grid = std::make_shared<const VoxelGrid>(
        voxelise(object, {.voxel_m = compute_voxel_m(object, 60)}).value());
    const Pointshell shell =
        make_surface_pointshell(make_box({0.03, 0.05, 0.02}).value(), 3001).value();
    const VoxelSampling dense = make_sampling(shell, plain(), grid);
    std::vector<VoxelSampling> trees;
    for (const int depth : {1, 2, 3}) {
        const auto map = std::make_shared<const Voxmap>(Voxmap::build(*grid, depth).value());
        trees.push_back(VoxelSampling::build({nullptr, map, shell, plain()}).value());
    }
    std::mt19937 random(5);  // NOLINT(cert-msc51-cpp): the same each time
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int n_touching = 0;
    for (int i = 0; i < 200; ++i) {
        const MovingFrame still{};
        const RigidState state = at(0.07 * Vector3(unit(random), unit(random), unit(random)),
                                    3.0 * Vector3(unit(random), unit(random), unit(random)));
        const VoxelContact contact = dense.sample(state, still);
        const Wrench expected = sum_plainly(*grid, shell, state.pose_W, 100.0);
        // A point within 1e-5 voxels of a wall may count for its neighbour: one in thirty thousand.
        const double one_N = 100.0 * grid->frame.voxel_m;
        REQUIRE((contact.wrench_W.force - expected.force).norm() <
                1.0e-4 * expected.force.norm() + 1.0e-3 * one_N);
        REQUIRE((contact.wrench_W.torque - expected.torque).norm() <
                1.0e-4 * expected.torque.norm() + 1.0e-3 * one_N * 0.03);
        n_touching += contact.n_surface > 0 ? 1 : 0;
        for (const VoxelSampling& tree : trees) {
            const VoxelContact other = tree.sample(state, still);
            REQUIRE(other.wrench_W.force == contact.wrench_W.force);
            REQUIRE(other.wrench_W.torque == contact.wrench_W.torque);
            REQUIRE(other.n_interior == contact.n_interior);
        }
    }
    CHECK(n_touching > 80);
}

TEST_CASE(
    "voxel sampling: tool and object carried through the world together feel the same, turned") {
    VoxelSamplingSettings settings = plain();
    settings.braking = PreContactBraking::viscous;
    const VoxelSampling sampling = make_sampling(
        make_surface_pointshell(make_box({0.06, 0.02, 0.04}).value(), 500).value(), settings);
    RigidState state = at({0.0031, 0.0042, -0.0013}, {0.1, 0.4, -0.05});
    state.velocity_W = {{0.1, -0.3, 0.2}, {0.5, -0.4, 0.7}};
    const VoxelContact here = sampling.sample(state, kStill);
    REQUIRE(here.n_surface > 10);
    REQUIRE(here.n_proximity > 10);
    // Both turned and shifted; and both moving on a carousel besides.
    const Pose X{{2.0, -1.0, 0.5}, compute_exp({0.7, -0.9, 0.3})};
    const Twist carousel{{0.4, 0.1, -0.2}, {1.0, 2.0, -1.5}};
    const MovingFrame object{X, carousel};
    RigidState moved;
    moved.pose_W = X * state.pose_W;
    const Vector3 arm = moved.pose_W.position - X.position;
    moved.velocity_W.linear =
        X.orientation * state.velocity_W.linear + carousel.linear + carousel.angular.cross(arm);
    moved.velocity_W.angular = X.orientation * state.velocity_W.angular + carousel.angular;
    const VoxelContact there = sampling.sample(moved, object);
    CHECK((there.wrench_W.force - X.orientation * here.wrench_W.force).norm() <
          1.0e-4 * here.wrench_W.force.norm());
    CHECK((there.wrench_W.torque - X.orientation * here.wrench_W.torque).norm() <
          1.0e-4 * here.wrench_W.force.norm() * 0.03);
    CHECK(there.n_surface == here.n_surface);
}

TEST_CASE("voxel sampling: the slowest motion is braked by nothing; bad plans are refused") {
    for (const PreContactBraking braking :
         {PreContactBraking::viscous, PreContactBraking::one_cycle}) {
        VoxelSamplingSettings settings = plain();
        settings.braking = braking;
        const Pointshell shell =
            make_surface_pointshell(make_box({0.02, 0.02, 0.02}).value(), 100).value();
        const VoxelSampling sampling = make_sampling(shell, settings);
        for (const double speed_m_per_s : {1.0e-300, 1.0e-40, 1.0e-26, 1.0e-20, 1.0e-12}) {
            RigidState state;
            state.pose_W.position = {0.0, 0.015, 0.0};
            state.velocity_W.linear = {0.0, -speed_m_per_s, 0.0};
            WrenchJacobian jacobian;
            const VoxelContact contact = sampling.sample_linearised(state, {}, jacobian);
            REQUIRE(contact.n_proximity > 0);
            CHECK(contact.wrench_W.force.allFinite());
            CHECK(contact.wrench_W.force.norm() < 1.0e-6);
            CHECK(jacobian.velocity.allFinite());
        }
    }
    const Pointshell shell = one_point(Vector3::Zero(), Vector3::UnitY());
    CHECK_FALSE(VoxelSampling::build({nullptr, nullptr, shell, plain()}));
    CHECK_FALSE(VoxelSampling::build({make_floor(), nullptr, {}, plain()}));
    CHECK_FALSE(VoxelSampling::build(
        {make_floor(), nullptr, one_point({0.0, std::nan(""), 0.0}, Vector3::UnitY()), plain()}));
    Pointshell uneven = shell;
    uneven.nz.clear();
    CHECK_FALSE(VoxelSampling::build({make_floor(), nullptr, uneven, plain()}));
    VoxelGrid open = *make_floor();
    open.cells[open.index_of({15, 3, 4})] = VoxelClass::surface;
    CHECK_FALSE(
        VoxelSampling::build({std::make_shared<const VoxelGrid>(open), nullptr, shell, plain()}));
    check_refused(
        plain(),
        [&](const VoxelSamplingSettings& settings) {
            return VoxelSampling::build({make_floor(), nullptr, shell, settings}).has_value();
        },
        {[](auto& s) { s.stiffness_N_per_m = -1.0; }, [](auto& s) { s.full_contacts = 0.5; },
         [](auto& s) { s.braking_Ns_per_m = std::nan(""); },
         [](auto& s) { s.inertia.mass_kg = 0.0; }, [](auto& s) { s.cycle_s = 0.0; }});
}
