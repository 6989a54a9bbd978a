#include "haptics/loop/axle_stage.h"
#include "tests/unit/haptics/loop/axle_stage_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace fulcrum;

TEST_CASE("axle stage: what a hand cannot feel turns nothing") {
    const HapticPlan plan = make_beam();
    for (const double most_N : {5.0, 0.3, 0.0}) {
        const auto channels = std::make_unique<AxleChannels>();
        AxleStage stage(plan, channels.get());
        StillProxy proxy;
        const Pose rest[] = {Pose{}};
        (void)stage.turn(rest, proxy);
        stage.push(make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitY()),
                   {Vector3(0, 50, 0), Vector3(0, 50, 0), most_N}, 1e-3);
        REQUIRE(channels->frame.take());
        CHECK(channels->frame.value().axles[0].torque_Nm == Approx(-most_N * 0.4));
    }
}

TEST_CASE("axle stage: two solids that wedge the hand are pressed no harder than the hand feels") {
    HapticPlan plan = make_beam();
    plan.solids.push_back({.body = 1, .shape = SphereShape{0.1}});
    plan.proxy.cursor = SphereShape{0.02};
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    const Pose rest[] = {Pose{}, Pose{}};
    (void)stage.turn(rest, proxy);
    // Planes that face each other but for 0.1 rad, the hand pressed in between: each holds ten times what it feels.
    const Vector3 down(std::sin(0.05), -std::cos(0.05), 0.0);
    const Vector3 up(std::sin(0.05), std::cos(0.05), 0.0);
    ProxyContact contact = make_contact(Vector3(0.4, 0.07, 0), Vector3::UnitX());
    contact.n_constraints = 2;
    contact.touches[0] = {0, -1, up, 0.01};
    contact.touches[1] = {1, -1, down, 0.01};
    stage.push(contact, {Vector3(4, 0, 0), Vector3(4, 0, 0), kLimit_N}, 1e-3);
    REQUIRE(channels->frame.take());
    const AxleReport& report = channels->frame.value().axles[0];
    CHECK((report.force_W + kLimit_N * up).norm() < kRounding);
    // Where the ball touches the beam, not where all that it touches pushes it on the whole.
    CHECK((report.at_W - (Vector3(0.4, 0.07, 0) - 0.02 * up)).norm() < kRounding);
}

TEST_CASE("axle stage: on another pivot a body is as hard to turn as its mass says") {
    HapticPlan plan = make_beam(0.2);
    plan.axles[0].axle.mass_kg = 2.0;
    const auto turned_by = [&](const Vector3& pivot_B) {
        const auto channels = std::make_unique<AxleChannels>();
        AxleStage stage(plan, channels.get());
        StillProxy proxy;
        const Pose rest[] = {Pose{}};
        AxleOrders orders;
        orders.axles[0].is_set = true;
        orders.axles[0].pivot_B = pivot_B;
        channels->orders.publish(orders);
        (void)stage.turn(rest, proxy);
        stage.push(make_contact(pivot_B + Vector3(0.1, 0.05, 0), Vector3::UnitY()),
                   {Vector3(0, 2, 0), Vector3(0, 2, 0), kLimit_N}, 1e-3);
        REQUIRE(channels->frame.take());
        // I = tau dt / spin
        return -0.1 * 2.0 * 1e-3 / channels->frame.value().axles[0].spin_rad_per_s;
    };
    CHECK(turned_by(Vector3::Zero()) == Approx(0.2));
    CHECK(turned_by({0.3, 0.0, 0.7}) == Approx(0.2 + 2.0 * 0.09));
    CHECK(turned_by({-0.3, 0.4, 0.0}) == Approx(0.2 + 2.0 * 0.25));
    // Without mass nothing follows, but it is never lighter than what a hand would shake.
    plan.axles[0].axle.mass_kg = 0.0;
    CHECK(turned_by({0.3, 0.0, 0.0}) == Approx(0.2));
    CHECK(turned_by({3.0, 0.0, 0.0}) == Approx(kLeastRimMass_kg * 3.51 * 3.51));
    // Too far is not taken: the same push has 200.1 m to its pivot.
    CHECK(turned_by({2.0 * kFarthestOnAxle_m, 0.0, 0.0}) == Approx(0.2 * 0.1 / 200.1));
}

