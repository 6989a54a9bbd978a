#include "haptics/loop/tool_stage.h"

#include "haptics/math/rotation.h"
#include "tests/unit/haptics/loop/device_faults.h"
#include "tests/unit/haptics/loop/tool_stage_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

// A ball of 2 cm over the floor, held `grip` from its middle.
HapticPlan make_floor(const Vector3& grip_T = Vector3::Zero(), double scale = 1.0,
                      ToolMethod method = ToolMethod::field_sampling) {
    ToolScene scene = make_ball_tool(method);
    scene.settings.grip_T = grip_T;
    return make_tool_floor(scene, scale);
}

}  // namespace

TEST_CASE("tool stage: free space gives exactly nothing, however the hand moves and turns") {
    ToolBench bench(make_floor());
    for (int i = 0; i < 500; ++i) {
        const double t = 0.01 * i;
        bench.device.pose_D = {Vector3(0.05 * std::sin(t), 0.06 + 0.01 * std::sin(3 * t), 0.0),
                               compute_exp(Vector3(std::sin(t), std::cos(2 * t), 0.3))};
        bench.run(1);
        REQUIRE(bench.state().commanded_W.force == Vector3::Zero());
        REQUIRE(bench.state().commanded_W.torque == Vector3::Zero());
        REQUIRE(bench.state().touched_body == kNoBody);
    }
    CHECK(bench.state().faults == Fault::none);
}

TEST_CASE("tool stage: on a floor the tool stays outside, and the hand feels the coupling") {
    for (const ToolMethod method :
         {ToolMethod::field_sampling, ToolMethod::voxel_sampling, ToolMethod::implicit_penalty}) {
        ToolBench bench(make_floor(Vector3::Zero(), 1.0, method));
        bench.go(Vector3(0.01, 0.016, 0.0));
        const HapticState& state = bench.state();
        const Vector3 stretch_W = state.proxy_position_W - state.tool_pose_W.position;
        CHECK(state.touched_body == 3);
        // The ball's radius is 2 cm: its middle is no lower but for what its points are pressed in, and at most two voxels higher.
        CHECK(state.proxy_position_W.y() > 0.0193);
        CHECK(state.proxy_position_W.y() < 0.029);
        CHECK(stretch_W.y() > 0.002);
        CHECK((state.applied_W.force - kToolStiffness_N_per_m * stretch_W).norm() < 0.01);
        CHECK(state.applied_W.force.y() ==
              Approx(kToolStiffness_N_per_m * stretch_W.y()).epsilon(1e-2));
        // No hand presses it through: it feels the limit.
        bench.go(Vector3(0.0, -0.03, 0.0));
        CHECK(state.proxy_position_W.y() > 0.019);
        CHECK(state.applied_W.force.y() == Approx(5.0).epsilon(2e-2));
    }
}

TEST_CASE("tool stage: the torque about the grip is r x F; a hand that turns turns the tool") {
    for (const double scale : {1.0, 4.0}) {
        // Held 3 cm at its right: pressed down, the ball at the left pushes up.
        ToolBench bench(make_floor(Vector3(0.03, 0, 0), scale));
        bench.go(Vector3(0.03, 0.016, 0.0) / scale);
        const HapticState& state = bench.state();
        const Pose tool_W{state.proxy_position_W, state.proxy_orientation_W};
        const Vector3 ball_W = tool_W * Vector3(-0.03, 0, 0);
        const Vector3 contact_W = ball_W - Vector3(0, 0.02, 0);
        const Vector3 r_W = contact_W - tool_W.position;
        const Vector3 expected = r_W.cross(state.applied_W.force) / scale;
        REQUIRE(state.applied_W.force.y() > 0.3);
        CHECK(state.applied_W.torque.z() == Approx(expected.z()).epsilon(0.03));
        CHECK(state.applied_W.torque.z() < -0.005 / scale);
    }
    ToolBench bench(make_floor());
    const Quaternion turned = compute_exp(Vector3(0.0, 0.0, 0.6));
    for (int i = 1; i <= 400; ++i) {
        bench.device.pose_D.orientation = compute_exp(Vector3(0.0, 0.0, 0.6 * i / 400.0));
        bench.run(1);
    }
    bench.run(200);
    CHECK(bench.state().proxy_orientation_W.angularDistance(turned) < 1e-3);
}

TEST_CASE("tool stage: a hand that begins in a solid feels nothing until it is out") {
    ToolBench bench(make_floor(), false);
    bench.device.pose_D = Pose::at(Vector3(0, 0.005, 0));
    bench.run(500);
    CHECK(bench.state().commanded_W.force == Vector3::Zero());
    CHECK(bench.state().proxy_position_W == Vector3(0, 0.005, 0));
    bench.go(Vector3(0, kTop_m, 0));
    bench.go(Vector3(0, 0.015, 0));
    CHECK(bench.state().applied_W.force.y() > 1.0);
}

