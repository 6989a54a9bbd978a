#include "haptics/tool/field_sampling/field_load.h"

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/tool/field_sampling/field_slopes.h"
#include "haptics/tool/voxel_tool.h"
#include "tests/support/adding_load.h"
#include "tests/support/differentiated_loads.h"
#include "tests/support/field_parts.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

using namespace fulcrum;

namespace {

constexpr double kRadius_m = 0.1;

FieldSampler::Field make_ball(int n_along) {
    return test::make_field(make_sphere(kRadius_m, 12).value(), n_along);
}

// A ball about ten voxels thick, so that its field bends.
FieldSampler::Field small_ball() {
    static const FieldSampler::Field kField = make_ball(32);
    return kField;
}

// And one with much that is deeper than the band.
FieldSampler::Field large_ball() {
    static const FieldSampler::Field kField = make_ball(96);
    return kField;
}

FieldSampling make_sampling(const Pointshell& shell, ForceAlong along,
                            const FieldSampler::Field& field = small_ball()) {
    return FieldSampling::build(
               {field, test::make_shell(shell), {.stiffness_N_per_m = 200.0, .along = along}})
        .value();
}

MovingFrame make_object() {
    return {{{0.3, -0.2, 0.1}, compute_exp({0.4, 0.9, -0.3})}, {}};
}

RigidState make_state() {
    RigidState state;
    state.pose_W = {{0.28, -0.1, 0.12}, compute_exp({-0.2, 0.5, 1.1})};
    return state;
}

// Points some voxels inside the ball, give or take a half, well within their cells, as a tool in that state has them.
Pointshell make_inner_points(int n, double depth_voxels = 0.8,
                             const FieldSampler::Field& field = small_ball()) {
    const VoxelFrame& frame = field->frame();
    const Pose X_OT = make_object().pose_W.inverse() * make_state().pose_W;
    Random random(4);
    Pointshell shell;
    while (shell.size() < static_cast<std::size_t>(n)) {
        const Vector3 u = random.direction();
        const double depth_m = frame.voxel_m * (depth_voxels + 0.5 * random.uniform());
        const Vector3 p_O = (kRadius_m - depth_m) * u;
        const Vector3 g = frame.to_lattice(p_O);
        const Vector3 within = g - Vector3(g.cwiseFloor());
        // Of the bricks' centres too, between which the depth beyond the band is told.
        const Vector3 brick = g / 8.0 - Vector3::Constant(0.5);
        const Vector3 within_brick = brick - Vector3(brick.cwiseFloor());
        if (within.minCoeff() > 0.2 && within.maxCoeff() < 0.8 && within_brick.minCoeff() > 0.02 &&
            within_brick.maxCoeff() < 0.98) {
            shell.add(X_OT.inverse() * p_O, (random.direction() + 2.0 * u).normalized());
        }
    }
    return shell;
}

RigidState put_at(double x_m, double y_m = 0.0, double z_m = 0.0) {
    RigidState state;
    state.pose_W.position = {x_m, y_m, z_m};
    return state;
}

}  // namespace

