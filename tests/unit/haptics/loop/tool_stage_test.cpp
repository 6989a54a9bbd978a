#include "haptics/loop/tool_stage.h"

#include "haptics/math/rotation.h"
#include "tests/support/tool_scene.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kStiffness_N_per_m = 400.0;
constexpr double kTop_m = 0.05;  // well over where the tool begins to feel the floor

// A box of 20 x 4 x 20 cm whose top is at height 0, and a ball of 2 cm, held `grip` from its middle.
HapticPlan make_floor(const Vector3& grip_T = Vector3::Zero(), double scale = 1.0,
                      ToolMethod method = ToolMethod::field_sampling) {
    HapticPlan plan;
    plan.safety.soft_start_s = 0.0;
    plan.safety.max_slew_N_per_s = 5000.0;
    plan.safety.max_torque_Nm = 1.0;
    plan.workspace.scale = scale;
    plan.solids.push_back({.body = 3,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0, -0.02, 0))});
    ToolScene scene = make_ball_tool(method);
    scene.settings.grip_T = grip_T;
    scene.settings.coupling.shift.stiffness_N_per_m = kStiffness_N_per_m / scale;
    plan.tool = make_tool_of(scene, {make_box({0.2, 0.04, 0.2}).value()});
    return plan;
}

// Slowly to a place in the hand's metres, and a second of rest there.
void go(Bench& bench, const Vector3& to_D) {
    const Vector3 from_D = bench.device.pose_D.position;
    for (int i = 1; i <= 300; ++i) {
        bench.device.pose_D.position = from_D + i / 300.0 * (to_D - from_D);
        bench.run(1);
    }
    bench.run(1000);
}

// Held over the floor until the gate is open.
void begin(Bench& bench, double scale = 1.0) {
    bench.device.pose_D = Pose::at(Vector3(0, kTop_m / scale, 0));
    bench.run(200);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
}

ToolRound make_round(const Vector3& hand_W, std::span<const Pose> solids_W, double now_s) {
    return {
        .hand = {Pose::at(hand_W), {}}, .solid_poses_W = solids_W, .now_s = now_s, .dt_s = kDt_s};
}

}  // namespace

TEST_CASE("tool stage: free space gives exactly nothing, however the hand moves and turns") {
    Bench bench(make_floor());
    begin(bench);
    for (int i = 0; i < 500; ++i) {
        const double t = 0.01 * i;
        bench.device.pose_D = {Vector3(0.05 * std::sin(t), 0.06 + 0.01 * std::sin(3 * t), 0.0),
                               compute_exp(Vector3(std::sin(t), std::cos(2 * t), 0.3))};
        bench.run(1);
        REQUIRE(bench.loop.state().commanded_W.force == Vector3::Zero());
        REQUIRE(bench.loop.state().commanded_W.torque == Vector3::Zero());
        REQUIRE(bench.loop.state().touched_body == kNoBody);
    }
    CHECK(bench.loop.state().faults == Fault::none);
}

TEST_CASE(
    "tool stage: pressed on a floor the tool stays outside, and the hand feels the coupling's "
    "stretch") {
    for (const ToolMethod method :
         {ToolMethod::field_sampling, ToolMethod::voxel_sampling, ToolMethod::implicit_penalty}) {
        Bench bench(make_floor(Vector3::Zero(), 1.0, method));
        begin(bench);
        go(bench, Vector3(0.01, 0.016, 0.0));
        const HapticState& state = bench.loop.state();
        const Vector3 stretch_W = state.proxy_position_W - state.tool_pose_W.position;
        CHECK(state.touched_body == 3);
        // The ball's radius is 2 cm: its middle is no lower but for what its points are pressed in, and at most two voxels higher.
        CHECK(state.proxy_position_W.y() > 0.0193);
        CHECK(state.proxy_position_W.y() < 0.029);
        CHECK(stretch_W.y() > 0.002);
        CHECK((state.applied_W.force - kStiffness_N_per_m * stretch_W).norm() < 0.01);
        CHECK(state.applied_W.force.y() ==
              Approx(kStiffness_N_per_m * stretch_W.y()).epsilon(1e-2));
    }
}

TEST_CASE("tool stage: no hand presses the tool through; it feels the limit") {
    for (const ToolMethod method :
         {ToolMethod::field_sampling, ToolMethod::voxel_sampling, ToolMethod::implicit_penalty}) {
        Bench bench(make_floor(Vector3::Zero(), 1.0, method));
        begin(bench);
        go(bench, Vector3(0.0, -0.03, 0.0));
        CHECK(bench.loop.state().proxy_position_W.y() > 0.019);
        CHECK(bench.loop.state().applied_W.force.y() == Approx(5.0).epsilon(2e-2));
    }
}

