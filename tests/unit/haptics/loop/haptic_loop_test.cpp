#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/math/rotation.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

using namespace fulcrum;

namespace {

// A floor at height zero, frictionless.
class FloorProxy final : public Proxy {
  public:
    void reset(const Vector3& hand_W) noexcept override {
        contact_ = {};
        contact_.position_W = hand_W;
    }
    const ProxyContact& step(const Vector3& hand_W,
                             std::span<const Pose> poses_W) noexcept override {
        const double height_m = poses_W[0].position.y();
        const bool touches = hand_W.y() < height_m;
        contact_ = {touches ? Vector3(hand_W.x(), height_m, hand_W.z()) : hand_W,
                    touches ? 0 : kNoBody, touches ? 1 : 0,
                    touches ? Vector3(0, 1, 0) : Vector3(Vector3::Zero())};
        return contact_;
    }

  private:
    ProxyContact contact_;
};

}  // namespace

TEST_CASE("haptic loop: a carried weight arrives softly, in full, in the device's frame") {
    HapticPlan plan = make_weight_plan();
    plan.workspace.pose_WD.orientation = compute_exp(Vector3(0.0, 0.0, 1.5707963267948966));
    plan.workspace.scale = 3.0;
    Bench bench(plan);
    bench.run(3000);
    CHECK(bench.loop.state().gate == GatePhase::open);
    bench.world.carried_force_W = Vector3(0.0, -3.0, 0.0);
    double before_N = 0.0;
    for (int k = 0; k < 301; ++k) {
        bench.run(1);
        const double now_N = bench.device.written_D.force.norm();
        REQUIRE(now_N >= before_N - kRounding);
        REQUIRE(now_N - before_N <= 1.875 * 3.0 / plan.weight_onset_s * kDt_s + kRounding);
        before_N = now_N;
    }
    // World down is the device's -x: R^T (0, -3, 0) for a quarter turn about z.
    CHECK((bench.device.written_D.force - Vector3(-3.0, 0.0, 0.0)).norm() < kRounding);
    CHECK((bench.loop.state().applied_W.force - Vector3(0.0, -3.0, 0.0)).norm() < kRounding);
    CHECK((bench.loop.state().commanded_W.force - Vector3(0.0, -3.0, 0.0)).norm() < kRounding);
}

TEST_CASE("haptic loop: poses and velocities are scaled and turned into the world") {
    HapticPlan plan;
    plan.workspace.pose_WD = {Vector3(1.0, 0.0, 0.0),
                              compute_exp(Vector3(0.0, 0.0, 1.5707963267948966))};
    plan.workspace.scale = 5.0;
    Bench bench(plan);
    for (int k = 0; k < 100; ++k) {
        bench.device.pose_D.position = Vector3(0.0002 * k, 0.0, 0.0);
        bench.device.buttons = 2;
        bench.run(1);
    }
    const HapticState& state = bench.loop.state();
    CHECK((state.tool_pose_W.position - Vector3(1.0, 5.0 * 0.0002 * 99, 0.0)).norm() < kRounding);
    CHECK((state.tool_twist_W.linear - Vector3(0.0, 1.0, 0.0)).norm() < 1e-6);
    CHECK(state.proxy_position_W == state.tool_pose_W.position);
    CHECK(state.buttons == 2);
    CHECK(state.tick == 99);
    CHECK(state.time_s == bench.now_s);
    REQUIRE(bench.channels->state_for_world.take());
    CHECK(bench.channels->state_for_world.value().tick == 99);
    REQUIRE(bench.channels->state_for_lesson.take());
    CHECK(bench.channels->state_for_lesson.value().tool_pose_W.position ==
          state.tool_pose_W.position);
}

