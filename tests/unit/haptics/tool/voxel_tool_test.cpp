#include "haptics/tool/voxel_tool.h"

#include "haptics/geometry/shape.h"
#include "tests/support/refused.h"
#include "tests/unit/haptics/tool/voxel_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kDt_s = 0.001;

VoxelToolSettings make_settings(ToolMass mass = ToolMass::massive) {
    VoxelToolSettings settings;
    settings.coupling.shift.stiffness_N_per_m = 400.0;
    settings.mass = mass;
    settings.inertia = make_box_inertia(0.05, {0.04, 0.02, 0.04});
    return settings;
}

// A block of 4 x 2 x 4 cm.
Pointshell make_block(int n_points = 800) {
    return make_surface_pointshell(make_box({0.04, 0.02, 0.04}).value(), n_points).value();
}

// It on the floor of the fixture.
VoxelTool make_tool(const VoxelToolSettings& settings) {
    VoxelSamplingSettings voxels;
    voxels.stiffness_N_per_m = 500.0;
    return VoxelTool::build({make_floor(), nullptr, make_block(), voxels}, settings).value();
}

MovingFrame handle_at(const Vector3& position) {
    return {Pose::at(position), {}};
}

// Presses the block down from 2 cm over the floor to `y` in a tenth of a second, and waits.
VoxelToolResult press(VoxelTool& tool, double y, int n_steps = 600) {
    tool.place(Pose::at({0.0, 0.03, 0.0}));
    VoxelToolResult result;
    for (int i = 1; i <= n_steps; ++i) {
        const double share = std::min(1.0, i / 100.0);
        result = tool.step(handle_at({0.0, 0.03 + share * (y - 0.03), 0.0}), {}, i * kDt_s, kDt_s);
    }
    return result;
}

}  // namespace

TEST_CASE(
    "voxel tool: pressed on the floor it stays out, and the hand feels what the floor pushes") {
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        VoxelTool tool = make_tool(make_settings(mass));
        const VoxelToolResult result = press(tool, -0.01);
        CHECK(result.contact.n_surface > 100);
        CHECK(result.contact.n_interior == 0);
        CHECK(tool.state().velocity_W.linear.norm() < 1.0e-3);
        // The handle is 1.4 cm too low, the spring is clamped at half a voxel: 400 N/m at 5 mm. Points of the block's
        // sides are in the layer too and push it sideways, until the coupling holds against them.
        CHECK(result.felt_W.force.norm() == Approx(2.0).epsilon(1.0e-3));
        CHECK(result.felt_W.force.y() > 1.8);
        CHECK((result.felt_W.force - result.contact.wrench_W.force).norm() < 0.01);
        CHECK(tool.state().pose_W.position.y() > 0.0);
        CHECK(tool.state().pose_W.position.y() < 0.01);
    }
}

TEST_CASE("voxel tool: every integrator leads to the same rest; free space feels as nothing") {
    for (const Integrator integrator : kIntegrators) {
        VoxelToolSettings settings = make_settings();
        settings.integrator.integrator = integrator;
        settings.inertia.mass_kg = 0.2;
        settings.inertia.moments_kg_m2 *= 4.0;
        VoxelTool tool = make_tool(settings);
        // Short of the clamp, which has no damping of its own in the explicit methods.
        const VoxelToolResult result = press(tool, 0.003, 1500);
        CHECK(result.step.moved());
        CHECK((result.felt_W.force - result.contact.wrench_W.force).norm() < 0.05);
        CHECK(result.felt_W.force.y() > 0.1);
    }
    for (const bool silent : {true, false}) {
        VoxelToolSettings settings = make_settings();
        settings.silent_in_free_space = silent;
        VoxelTool tool = make_tool(settings);
        tool.place(Pose::at({0.0, 0.05, 0.0}));
        // Half a metre a second sideways at once.
        const MovingFrame handle{Pose::at({0.0005, 0.05, 0.0}), {{0.5, 0.0, 0.0}, Vector3::Zero()}};
        const VoxelToolResult result = tool.step(handle, {}, kDt_s, kDt_s);
        CHECK((result.felt_W.force.norm() == 0.0) == silent);
        CHECK(result.contact.deepest() == VoxelClass::free);
    }
}