TEST_CASE("tool stage: the torque about the grip is r x F, in the hand's metres") {
    for (const double scale : {1.0, 4.0}) {
        // Held 3 cm at its right: pressed down, the ball at the left pushes up.
        Bench bench(make_floor(Vector3(0.03, 0, 0), scale));
        begin(bench, scale);
        go(bench, Vector3(0.03, 0.016, 0.0) / scale);
        const HapticState& state = bench.loop.state();
        const Pose tool_W{state.proxy_position_W, state.proxy_orientation_W};
        const Vector3 ball_W = tool_W * Vector3(-0.03, 0, 0);
        const Vector3 contact_W = ball_W - Vector3(0, 0.02, 0);
        const Vector3 r_W = contact_W - tool_W.position;
        const Vector3 expected = r_W.cross(state.applied_W.force) / scale;
        REQUIRE(state.applied_W.force.y() > 0.3);
        CHECK(state.applied_W.torque.z() == Approx(expected.z()).epsilon(0.03));
        CHECK(state.applied_W.torque.z() < -0.005 / scale);
    }
}

TEST_CASE("tool stage: a hand that turns turns the tool") {
    Bench bench(make_floor());
    begin(bench);
    const Quaternion turned = compute_exp(Vector3(0.0, 0.0, 0.6));
    for (int i = 1; i <= 400; ++i) {
        bench.device.pose_D.orientation = compute_exp(Vector3(0.0, 0.0, 0.6 * i / 400.0));
        bench.run(1);
    }
    bench.run(200);
    CHECK(bench.loop.state().proxy_orientation_W.angularDistance(turned) < 1e-3);
}

TEST_CASE("tool stage: a hand that begins in a solid feels nothing until it is out") {
    Bench bench(make_floor());
    bench.device.pose_D = Pose::at(Vector3(0, 0.005, 0));
    bench.run(500);
    CHECK(bench.loop.state().commanded_W.force == Vector3::Zero());
    CHECK(bench.loop.state().proxy_position_W == Vector3(0, 0.005, 0));
    go(bench, Vector3(0, kTop_m, 0));
    go(bench, Vector3(0, 0.015, 0));
    CHECK(bench.loop.state().applied_W.force.y() > 1.0);
}

TEST_CASE(
    "tool stage: stale poses, jumps, stops and a failed lesson let the tool go; it is felt again "
    "from outside") {
    for (int kind = 0; kind < 5; ++kind) {
        Bench bench(make_floor());
        begin(bench);
        const Vector3 pressed(0.0, 0.015, 0.0);
        go(bench, pressed);
        REQUIRE(bench.loop.state().applied_W.force.y() > 1.0);
        switch (kind) {
            case 0:
                bench.device.age_s = 0.03;
                break;
            case 1:
                bench.device.pose_D.position = Vector3(0.05, 0.015, 0.0);  // 50 m/s
                break;
            case 2:
                bench.channels->emergency_stop.press();
                break;
            case 3:
                bench.command.lesson_alive = false;
                break;
            default:
                bench.device.pose_D.position.x() = std::numeric_limits<double>::quiet_NaN();
        }
        bench.run(1);
        CHECK(bench.loop.state().faults != Fault::none);
        CHECK(bench.loop.state().commanded_W.force == Vector3::Zero());
        bench.run(150);
        CHECK(bench.device.written_D.force == Vector3::Zero());
        CHECK(bench.device.written_D.torque == Vector3::Zero());
        // All is well again, with the hand still in the floor: nothing yet.
        bench.device.age_s = 0.0;
        bench.device.pose_D.position = pressed;
        bench.command.lesson_alive = true;
        bench.channels->emergency_stop.release();
        bench.run(200);
        bench.channels->rearm.store(true);
        bench.run(200);
        CHECK(bench.loop.state().commanded_W.force == Vector3::Zero());
        CHECK(bench.loop.state().faults == Fault::none);
        // From outside it is felt as before.
        go(bench, Vector3(0, kTop_m, 0));
        go(bench, pressed);
        CHECK(bench.loop.state().applied_W.force.y() > 1.0);
    }
}