TEST_CASE(
    "haptic loop: a touched solid pushes with the coupling's spring; sliding along it is free") {
    HapticPlan plan;
    plan.coupling = {};
    plan.coupling.stiffness_N_per_m = 400.0;
    plan.coupling.damping_Ns_per_m = 2.0;
    plan.solids.push_back({7, nullptr, {}});
    auto proxy = std::make_unique<FloorProxy>();
    Bench bench(plan, std::move(proxy));
    bench.device.pose_D.position = Vector3(0.0, 0.01, 0.0);
    bench.run(3000);
    CHECK(bench.loop.state().touched_body == kNoBody);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    for (int k = 0; k < 500; ++k) {
        bench.device.pose_D.position.y() =
            std::max(bench.device.pose_D.position.y() - 0.0001, -0.005);
        bench.run(1);
    }
    CHECK(bench.loop.state().touched_body == 7);
    CHECK((bench.device.written_D.force - Vector3(0.0, 2.0, 0.0)).norm() < kRounding);
    for (int k = 0; k < 500; ++k) {
        bench.device.pose_D.position.x() += 0.0001;
        bench.run(1);
    }
    CHECK((bench.device.written_D.force - Vector3(0.0, 2.0, 0.0)).norm() < 1e-6);
    // Pressing further in at 0.05 m/s adds b v.
    for (int k = 0; k < 50; ++k) {
        bench.device.pose_D.position.y() -= 0.00005;
        bench.run(1);
    }
    CHECK(bench.loop.state().commanded_W.force.y() ==
          Approx(400.0 * 0.0075 + 2.0 * 0.05).epsilon(1e-6));
}

TEST_CASE(
    "haptic loop: with a world the solids stand where the world says, and NaN there is a fault") {
    HapticPlan plan;
    plan.expects_world = true;
    plan.solids.push_back({0, nullptr, {}});
    Bench bench(plan, std::make_unique<FloorProxy>());
    bench.device.pose_D.position = Vector3(0.0, 0.01, 0.0);
    bench.run(3000);
    CHECK(bench.loop.state().touched_body == kNoBody);
    bench.world.solid_poses_W[0].position.y() = 0.012;
    bench.run(10);
    CHECK(bench.loop.state().touched_body == 0);
    CHECK(bench.loop.state().proxy_position_W.y() == 0.012);
    bench.world.solid_poses_W[0].position.y() = std::numeric_limits<double>::quiet_NaN();
    bench.run(1);
    CHECK(saw(bench, Fault::command_invalid));
    CHECK(is_finite(bench.device.written_D));
}

TEST_CASE("haptic loop: fields and a lesson's force add up") {
    HapticPlan plan;
    plan.lesson_force = true;
    FieldPlan spring;
    spring.kind = FieldKind::spring;
    spring.stiffness_N_per_m = 100.0;
    FieldPlan magnet;
    magnet.kind = FieldKind::magnet;
    magnet.peak_force_N = 1.0;
    magnet.range_m = 0.02;
    plan.fields = {spring, magnet};
    Bench bench(plan);
    bench.command.fields[0].anchor_W = Vector3(0.01, 0.0, 0.0);
    bench.command.fields[1].anchor_W = Vector3(0.0, 0.02, 0.0);
    bench.command.fields[0].on = bench.command.fields[1].on = false;
    bench.run(3000);
    bench.command.fields[0].on = bench.command.fields[1].on = true;
    bench.command.linearised.stamp_s = bench.now_s;
    bench.command.linearised.force_W = Vector3(0.0, 0.0, 0.5);
    for (int k = 0; k < 1000; ++k) {
        bench.command.linearised.stamp_s = bench.now_s;
        bench.run(1);
    }
    CHECK((bench.device.written_D.force - Vector3(1.0, 1.0, 0.5)).norm() < 1e-6);
    bench.command.linearised.stamp_s = bench.now_s + kDt_s;
    bench.command.linearised.force_W.x() = std::numeric_limits<double>::quiet_NaN();
    bench.run(1);
    CHECK(saw(bench, Fault::command_invalid));
}