TEST_CASE("voxel tool: dampers and clamp follow mass and voxel where they are asked to") {
    const VoxelToolSettings settings = make_settings();
    const ToolCouplingSettings set = make_tool(settings).coupling();
    CHECK(set.clamp_m == Approx(0.5 * kVoxel_m));
    CHECK(set.shift.damping_Ns_per_m == Approx(2.0 * std::sqrt(0.05 * 400.0)));
    for (const int axis : {0, 1, 2}) {
        CHECK(set.turn.damping_Nms_per_rad[axis] ==
              Approx(2.0 * std::sqrt(settings.inertia.moments_kg_m2[axis] *
                                     set.turn.stiffness_Nm_per_rad)));
    }
    VoxelToolSettings own = settings;
    own.critically_damped = false;
    own.clamped_at_half_voxel = false;
    own.coupling.shift.damping_Ns_per_m = 1.25;
    CHECK(make_tool(own).coupling().clamp_m == 0.0);
    CHECK(make_tool(own).coupling().shift.damping_Ns_per_m == 1.25);
}

TEST_CASE(
    "voxel tool: a hand that goes on through the floor at an even speed leaves the tool on it") {
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        for (const double speed_m_per_s : {0.1, 0.3, 1.0}) {
            CAPTURE(mass, speed_m_per_s);
            VoxelTool tool = make_tool(make_settings(mass));
            tool.place(Pose::at({0.0, 0.04, 0.0}));
            VoxelToolResult result;
            for (int i = 1; i <= 600; ++i) {
                MovingFrame handle = handle_at({0.0, 0.04 - speed_m_per_s * i * kDt_s, 0.0});
                handle.velocity_W.linear.y() = -speed_m_per_s;
                result = tool.step(handle, {}, i * kDt_s, kDt_s);
            }
            CHECK(tool.state().pose_W.position.y() > 0.0);
            CHECK(result.contact.n_interior == 0);
            CHECK(result.felt_W.force.y() > 1.5);
        }
    }
}

TEST_CASE("voxel tool: a hand that turns on far leaves the tool on the floor") {
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        VoxelTool tool = make_tool(make_settings(mass));
        press(tool, 0.0);
        VoxelToolResult result;
        for (int i = 1; i <= 800; ++i) {
            MovingFrame handle = handle_at({0.0, 0.0, 0.0});
            const double angle = std::min(1.0, i / 400.0);
            handle.pose_W.orientation = compute_exp({0.0, 0.0, angle});
            result = tool.step(handle, {}, 1.0 + i * kDt_s, kDt_s);
        }
        CHECK(result.contact.n_interior == 0);
        const ToolCouplingSettings& set = tool.coupling();
        CHECK(set.clamp_rad == Approx(set.clamp_m / tool.sampling().reach_m()));
        CHECK(result.felt_W.torque.norm() <= 1.01 * set.turn.stiffness_Nm_per_rad * set.clamp_rad);
        CHECK(result.felt_W.torque.z() < 0.0);
    }
}

TEST_CASE("voxel tool: hand and object that move together feel as at rest") {
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        VoxelTool still = make_tool(make_settings(mass));
        const VoxelToolResult at_rest = press(still, 0.0, 1500);
        VoxelTool tool = make_tool(make_settings(mass));
        tool.place(Pose::at({0.0, 0.03, 0.0}));
        const Vector3 velocity(0.7, 0.4, -0.2);
        VoxelToolResult result;
        for (int i = 1; i <= 1500; ++i) {
            const Vector3 way = i * kDt_s * velocity;
            const double share = std::min(1.0, i / 100.0);
            const Twist moves{velocity, Vector3::Zero()};
            const MovingFrame handle{Pose::at(way + Vector3(0.0, 0.03 * (1.0 - share), 0.0)),
                                     moves};
            result = tool.step(handle, {Pose::at(way), moves}, i * kDt_s, kDt_s);
        }
        CHECK(result.contact.n_surface > 0);
        // The block's sides may rest against either side of their voxels.
        const Vector3 difference = result.felt_W.force.cwiseAbs() - at_rest.felt_W.force.cwiseAbs();
        CHECK(difference.norm() < 0.02);
        CHECK(result.contact.n_interior == 0);
    }
}