TEST_CASE("tool stage: a solid that moves takes the tool along and pushes the hand") {
    HapticPlan plan = make_floor();
    plan.expects_world = true;
    Bench bench(plan);
    const Pose start = Pose::at(Vector3(0, -0.02, 0));
    bench.world.solid_poses_W[0] = start;
    begin(bench);
    go(bench, Vector3(0.0, 0.0195, 0.0));
    // 5 mm up in half a second.
    for (int i = 1; i <= 500; ++i) {
        bench.world.solid_poses_W[0].position.y() = -0.02 + 1.0e-5 * i;
        bench.run(1);
    }
    bench.run(500);
    const HapticState& state = bench.loop.state();
    CHECK(state.proxy_position_W.y() > 0.024);
    CHECK(state.applied_W.force.y() > 0.3);
    // Put elsewhere at once, it leaves the hand alone; a pose that is no number is a fault.
    bench.world.solid_placements[0] += 1;
    bench.world.solid_poses_W[0].position.y() = 0.0;
    bench.run(3);
    CHECK(state.commanded_W.force == Vector3::Zero());
    bench.world.solid_poses_W[0].position.y() = std::nan("");
    bench.run(1);
    CHECK(saw(bench, Fault::command_invalid));
    CHECK(state.commanded_W.force == Vector3::Zero());
}

TEST_CASE("tool stage: a solid's velocity is the way between two places it was told to be at") {
    const HapticPlan plan = make_floor();
    const auto stage = make_tool_stage(plan);
    REQUIRE(stage);
    const Pose still[] = {plan.solids[0].initial_pose_W};
    for (int i = 1; i <= 5; ++i) {
        (void)stage->step(make_round(Vector3(0, 0.06, 0), still, i * kDt_s));
    }
    CHECK(stage->solid() == kNoBody);
    CHECK_FALSE(stage->pushes()[0].touches);
    // Without poses in a round there is no force, and the tool is with the hand.
    const ToolForce none = stage->step(make_round(Vector3(0, 0.01, 0), {}, 6 * kDt_s));
    CHECK(none.wrench_W.force == Vector3::Zero());
    CHECK_FALSE(none.failed);
    CHECK(stage->pose_W().position == Vector3(0, 0.01, 0));
}

TEST_CASE(
    "tool stage: what the tool does to a solid is the other side of what the solid does to the "
    "tool") {
    const HapticPlan plan = make_floor(Vector3(0.03, 0, 0));
    const auto stage = make_tool_stage(plan);
    const Pose solids[] = {plan.solids[0].initial_pose_W};
    ToolForce felt;
    for (int i = 1; i <= 2000; ++i) {
        const double down = std::min(1.0, i / 1000.0);
        felt = stage->step(make_round(Vector3(0.03, kTop_m - 0.034 * down, 0), solids, i * kDt_s));
    }
    const SolidPush& push = stage->pushes()[0];
    REQUIRE(push.touches);
    CHECK(stage->solid() == 0);
    REQUIRE(felt.wrench_W.force.norm() > 0.3);
    CHECK((push.force_W + felt.wrench_W.force).norm() < 1e-12);
    // About the grip it has the torque that the hand feels, the other way round.
    const Vector3 about_grip_W =
        (push.at_W - stage->pose_W().position).cross(push.force_W) + push.couple_W;
    CHECK((about_grip_W + felt.wrench_W.torque).norm() < 1e-12);
    // Its line passes through where the ball touches.
    const Vector3 ball_W = Pose{stage->pose_W()} * Vector3(-0.03, 0, 0);
    const Vector3 beside_W = (push.at_W - ball_W).cross(push.force_W.normalized());
    CHECK(beside_W.norm() < 0.002);
}

TEST_CASE("tool stage: of two solids that are pressed each has its share of what is felt") {
    HapticPlan plan = make_floor();
    plan.solids.push_back({.body = 9,
                           .shape = BoxShape{Vector3(0.02, 0.1, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0.05, 0.1, 0))});
    plan.tool =
        make_tool_of(make_ball_tool(ToolMethod::field_sampling),
                     {make_box({0.2, 0.04, 0.2}).value(), make_box({0.04, 0.2, 0.2}).value()});
    const auto stage = make_tool_stage(plan);
    const Pose solids[] = {plan.solids[0].initial_pose_W, plan.solids[1].initial_pose_W};
    ToolForce felt;
    for (int i = 1; i <= 2000; ++i) {
        const double share = std::min(1.0, i / 1000.0);
        const Vector3 hand_W = Vector3(0, kTop_m, 0) + share * Vector3(0.013, 0.016 - kTop_m, 0);
        felt = stage->step(make_round(hand_W, solids, i * kDt_s));
    }
    const std::span<const SolidPush> pushes = stage->pushes();
    REQUIRE((pushes[0].touches && pushes[1].touches));
    CHECK(pushes[0].force_W.y() < -0.5);
    CHECK(pushes[1].force_W.x() > 0.5);
    CHECK(std::abs(pushes[0].force_W.x()) < 0.05);
    CHECK((pushes[0].force_W + pushes[1].force_W + felt.wrench_W.force).norm() < 0.02);
    CHECK(stage->solid() == (pushes[0].force_W.norm() > pushes[1].force_W.norm() ? 0 : 1));
}