TEST_CASE("tool stage: any fault lets the tool go; it is felt again from outside") {
    std::vector<std::pair<std::string, std::function<void(Bench&)>>> kinds{
        {"stopped", [](Bench& b) { b.channels->emergency_stop.press(); }},
        {"the lesson failed", [](Bench& b) { b.command.lesson_alive = false; }}};
    for (const DeviceFault& fault : kDeviceFaults) {
        kinds.emplace_back(fault.name, [&fault](Bench& b) { fault.spoil(b.device); });
    }
    for (const auto& [name, happens] : kinds) {
        CAPTURE(name);
        ToolBench bench(make_floor());
        const Vector3 pressed(0.0, 0.015, 0.0);
        bench.go(pressed);
        REQUIRE(bench.state().applied_W.force.y() > 1.0);
        happens(bench);
        bench.run(1);
        CHECK(bench.state().faults != Fault::none);
        CHECK(bench.state().commanded_W.force == Vector3::Zero());
        bench.run(150);
        CHECK(bench.written_N() == Vector3::Zero());
        CHECK(bench.device.written_D.torque == Vector3::Zero());
        // All is well again, with the hand still in the floor: nothing yet.
        bench.device.gives_pose = true;
        bench.device.age_s = 0.0;
        bench.device.pose_D = Pose::at(pressed);
        bench.command.lesson_alive = true;
        bench.channels->emergency_stop.release();
        bench.run(200);
        bench.channels->rearm.store(true);
        bench.run(200);
        CHECK(bench.state().commanded_W.force == Vector3::Zero());
        CHECK(bench.state().faults == Fault::none);
        // From outside it is felt as before.
        bench.go(Vector3(0, kTop_m, 0));
        bench.go(pressed);
        CHECK(bench.state().applied_W.force.y() > 1.0);
    }
}

TEST_CASE("tool stage: a solid that moves takes the tool along and pushes the hand") {
    HapticPlan plan = make_floor();
    plan.expects_world = true;
    ToolBench bench(plan);
    bench.go(Vector3(0.0, 0.0195, 0.0));
    // 5 mm up in half a second.
    for (int i = 1; i <= 500; ++i) {
        bench.world.solid_poses_W[0].position.y() = -0.02 + 1.0e-5 * i;
        bench.run(1);
    }
    bench.run(500);
    const HapticState& state = bench.state();
    CHECK(state.proxy_position_W.y() > 0.024);
    CHECK(state.applied_W.force.y() > 0.3);
    // Put elsewhere at once, it leaves the hand alone; a pose that is no number is a fault.
    bench.world.solid_placements[0] += 1;
    bench.world.solid_poses_W[0].position.y() = 0.0;
    bench.run(3);
    CHECK(state.commanded_W.force == Vector3::Zero());
    bench.world.solid_poses_W[0].position.y() = std::nan("");
    bench.run(1);
    CHECK(bench.saw(Fault::command_invalid));
    CHECK(state.commanded_W.force == Vector3::Zero());
}

TEST_CASE("tool stage: a solid's velocity is the way between two places it was told to be at") {
    LedStage led(make_floor());
    for (int i = 1; i <= 5; ++i) {
        (void)led.step(Vector3(0, 0.06, 0));
    }
    CHECK(led.stage->solid() == kNoBody);
    CHECK_FALSE(led.stage->pushes()[0].touches);
    // Without poses in a round there is no force, and the tool is with the hand.
    led.solids_W.clear();
    const ToolForce none = led.step(Vector3(0, 0.01, 0));
    CHECK(none.wrench_W.force == Vector3::Zero());
    CHECK_FALSE(none.failed);
    CHECK(led.stage->pose_W().position == Vector3(0, 0.01, 0));
}

TEST_CASE("tool stage: what the tool does to a solid is the other side of what that does to it") {
    LedStage led(make_floor(Vector3(0.03, 0, 0)));
    const auto& stage = led.stage;
    ToolForce felt;
    for (int i = 1; i <= 2000; ++i) {
        felt = led.step(Vector3(0.03, kTop_m - 0.034 * std::min(1.0, i / 1000.0), 0));
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
    LedStage led(plan);
    ToolForce felt;
    for (int i = 1; i <= 2000; ++i) {
        const double share = std::min(1.0, i / 1000.0);
        felt = led.step(Vector3(Vector3(0, kTop_m, 0) + share * Vector3(0.013, 0.016 - kTop_m, 0)));
    }
    const std::span<const SolidPush> pushes = led.stage->pushes();
    REQUIRE((pushes[0].touches && pushes[1].touches));
    CHECK(pushes[0].force_W.y() < -0.5);
    CHECK(pushes[1].force_W.x() > 0.5);
    CHECK(std::abs(pushes[0].force_W.x()) < 0.05);
    CHECK((pushes[0].force_W + pushes[1].force_W + felt.wrench_W.force).norm() < 0.02);
    CHECK(led.stage->solid() == (pushes[0].force_W.norm() > pushes[1].force_W.norm() ? 0 : 1));
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
    LedStage led(plan);
    const auto& stage = led.stage;
    double most_N = 0.0;
    double most_turn_Nm = 0.0;
    int n_both = 0;
    for (int i = 1; i <= 3000; ++i) {
        const ToolForce felt =
            led.step(Pose{Vector3::Zero(), compute_exp(Vector3(0.0, 0.0, -2.0e-4 * i))});
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
    ToolBench bench(make_floor(Vector3(0.03, 0, 0)));
    bench.go(Vector3(0.03, 0.016, 0.0));
    CHECK(has_torques(make_floor()));
    // Slowly pressed and let go, the hand gets no more back than it gave, but for rounding and the observer's own error.
    bench.go(Vector3(0.03, kTop_m, 0.0));
    CHECK(bench.state().force_energy.peak_J < 1e-3);
    CHECK(bench.state().torque_energy.peak_J < 1e-3);
    CHECK(bench.state().commanded_W.force == Vector3::Zero());
}

TEST_CASE("tool stage: it is built where the plan has a tool, and instead of the proxy") {
    const HapticPlan plan = make_floor();
    REQUIRE(validate(plan));
    const Bench bench(plan);
    CHECK(bench.stages() ==
          "take inputs, read, estimate, tool, passivity, limits, write, publish, ");
    CHECK(bench.loop.stages()[3].bytes > std::size_t{2000} * 5);
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
