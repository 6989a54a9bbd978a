// What an axle takes from a hand, a tool and a lesson, and what it leaves.
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/axle_stage_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <utility>

using namespace fulcrum;

TEST_CASE("axle stage: what a hand cannot feel turns nothing") {
    for (const double most_N : {5.0, 0.3, 0.0}) {
        CHECK(StagedAxle(make_beam())
                  .push(make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitY()),
                        make_push({0, 50, 0}, most_N))
                  .torque_Nm == Approx(-most_N * 0.4));
    }
}

TEST_CASE("axle stage: two solids that wedge the hand are pressed no harder than the hand feels") {
    HapticPlan plan = make_beam_and_ball();
    plan.proxy.cursor = SphereShape{0.02};
    // Planes that face each other but for 0.1 rad, the hand pressed in between: each holds ten times what it feels.
    const Vector3 down(std::sin(0.05), -std::cos(0.05), 0.0);
    const Vector3 up(std::sin(0.05), std::cos(0.05), 0.0);
    ProxyContact contact = make_contact(Vector3(0.4, 0.07, 0), Vector3::UnitX());
    contact.n_constraints = 2;
    contact.touches[0] = {0, -1, up, 0.01};
    contact.touches[1] = {1, -1, down, 0.01};
    const AxleReport report = StagedAxle(plan).push(contact, make_push({4, 0, 0}));
    CHECK((report.force_W + kLimit_N * up).norm() < kRounding);
    // Where the ball touches the beam, not where all that it touches pushes it on the whole.
    CHECK((report.at_W - (Vector3(0.4, 0.07, 0) - 0.02 * up)).norm() < kRounding);
}

TEST_CASE("axle stage: a tool turns a body by r x F and its couple, within what may be felt") {
    StagedAxle axle(make_beam_and_ball());
    SolidPush pushes[2];
    pushes[0] = {true, Vector3(0.4, 0.05, 0), Vector3(1, -2, 3), Vector3(7, 5, 0.25)};
    const auto report = [&](double most_N, double most_Nm = 100.0) {
        (void)axle.stage.turn(axle.rest);
        axle.stage.push_by_tool(pushes, {most_N, most_Nm}, kDt_s);
        return axle.told();
    };
    const double torque_Nm = 0.4 * -2.0 - 0.05 * 1.0 + 0.25;
    CHECK(report(10.0).torque_Nm == Approx(torque_Nm));
    CHECK(report(10.0).touched);
    CHECK(report(10.0).force_W == pushes[0].force_W);
    CHECK(report(10.0).spin_rad_per_s == Approx(torque_Nm / 0.1 * 4e-3));
    // Half of the force may be felt: half turns.
    const double force_N = pushes[0].force_W.norm();
    CHECK(report(0.5 * force_N).torque_Nm == Approx(0.5 * torque_Nm));
    CHECK(report(0.0).torque_Nm == 0.0);
    // The couple alone has a limit of its own, behind a closed gate nothing.
    const double couple_Nm = pushes[0].couple_W.norm();
    CHECK(report(10.0, 0.5 * couple_Nm).torque_Nm == Approx(torque_Nm - 0.5 * 0.25));
    CHECK(report(10.0, 0.0).torque_Nm == Approx(torque_Nm - 0.25));
    pushes[0].force_W = Vector3::Zero();
    CHECK(report(10.0, 100.0).torque_Nm == Approx(0.25));
    CHECK(report(0.0, 0.5 * couple_Nm).torque_Nm == Approx(0.125));
    CHECK(report(10.0, 0.0).torque_Nm == 0.0);
    // Another solid's push is not its.
    std::swap(pushes[0], pushes[1]);
    CHECK(report(10.0).torque_Nm == 0.0);
    CHECK_FALSE(report(10.0).touched);
}