TEST_CASE("tool stage: twisted between two solids, each is pushed with what turns the hand back") {
    // A bar of 10 cm whose right end turns down on a floor and whose left end turns up under a ceiling.
    HapticPlan plan = make_floor();
    plan.solids[0].initial_pose_W = Pose::at(Vector3(0.04, -0.026, 0.0));
    plan.solids.push_back({.body = 9,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(-0.04, 0.026, 0.0))});
    ToolScene scene = make_ball_tool(ToolMethod::field_sampling);
    scene.tool = make_box({0.1, 0.01, 0.01}).value();
    scene.voxel_m = 0.002;
    const TriangleMesh block = make_box({0.06, 0.04, 0.2}).value();
    plan.tool = make_tool_of(scene, {block, block});
    const auto stage = make_tool_stage(plan);
    const Pose solids[] = {plan.solids[0].initial_pose_W, plan.solids[1].initial_pose_W};
    double most_N = 0.0;
    double most_turn_Nm = 0.0;
    int n_both = 0;
    for (int i = 1; i <= 3000; ++i) {
        ToolRound round = make_round(Vector3::Zero(), solids, i * kDt_s);
        round.hand.pose_W.orientation = compute_exp(Vector3(0.0, 0.0, -2.0e-4 * i));
        const ToolForce felt = stage->step(round);
        const std::span<const SolidPush> pushes = stage->pushes();
        if (!pushes[0].touches || !pushes[1].touches) {
            continue;
        }
        ++n_both;
        most_turn_Nm = std::max(most_turn_Nm, felt.wrench_W.torque.norm());
        Vector3 force_W = felt.wrench_W.force;
        Vector3 torque_W = felt.wrench_W.torque;
        for (const SolidPush& push : pushes) {
            most_N = std::max(most_N, push.force_W.norm());
            force_W += push.force_W;
            torque_W += (push.at_W - stage->pose_W().position).cross(push.force_W) + push.couple_W;
        }
        // Together they are what the hand feels, at each moment.
        CHECK(force_W.norm() < 1.0e-9);
        CHECK(torque_W.norm() < 1.0e-9);
    }
    REQUIRE(n_both > 1000);
    REQUIRE(most_turn_Nm > 0.02);
    // Pushed at some 2 cm to 5 cm from the middle.
    CHECK(most_N > most_turn_Nm / 0.1);
    CHECK(most_N < 1.5 * most_turn_Nm / 0.04);
    CHECK(stage->pushes()[0].force_W.y() < 0.0);
    CHECK(stage->pushes()[1].force_W.y() > 0.0);
}

TEST_CASE("tool stage: its energy is watched, in both ports") {
    Bench bench(make_floor(Vector3(0.03, 0, 0)));
    begin(bench);
    go(bench, Vector3(0.03, 0.016, 0.0));
    CHECK(has_torques(make_floor()));
    // Slowly pressed and let go, the hand gets no more back than it gave, but for rounding and the observer's own error.
    go(bench, Vector3(0.03, kTop_m, 0.0));
    CHECK(bench.loop.state().force_energy.peak_J < 1e-3);
    CHECK(bench.loop.state().torque_energy.peak_J < 1e-3);
    CHECK(bench.loop.state().commanded_W.force == Vector3::Zero());
}

TEST_CASE("tool stage: it is built where the plan has a tool, and instead of the proxy") {
    const HapticPlan plan = make_floor();
    REQUIRE(validate(plan));
    ScriptedDevice device;
    auto channels = std::make_unique<HapticChannels>();
    std::string names;
    std::size_t bytes = 0;
    for (const StageInfo& stage : HapticLoop(plan, device, *channels).stages()) {
        names += std::string(name_of(stage.stage)) + ", ";
        bytes = stage.stage == HapticStage::tool ? stage.bytes : bytes;
    }
    CHECK(names == "take inputs, read, estimate, tool, passivity, limits, write, publish, ");
    CHECK(bytes > std::size_t{2000} * 5);
    HapticPlan without = plan;
    without.tool = nullptr;
    CHECK(make_tool_stage(without) == nullptr);
    CHECK_FALSE(has_torques(without));
}

TEST_CASE("tool stage: a tool without a map for each solid is refused") {
    HapticPlan plan = make_floor();
    plan.solids.push_back({.body = 4, .shape = SphereShape{}});
    REQUIRE_FALSE(validate(plan));
    CHECK(to_sentence(validate(plan).error()).find("1 maps, and the plan has 2 solids") !=
          std::string::npos);
    plan = make_floor();
    auto broken = std::make_shared<ToolPlan>(*plan.tool);
    broken->settings.inertia.mass_kg = 0.0;
    plan.tool = broken;
    CHECK_FALSE(validate(plan));
}