TEST_CASE("field load: derivatives are those of finite differences, along normals and slopes") {
    // Shallow, and beyond the band.
    for (const auto& [along, is_deep] :
         {std::pair(ForceAlong::normals, false), std::pair(ForceAlong::slopes, false),
          std::pair(ForceAlong::normals, true), std::pair(ForceAlong::slopes, true)}) {
        const FieldSampler::Field field = is_deep ? large_ball() : small_ball();
        const FieldSampling sampling =
            make_sampling(make_inner_points(60, is_deep ? 12.0 : 0.8, field), along, field);
        FieldSamplingLoad load(sampling);
        load.set_object(make_object(), 0.0);
        Wrench wrench;
        WrenchJacobian jacobian;
        load.add_linearised_wrench(make_state(), 0.0, wrench, jacobian);
        CHECK(jacobian.velocity == Matrix6::Zero());
        Matrix6 differences;
        for (int column = 0; column < 6; ++column) {
            // A tenth of a voxel, for a turn at the farthest point: no point leaves its cell.
            const double way_m = 0.1 * sampling.frame().voxel_m;
            const double step = column < 3 ? way_m : way_m / sampling.reach_m();
            const auto find_at = [&](double by) {
                const RigidState state = test::perturb(make_state(), column, false, by);
                REQUIRE(load.compute_contact(state, 0.0).n_surface == 60);
                return test::find_wrench(load, state);
            };
            differences.col(column) = (find_at(step) - find_at(-step)) / (2.0 * step);
        }
        for (int row = 0; row < 6; row += 3) {
            for (int column = 0; column < 6; column += 3) {
                const Matrix3 given = jacobian.pose.block<3, 3>(row, column);
                const Matrix3 found = differences.block<3, 3>(row, column);
                // What is of third order in a tenth of a voxel, and single precision.
                CHECK((given - found).norm() < 3.0e-3 * found.norm());
            }
        }
    }
}

TEST_CASE("field load: with derivatives the wrench is the same, and both add to what there is") {
    const FieldSampling sampling = make_sampling(make_inner_points(60), ForceAlong::slopes);
    FieldSamplingLoad load(sampling);
    load.set_object(make_object(), 0.0);
    const VoxelContact contact = load.compute_contact(make_state(), 0.0);
    CHECK(contact.n_surface == 60);
    CHECK(contact.n_interior == 0);
    CHECK(contact.deepest() == VoxelClass::surface);
    Wrench plain;
    Wrench linearised;
    WrenchJacobian jacobian;
    load.add_wrench(make_state(), 0.0, plain);
    load.add_linearised_wrench(make_state(), 0.0, linearised, jacobian);
    CHECK(plain.force == contact.wrench_W.force);
    CHECK(plain.torque == contact.wrench_W.torque);
    CHECK(plain.force == linearised.force);
    CHECK(plain.torque == linearised.torque);
    CHECK(find_adding_error(load, make_state()) < 1.0e-12);
}

TEST_CASE("field load: along normals the force is continuous from voxel to voxel") {
    Pointshell shell;
    shell.add(Vector3::Zero(), -Vector3::UnitX());
    const FieldSampling sampling = make_sampling(shell, ForceAlong::normals);
    const double voxel_m = sampling.frame().voxel_m;
    constexpr int kSteps = 4000;
    double last_N = 0.0;
    double largest_N = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        // In on one side and out on the other, past the band.
        const double x = 1.2 * kRadius_m * (1.0 - 2.0 * i / kSteps);
        const double felt_N = sampling.sample(put_at(x, 0.013, 0.007), {}).wrench_W.force.x();
        const double way_m = 2.4 * kRadius_m / kSteps;
        REQUIRE(std::abs(felt_N - last_N) <
                200.0 * (small_ball()->slope_bound() * way_m + 1.0e-4 * voxel_m));
        largest_N = std::max(largest_N, std::abs(felt_N));
        last_N = felt_N;
    }
    CHECK(largest_N > 200.0 * small_ball()->band_m());
    CHECK(largest_N < 200.0 * kRadius_m);
}

TEST_CASE("field load: a touch begins at the surface, and a point as deep as the band is through") {
    Pointshell shell;
    shell.add(Vector3::Zero(), -Vector3::UnitX());
    const FieldSampling sampling = make_sampling(shell, ForceAlong::slopes);
    const auto look = [&](double x) { return sampling.sample(put_at(x), {}).deepest(); };
    const double voxel_m = sampling.frame().voxel_m;
    CHECK(look(kRadius_m + 0.5 * voxel_m) == VoxelClass::free);
    CHECK(look(kRadius_m - 0.5 * voxel_m) == VoxelClass::surface);
    CHECK(look(kRadius_m - 2.0 * voxel_m) == VoxelClass::surface);
    CHECK(look(kRadius_m - 4.0 * voxel_m) == VoxelClass::interior);
    CHECK(sampling.n_points() == 1);
    CHECK(sampling.memory_bytes() > small_ball()->memory_bytes());
}