TEST_CASE("voxel tool: a massless tool is at the handle, where nothing is in the way") {
    VoxelToolSettings settings = make_settings(ToolMass::massless);
    settings.silent_in_free_space = false;
    VoxelTool tool = make_tool(settings);
    tool.place(Pose::at({0.0, 0.05, 0.0}));
    const Pose there{{0.002, 0.051, -0.001}, compute_exp({0.02, 0.0, 0.01})};
    const VoxelToolResult result = tool.step({there, {}}, {}, kDt_s, kDt_s);
    CHECK((tool.state().pose_W.position - there.position).norm() < 1.0e-6);
    CHECK(result.felt_W.force.norm() < 1.0e-3);
    CHECK(result.felt_W.torque.norm() < 1.0e-4);
    // And where the handle moves.
    tool.place(Pose::at({-0.03, 0.06, 0.0}));
    for (int i = 1; i <= 100; ++i) {
        const Vector3 at(-0.03 + 0.5 * i * kDt_s, 0.06, 0.0);
        const MovingFrame handle{Pose::at(at), {{0.5, 0.0, 0.0}, Vector3::Zero()}};
        (void)tool.step(handle, {}, i * kDt_s, kDt_s);
        REQUIRE((tool.state().pose_W.position - at).norm() < 1.0e-5);
    }
}

TEST_CASE("voxel tool: brakes reckon with the step that is made, and put no energy in") {
    for (const double dt_s : {0.0005, 0.001, 0.002}) {
        VoxelSamplingSettings voxels;
        voxels.braking = PreContactBraking::viscous;
        voxels.braking_Ns_per_m = 50.0;
        VoxelToolSettings settings = make_settings();
        settings.integrator.integrator = Integrator::semi_implicit_euler;
        VoxelTool tool =
            VoxelTool::build({make_floor(), nullptr, make_block(), voxels}, settings).value();
        tool.place(Pose::at({0.0, 0.0155, 0.0}));
        double fastest_m_per_s = 0.0;
        for (int i = 1; i <= 500; ++i) {
            (void)tool.step(handle_at({0.0, 0.0150, 0.0}), {}, i * dt_s, dt_s);
            fastest_m_per_s = std::max(fastest_m_per_s, tool.state().velocity_W.linear.norm());
        }
        CAPTURE(dt_s);
        CHECK(fastest_m_per_s < 0.05);
        CHECK(tool.state().velocity_W.linear.norm() < 1.0e-3);
    }
}

TEST_CASE(
    "voxel tool: a thin wall that comes fast carries the tool along, and the hand feels the "
    "clamp") {
    // The floor as a wall of two voxels that have no push, one that pushes and one that brakes.
    auto wall = std::make_shared<VoxelGrid>(*make_floor());
    for (std::int32_t z = 1; z < 15; ++z) {
        for (std::int32_t x = 1; x < 15; ++x) {
            for (std::int32_t y = 1; y < 5; ++y) {
                wall->cells[wall->index_of({x, y, z})] = VoxelClass::free;
            }
        }
    }
    const auto come = [&](double speed_m_per_s, const VoxelToolSettings& settings) {
        VoxelTool tool = VoxelTool::build({wall, nullptr, make_block(), {}}, settings).value();
        tool.place(Pose::at({0.0, 0.1, 0.0}));
        const Twist moves{{0.0, speed_m_per_s, 0.0}, Vector3::Zero()};
        bool is_passed = false;
        double most_N = 0.0;
        for (int i = 0; i * kDt_s * speed_m_per_s < 0.3; ++i) {
            const double height_m = i * kDt_s * speed_m_per_s;
            const VoxelToolResult result =
                tool.step(handle_at({0.0, 0.1, 0.0}), {Pose::at({0.0, height_m, 0.0}), moves},
                          i * kDt_s, kDt_s);
            // Some of its points may lie in the wall as it is carried; none of it stays behind.
            is_passed = is_passed || tool.state().pose_W.position.y() < height_m - kVoxel_m;
            most_N = std::max(most_N, result.felt_W.force.norm());
        }
        // 400 N/m at half a voxel.
        CHECK((most_N <= 2.0 * (1.0 + 1.0e-9)) == settings.lead_clamped);
        return !is_passed;
    };
    for (const ToolMass mass : {ToolMass::massive, ToolMass::massless}) {
        for (const double speed_m_per_s : {3.0, 15.0, 31.0, 60.0}) {
            CAPTURE(mass, speed_m_per_s);
            CHECK(come(speed_m_per_s, make_settings(mass)));
        }
    }
    // Without the look on the way it is passed at three voxels and more a step; with dampers as they are they are felt.
    VoxelToolSettings blind = make_settings();
    blind.swept = false;
    CHECK_FALSE(come(31.0, blind));
    VoxelToolSettings unclamped = make_settings();
    unclamped.lead_clamped = false;
    (void)come(0.5, unclamped);
}