TEST_CASE("axle stage: of an order, what cannot be is left out, and the rest is carried out") {
    const HapticPlan plan = make_beam();
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    const Pose rest[] = {Pose{}};
    const auto stands_after = [&](const Vector3& pivot_B, double load_N) {
        AxleOrders orders;
        orders.axles[0].is_set = true;
        orders.axles[0].pivot_B = pivot_B;
        orders.axles[0].load_N = load_N;
        channels->orders.publish(orders);
        (void)stage.turn(rest, proxy);
        stage.push({}, {}, 1e-3);
        REQUIRE(channels->frame.take());
        return channels->frame.value().axles[0];
    };
    const double far_m = 2.0 * kFarthestOnAxle_m;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(stands_after({0.1, 0, 0}, 3.0).load_N == 3.0);
    const AxleReport kept = stands_after({far_m, 0, 0}, 5.0);
    CHECK(kept.load_N == 5.0);
    CHECK(kept.pivot_W.x() == 0.1);
    const AxleReport moved = stands_after({0.2, 0, 0}, nan);
    CHECK(moved.load_N == 5.0);
    CHECK(moved.pivot_W.x() == 0.2);
    CHECK(stands_after({0.2, 0, 0}, -1.0).load_N == 0.0);
    CHECK(stands_after({0.2, 0, 0}, 1e9).load_N == kMostAxleLoad_N);
}

TEST_CASE("axle stage: the load hangs where its torque has it, however the body lies") {
    HapticPlan plan = make_beam();
    plan.axles[0].axle.load_N = 3.0;
    plan.axles[0].axle.load_B = {0.4, 0.0, 0.0};
    plan.axles[0].axle.pivot_B = {0.1, 0.0, 0.0};
    plan.axles[0].reach_m = 0.61;
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    // The body itself lies turned by a quarter; the load's place is along the world's axes.
    const Pose rest[] = {
        {Vector3(1, 2, 3), Quaternion(AngleAxis(std::numbers::pi / 2, Vector3::UnitY()))}};
    (void)stage.turn(rest, proxy);
    stage.push({}, {}, 1e-3);
    REQUIRE(channels->frame.take());
    const AxleReport& report = channels->frame.value().axles[0];
    const Vector3 arm_W = report.load_W - report.pivot_W;
    CHECK(report.load_torque_Nm == Approx(-0.9));
    CHECK(arm_W.cross(Vector3(0, -report.load_N, 0)).z() ==
          Approx(report.load_torque_Nm).epsilon(1e-3));
}

TEST_CASE("axle stage: while the gate gives the hand nothing, the hand turns nothing") {
    const HapticPlan plan = make_beam();
    const auto axles = std::make_unique<AxleChannels>();
    Bench bench(plan, make_proxy(plan.proxy, plan.solids, {plan.coupling, kDt_s}), axles.get());
    const auto spin = [&] {
        REQUIRE(axles->frame.take());
        return std::abs(axles->frame.value().axles[0].spin_rad_per_s);
    };
    // Already pressed when the loop begins: the gate waits for a calm hand.
    bench.device.pose_D = Pose::at(Vector3(0.45, 0.06, 0.0));
    bench.run(1);
    bench.device.pose_D = Pose::at(Vector3(0.45, 0.04, 0.0));
    bench.run(300);
    REQUIRE(bench.loop.state().gate == GatePhase::waiting);
    REQUIRE(bench.loop.state().commanded_W.force.norm() > 1.0);
    CHECK(spin() == 0.0);
    // Taken back and pressed again: felt, and turned.
    bench.device.pose_D = Pose::at(Vector3(0.45, 0.06, 0.0));
    bench.run(3000);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
    bench.device.pose_D = Pose::at(Vector3(0.45, 0.045, 0.0));
    bench.run(20);
    const double turning = spin();
    CHECK(turning > 0.0);
    // A stop: what the hand no longer feels turns it no faster.
    bench.channels->emergency_stop.press();
    bench.run(2);
    const double stopped = spin();
    bench.device.pose_D = Pose::at(Vector3(0.45, 0.0, 0.0));
    bench.run(50);
    CHECK(spin() == stopped);
}