TEST_CASE(
    "field load: every integrator lets a ball fall on a ball and rest on the spring of its "
    "points") {
    // Down on the pole, where what pushes is a spring upwards; a turn is held by a spring of its own.
    const Pointshell shell = make_surface_pointshell(make_sphere(0.02, 6).value(), 400).value();
    const FieldSampling sampling = make_sampling(shell, ForceAlong::normals);
    const Inertia inertia = make_ball_inertia(0.1, 0.02);
    for (const Integrator integrator : kIntegrators) {
        RigidState state = put_at(0.0, kRadius_m + 0.021);
        ToolCouplingSettings coupling;
        coupling.shift.stiffness_N_per_m = 100.0;
        coupling = make_critically_damped(coupling, inertia.mass_kg, inertia.moments_kg_m2);
        ToolCouplingLoad hold(coupling, Vector3::Zero());
        hold.set_handle({Pose::at({0.0, kRadius_m + 0.010, 0.0}), {}}, 0.0);
        FieldSamplingLoad field(sampling);
        const Loads loads(hold, field);
        IntegratorSettings settings;
        settings.integrator = integrator;
        for (int i = 0; i < 4000; ++i) {
            REQUIRE(step_rigid_body(settings, inertia, loads, 0.0, 5.0e-4, state).moved());
        }
        Wrench left;
        loads.add_wrench(state, 0.0, left);
        CHECK(left.force.norm() < 0.02);
        CHECK(state.velocity_W.linear.norm() < 2.0e-3);
        CHECK(field.compute_contact(state, 0.0).wrench_W.force.y() > 0.5);
    }
}

TEST_CASE("field load: what a budget left out is told; what cannot be is refused") {
    Random random(6);
    Pointshell shell;
    for (int i = 0; i < 20000; ++i) {
        const Vector3 out = random.direction();
        shell.add((kRadius_m - 0.3 * small_ball()->frame().voxel_m) * out, -out);
    }
    FieldSamplingPlan plan{small_ball(), test::make_shell(shell), {.clock = BudgetClock::counted}};
    const RigidState state = put_at(0.001);
    const VoxelContact exact = FieldSampling::build(plan)->sample(state, {});
    plan.settings.budget_us = 20.0;
    const VoxelContact contact = FieldSampling::build(plan)->sample(state, {});
    CHECK(exact.error_N == 0.0);
    CHECK(exact.error_Nm == 0.0);
    const double off_N = (contact.wrench_W.force - exact.wrench_W.force).norm();
    CHECK(off_N > 0.0);
    CHECK(contact.error_N >= off_N);
    CHECK(contact.error_Nm >= (contact.wrench_W.torque - exact.wrench_W.torque).norm());
    // A tool among two such objects tells both together, and of each its own.
    VoxelToolSettings settings;
    settings.inertia = make_ball_inertia(0.1, 0.02);
    FieldTool tool = FieldTool::build({plan, plan}, settings).value();
    tool.place(state.pose_W);
    const std::vector<MovingFrame> objects(2);
    static_cast<void>(tool.move({state.pose_W, {}}, objects, 1.0e-3, 1.0e-3));
    REQUIRE(tool.touches().size() == 2);
    CHECK(tool.touches()[0].error_N > 0.0);
    CHECK(tool.touches()[1].error_N > 0.0);
    CHECK_FALSE(FieldSampling::build({}));
    const auto tree =
        std::make_shared<const ShellTree>(ShellTree::build(make_inner_points(3)).value());
    CHECK_FALSE(FieldSampling::build({small_ball(), tree, {.stiffness_N_per_m = -1.0}}));
    CHECK(FieldSampling::build({small_ball(), tree, {}}));
}