TEST_CASE(
    "haptic loop: a lesson's torque arrives in the device's frame, is capped and fades with it") {
    HapticPlan plan;
    plan.lesson_force = true;
    plan.workspace.pose_WD.orientation = compute_exp(Vector3(0.0, 0.0, 1.5707963267948966));
    plan.workspace.scale = 3.0;
    Bench bench(plan);
    bench.run(3000);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
    bench.command.linearised.torque_stiffness_Nm_per_m(1, 0) = 2.0;
    const auto answer = [&](const Vector3& torque_W, int n) {
        bench.command.linearised.torque_W = torque_W;
        for (int k = 0; k < n; ++k) {
            if (k % 16 == 0) {
                bench.command.linearised.stamp_s = bench.now_s + kDt_s;
            }
            bench.run(1);
        }
    };
    // World up is the device's x: R^T (0, 0.2, 0) for a quarter turn about z. No force comes with it.
    answer(Vector3(0.0, 0.2, 0.0), 200);
    CHECK((bench.device.written_D.torque - Vector3(0.2, 0.0, 0.0)).norm() < kRounding);
    CHECK(bench.device.written_D.force.norm() == 0.0);
    CHECK((bench.loop.state().commanded_W.torque - Vector3(0.0, 0.2, 0.0)).norm() < kRounding);
    CHECK((bench.loop.state().applied_W.torque - Vector3(0.0, 0.2, 0.0)).norm() < kRounding);
    // 1 cm of the device towards -y is 3 cm of the world towards +x, worth 0.06 Nm.
    bench.device.pose_D.position.y() = -0.01;
    bench.run(20);
    CHECK((bench.device.written_D.torque - Vector3(0.26, 0.0, 0.0)).norm() < kRounding);
    // Ten times the limit is as much as the limit.
    answer(Vector3(0.0, 3.0, 0.0), 500);
    CHECK(bench.loop.state().commanded_W.torque.norm() == Approx(plan.safety.max_torque_Nm));
    CHECK(bench.device.written_D.torque.norm() <= plan.safety.max_torque_Nm);
    CHECK((bench.device.written_D.torque - Vector3(0.3, 0.0, 0.0)).norm() < kRounding);
    // The lesson goes silent: after its time the torque falls in a straight line to zero, and stays there.
    bench.lesson_awake = false;
    double before_Nm = 0.3;
    for (int k = 0; k < 400; ++k) {
        bench.run(1);
        const double now_Nm = bench.device.written_D.torque.norm();
        REQUIRE(now_Nm <= before_Nm + kRounding);
        REQUIRE(before_Nm - now_Nm <= 0.3 * kDt_s / plan.safety.fade_s + kRounding);
        before_Nm = now_Nm;
    }
    CHECK(saw(bench, Fault::command_stale));
    CHECK(bench.device.written_D.torque.norm() == 0.0);
}

TEST_CASE(
    "haptic loop: a lesson's torque that is not finite is a fault, and none reaches the device") {
    HapticPlan plan;
    plan.lesson_force = true;
    Bench bench(plan);
    bench.run(3000);
    bench.command.linearised.stamp_s = bench.now_s + kDt_s;
    bench.command.linearised.torque_W.y() = std::numeric_limits<double>::infinity();
    bench.run(1);
    CHECK(saw(bench, Fault::command_invalid));
    CHECK(bench.device.written_D.torque.norm() == 0.0);
}