TEST_CASE("voxel tool: objects that come near in the same step share the brake from that step on") {
    // One floor, or that floor two and three times over: it comes up to a tool that stands still in its braking layer.
    const MovingFrame rising{{}, {{0.05, 0.3, 0.0}, {0.0, 0.0, 0.2}}};
    for (const Integrator integrator :
         {Integrator::semi_implicit_euler, Integrator::backward_euler}) {
        VoxelToolSettings settings = make_settings();
        settings.integrator.integrator = integrator;
        std::vector<RigidState> after;
        for (const std::size_t n : {1U, 2U, 3U}) {
            const std::vector<VoxelSamplingPlan> plans(n,
                                                       {make_floor(), nullptr, make_block(), {}});
            VoxelTool tool = VoxelTool::build(plans, settings).value();
            tool.place(Pose::at({0.0, 0.015, 0.0}));
            const std::vector<MovingFrame> objects(n, rising);
            for (int i = 1; i <= 3; ++i) {
                (void)tool.move(handle_at({0.0, 0.015, 0.0}), objects, i * kDt_s, kDt_s);
            }
            Vector3 pushed_N = Vector3::Zero();
            for (const ToolTouch& touch : tool.touches()) {
                CHECK(touch.wrench_W.force == tool.touches()[0].wrench_W.force);
                pushed_N += touch.wrench_W.force;
            }
            CHECK(pushed_N.y() > 0.1);
            after.push_back(tool.state());
        }
        CHECK(after[0].velocity_W.linear.y() > 0.05);
        for (const RigidState& other : {after[1], after[2]}) {
            // Newton's steps end within 1e-7 of the motion.
            CHECK((other.velocity_W.linear - after[0].velocity_W.linear).norm() < 1.0e-6);
            CHECK((other.velocity_W.angular - after[0].velocity_W.angular).norm() < 1.0e-4);
        }
    }
}

TEST_CASE("voxel tool: bad settings are refused") {
    const auto takes = [](const VoxelToolSettings& settings) {
        return VoxelTool::build({make_floor(), nullptr, make_block(50), {}}, settings).has_value();
    };
    check_refused(
        make_settings(), takes,
        {[](auto& s) { s.static_iterations = 0; }, [](auto& s) { s.grip_T.y() = std::nan(""); },
         [](auto& s) { s.inertia.mass_kg = -1.0; },
         [](auto& s) { s.coupling.shift.stiffness_N_per_m = -1.0; },
         [](auto& s) { s.integrator.newton_iterations = 0; }});
    // A spring that saturates cannot be clamped too.
    VoxelToolSettings saturating = make_settings();
    saturating.coupling.shift.linear_range_m = 0.002;
    saturating.coupling.shift.saturation_range_m = 0.006;
    saturating.coupling.shift.saturation_force_N = 2.0;
    saturating.clamped_at_half_voxel = false;
    check_refused(saturating, takes, {[](auto& s) { s.clamped_at_half_voxel = true; }});
}