TEST_CASE("axle stage: on another pivot a body is as hard to turn as its mass says") {
    const auto turned_by = [](const Vector3& pivot_B, double mass_kg = 2.0) {
        HapticPlan plan = make_beam(0.2);
        plan.axles[0].axle.mass_kg = mass_kg;
        StagedAxle axle(plan);
        axle.order.is_set = true;
        axle.order.pivot_B = pivot_B;
        axle.send();
        const AxleReport report = axle.push(
            make_contact(pivot_B + Vector3(0.1, 0.05, 0), Vector3::UnitY()), make_push({0, 2, 0}));
        // I = tau dt / spin
        return -0.1 * 2.0 * kDt_s / report.spin_rad_per_s;
    };
    CHECK(turned_by(Vector3::Zero()) == Approx(0.2));
    CHECK(turned_by({0.3, 0.0, 0.7}) == Approx(0.2 + 2.0 * 0.09));
    CHECK(turned_by({-0.3, 0.4, 0.0}) == Approx(0.2 + 2.0 * 0.25));
    // Without mass nothing follows, but it is never lighter than what a hand would shake.
    CHECK(turned_by({0.3, 0.0, 0.0}, 0.0) == Approx(0.2));
    CHECK(turned_by({3.0, 0.0, 0.0}, 0.0) == Approx(kLeastRimMass_kg * 3.51 * 3.51));
    // Too far is not taken: the same push has 200.1 m to its pivot.
    CHECK(turned_by({2.0 * kFarthestOnAxle_m, 0.0, 0.0}, 0.0) == Approx(0.2 * 0.1 / 200.1));
}

TEST_CASE("axle stage: of an order, what cannot be is left out, and the rest is carried out") {
    StagedAxle axle(make_beam());
    axle.order.is_set = true;
    const double far_m = 2.0 * kFarthestOnAxle_m;
    const double orders[][4] = {// where and how much, and what is carried out of it
                                {0.1, 3.0, 0.1, 3.0},
                                {far_m, 5.0, 0.1, 5.0},
                                {0.2, kNan, 0.2, 5.0},
                                {0.2, -1.0, 0.2, 0.0},
                                {0.2, 1e9, 0.2, kMostAxleLoad_N}};
    for (const auto& [pivot_m, load_N, stands_m, hangs_N] : orders) {
        CAPTURE(pivot_m, load_N);
        axle.order.pivot_B = {pivot_m, 0, 0};
        axle.order.load_N = load_N;
        const AxleReport report = axle.obey();
        CHECK(report.pivot_W.x() == stands_m);
        CHECK(report.load_N == hangs_N);
    }
}

TEST_CASE("axle stage: the load hangs where its torque has it, however the body lies") {
    HapticPlan plan = make_beam();
    plan.axles[0].axle.load_N = 3.0;
    plan.axles[0].axle.load_B = {0.4, 0.0, 0.0};
    plan.axles[0].axle.pivot_B = {0.1, 0.0, 0.0};
    plan.axles[0].reach_m = 0.61;
    StagedAxle axle(plan);
    // The body itself lies turned by a quarter; the load's place is along the world's axes.
    axle.rest = {{Vector3(1, 2, 3), Quaternion(AngleAxis(std::numbers::pi / 2, Vector3::UnitY()))}};
    const AxleReport report = axle.push({}, {});
    const Vector3 arm_W = report.load_W - report.pivot_W;
    CHECK(report.load_torque_Nm == Approx(-0.9));
    CHECK(arm_W.cross(Vector3(0, -report.load_N, 0)).z() ==
          Approx(report.load_torque_Nm).epsilon(1e-3));
}

TEST_CASE("axle stage: while the gate gives the hand nothing, the hand turns nothing") {
    const HapticPlan plan = make_beam();
    const auto axles = std::make_unique<AxleChannels>();
    Bench bench(plan, {.axles = axles.get()});
    const auto hold_at = [&](double y_m, int n) {
        bench.device.pose_D = Pose::at(Vector3(0.45, y_m, 0.0));
        bench.run(n);
        REQUIRE(axles->frame.take());
        return std::abs(axles->frame.value().axles[0].spin_rad_per_s);
    };
    // Already pressed when the loop begins: the gate waits for a calm hand.
    hold_at(0.06, 1);
    CHECK(hold_at(0.04, 300) == 0.0);
    REQUIRE(bench.state().gate == GatePhase::waiting);
    REQUIRE(bench.state().commanded_W.force.norm() > 1.0);
    // Taken back and pressed again: felt, and turned.
    hold_at(0.06, 3000);
    REQUIRE(bench.state().gate == GatePhase::open);
    CHECK(hold_at(0.045, 20) > 0.0);
    // A stop: what the hand no longer feels turns it no faster.
    bench.channels->emergency_stop.press();
    const double stopped = hold_at(0.045, 2);
    CHECK(hold_at(0.0, 50) == stopped);
}