TEST_CASE("haptic loop: a device that renders no torque is sent none, its force is as ever") {
    ScriptedDevice device;
    device.traits_.max_torque_Nm = 0.0;
    auto channels = std::make_unique<HapticChannels>();
    HapticPlan plan;
    plan.lesson_force = true;
    HapticLoop loop(plan, device, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    for (int k = 1; k < 4000; ++k) {
        command.stamp_s = command.linearised.stamp_s = k * kDt_s;
        command.linearised.force_W.x() = k < 3000 ? 0.0 : 0.5;
        command.linearised.torque_W.y() = k < 3000 ? 0.0 : 0.2;
        channels->command.publish(command);
        loop.step(k * kDt_s);
        REQUIRE(device.written_D.torque.norm() == 0.0);
    }
    CHECK(device.written_D.force.x() == Approx(0.5));
    CHECK(loop.state().commanded_W.torque.norm() == 0.0);
}

TEST_CASE("haptic loop: the device's own limit holds when it is the smaller one") {
    ScriptedDevice device;
    device.traits_.max_force_N = 2.0;
    auto channels = std::make_unique<HapticChannels>();
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.carries_weight = true;
    HapticLoop loop(plan, device, *channels);
    for (int k = 1; k < 4000; ++k) {
        WorldFrame world;
        world.carried_force_W = k < 2500 ? Vector3(Vector3::Zero()) : Vector3(0.0, -4.0, 0.0);
        channels->world.publish(world);
        loop.step(k * kDt_s);
    }
    CHECK(device.written_D.force.norm() == Approx(2.0));
    CHECK(loop.state().commanded_W.force.norm() == Approx(4.0));
}

TEST_CASE("haptic loop: the same input gives the same bits") {
    const auto play = [] {
        Bench bench(make_weight_plan());
        std::vector<double> forces;
        for (int k = 0; k < 4000; ++k) {
            bench.device.pose_D.position.x() = 0.05 * std::sin(0.003 * k);
            bench.world.carried_force_W.y() = k < 2500 ? 0.0 : -3.0 - 0.3 * (k % 500 == 0);
            bench.run(1);
            forces.push_back(bench.device.written_D.force.y());
        }
        return forces;
    };
    const std::vector<double> first = play();
    CHECK(play() == first);
    CHECK(first.back() < -2.9);
}

TEST_CASE("haptic loop: a hand that jumps while it touches feels the spring alone at first") {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.coupling.damping_Ns_per_m = 2.0;
    plan.solids.push_back({0, nullptr, {}});
    Bench bench(plan, std::make_unique<FloorProxy>());
    bench.device.pose_D.position = Vector3(0.0, -0.004, 0.0);
    for (int k = 0; k < 100; ++k) {
        bench.device.pose_D.position.x() += 0.0005;
        bench.run(1);
    }
    bench.device.pose_D.position.x() += 0.1;
    bench.run(1);
    CHECK(saw(bench, Fault::device_invalid));
    CHECK((bench.loop.state().commanded_W.force - Vector3(0.0, 500.0 * 0.004, 0.0)).norm() <
          kRounding);
}

TEST_CASE("haptic loop: a solid that is no body of the scene pushes too") {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.solids.push_back({kNoBody, nullptr, {}});
    Bench bench(plan, std::make_unique<FloorProxy>());
    bench.device.pose_D.position = Vector3(0.0, -0.004, 0.0);
    bench.run(10);
    CHECK(bench.loop.state().commanded_W.force.y() == Approx(500.0 * 0.004));
    CHECK(bench.loop.state().touched_body == kNoBody);
}

TEST_CASE("haptic loop: a hand that leaves a solid is not held back by it") {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.coupling.damping_Ns_per_m = 10.0;
    plan.solids.push_back({0, nullptr, {}});
    Bench bench(plan, std::make_unique<FloorProxy>());
    bench.device.pose_D.position = Vector3(0.0, -0.005, 0.0);
    bench.run(100);
    for (int k = 0; k < 30; ++k) {
        bench.device.pose_D.position.y() += 0.0005;
        bench.run(1);
        REQUIRE(bench.loop.state().commanded_W.force.y() >= 0.0);
    }
}

TEST_CASE("haptic loop: before the world's first frame the solids stand where the plan says") {
    HapticPlan plan;
    plan.expects_world = true;
    Pose raised;
    raised.position.y() = 0.012;
    plan.solids.push_back({0, nullptr, raised});
    Bench bench(plan, std::make_unique<FloorProxy>());
    bench.world_awake = false;
    bench.device.pose_D.position = Vector3(0.0, 0.01, 0.0);
    bench.run(1);
    CHECK(bench.loop.state().proxy_position_W.y() == 0.012);
    bench.world_awake = true;
    bench.run(1);
    CHECK(bench.loop.state().proxy_position_W.y() == 0.01);
}

TEST_CASE("haptic loop: a lesson's slopes are bounded in the hand, by what the fields leave") {
    // How stiff a lesson's spring of 1e5 N/m is in the hand, and its damping and torque slope.
    struct Felt {
        double stiffness, damping, torque_slope;
    };
    const auto feel = [](double scale, const std::vector<FieldPlan>& fields) {
        HapticPlan plan;
        plan.workspace.scale = scale;
        plan.lesson_force = true;
        plan.fields = fields;
        Bench bench(plan);
        bench.command.fields[0].on = false;
        bench.command.linearised.stamp_s = kDt_s;
        bench.command.linearised.stiffness_N_per_m(0, 0) = -1e5;
        bench.command.linearised.damping_Ns_per_m(1, 1) = -1e4;
        bench.command.linearised.torque_stiffness_Nm_per_m(2, 0) = 1e4;
        bench.run(20);
        bench.device.pose_D.position.x() = 0.0005;
        bench.run(20);
        const Wrench bent = bench.loop.state().commanded_W;
        for (int k = 0; k < 20; ++k) {
            bench.device.pose_D.position.y() += 1e-5;
            bench.run(1);
        }
        return Felt{-bent.force.x() / 0.0005, -bench.loop.state().commanded_W.force.y() / 0.01,
                    bent.torque.z() / 0.0005};
    };
    for (const double scale : {1.0, 0.5, 100.0}) {
        const Felt alone = feel(scale, {});
        CHECK(alone.stiffness == Approx(2000.0).epsilon(1e-6));
        CHECK(alone.damping == Approx(50.0).epsilon(1e-3));
        CHECK(alone.torque_slope == Approx(200.0).epsilon(1e-6));
        FieldPlan spring;
        spring.stiffness_N_per_m = 1500.0 / scale;
        spring.damping_Ns_per_m = 40.0 / scale;
        const Felt beside = feel(scale, {spring});
        CHECK(beside.stiffness == Approx(500.0).epsilon(1e-6));
        CHECK(beside.damping == Approx(10.0).epsilon(1e-3));
        FieldPlan magnet;
        magnet.kind = FieldKind::magnet;
        magnet.peak_force_N = 3.0;
        magnet.range_m = 0.005 * scale;
        CHECK(feel(scale, {magnet}).stiffness ==
              Approx(2000.0 - 600.0 * std::sqrt(std::exp(1.0))).epsilon(1e-6));
    }
}

TEST_CASE("haptic loop: a lesson's spring too stiff for the scale does not shake the usual arm") {
    for (const double felt_N_per_m : {500.0, 2000.0, 5000.0, 200000.0}) {
        constexpr double kScale = 100.0;
        HapticPlan plan;
        plan.lesson_force = true;
        plan.workspace.scale = kScale;
        LatestValue<HandTarget> target;
        SimulatedHand hand(SimulatedHandSettings{}, target);
        auto channels = std::make_unique<HapticChannels>();
        HapticLoop loop(plan, hand, *channels);
        ForceCommand command;
        command.lesson_alive = true;
        double lowest_m = 1.0;
        double highest_m = -1.0;
        for (int k = 1; k < 7000; ++k) {
            // The hand is pushed 5 mm aside for a second.
            HandTarget wanted;
            wanted.pose_D.position.x() = k > 3000 && k < 4000 ? 0.005 : 0.0;
            target.publish(wanted);
            command.stamp_s = k * kDt_s;
            if (k % 16 == 0) {
                LinearisedWrench& answer = command.linearised;
                answer.stamp_s = k * kDt_s;
                answer.at_position_W = loop.state().tool_pose_W.position;
                answer.stiffness_N_per_m = -felt_N_per_m / kScale * Matrix3::Identity();
                answer.force_W = answer.stiffness_N_per_m * answer.at_position_W;
            }
            channels->command.publish(command);
            loop.step(k * kDt_s);
            if (k > 5000) {
                const double x_m = loop.state().tool_pose_W.position.x() / kScale;
                lowest_m = std::min(lowest_m, x_m);
                highest_m = std::max(highest_m, x_m);
            }
        }
        CHECK(highest_m - lowest_m < 0.001);
        CHECK(std::abs(highest_m) < 0.002);
    }
}

TEST_CASE(
    "haptic loop: a bare handle on a wall, and a hand, come to rest at one and four kilohertz") {
    constexpr double kEncoder_m = 5.5e-5;
    SimulatedHandSettings handle;
    handle.mass_kg = 0.05;
    handle.stiffness_N_per_m = 1.0;
    handle.damping_Ns_per_m = 0.0;
    for (SimulatedHandSettings held : {handle, SimulatedHandSettings{}}) {
        for (const double rate_Hz : {1000.0, 4000.0}) {
            HapticPlan plan;
            plan.expects_lesson = false;
            plan.rate_hz = rate_Hz;
            plan.solids.push_back({0, nullptr, {}});
            held.position_resolution_m = kEncoder_m;
            held.start_pose_D.position.y() = 0.01;
            LatestValue<HandTarget> target;
            SimulatedHand hand(held, target);
            auto channels = std::make_unique<HapticChannels>();
            HapticLoop loop(plan, hand, *channels, std::make_unique<FloorProxy>());
            double lowest_m = 1.0;
            double highest_m = -1.0;
            for (int k = 1; k < static_cast<int>(6.0 * rate_Hz); ++k) {
                const double now_s = k / rate_Hz;
                // Pressed down with 2 N from 2.5 s on.
                HandTarget wanted;
                wanted.pose_D.position.y() = now_s < 2.5 ? 0.01 : -2.0 / held.stiffness_N_per_m;
                target.publish(wanted);
                loop.step(now_s);
                if (now_s > 5.0) {
                    const double y_m = loop.state().tool_pose_W.position.y();
                    lowest_m = std::min(lowest_m, y_m);
                    highest_m = std::max(highest_m, y_m);
                }
            }
            CHECK(highest_m - lowest_m < 1.5 * kEncoder_m);
            CHECK(highest_m < -0.002);
        }
    }
}
