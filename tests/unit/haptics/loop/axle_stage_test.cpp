#include "haptics/loop/axle_stage.h"

#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/axle_stage_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <utility>

using namespace fulcrum;

namespace {

// A loop whose plan has an axle, led by a hand; the lesson lives.
struct TurnedByLoop {
    explicit TurnedByLoop(const HapticPlan& plan) : bench(plan, {.axles = axles.get()}) {
        REQUIRE(validate(plan));
    }
    const AxleReport& run(const Vector3& hand_W) {
        bench.device.pose_D = Pose::at(hand_W);
        bench.run(1);
        REQUIRE(axles->frame.take());
        return axles->frame.value().axles[0];
    }
    std::unique_ptr<AxleChannels> axles = std::make_unique<AxleChannels>();
    Bench bench;
};

}  // namespace

TEST_CASE("axle stage: a force turns a body by r x F over its inertia, through the axis not") {
    StagedAxle axle(make_beam(0.1));
    axle.rest = {Pose::at(Vector3(0.2, 0.3, 0))};
    AxleReport report;
    // 2 N downwards on the beam, 0.4 m to the right: the beam pushes the hand up.
    for (int i = 0; i < 100; ++i) {
        report =
            axle.push(make_contact(Vector3(0.6, 0.35, 0), Vector3::UnitY()), make_push({0, 2, 0}));
    }
    CHECK(report.touched);
    CHECK(report.torque_Nm == Approx(-0.8));
    CHECK(report.spin_rad_per_s == Approx(-0.8 / 0.1 * 0.1));
    CHECK(report.angle_rad == Approx(-0.5 * 8.0 * 0.01));
    CHECK((report.force_W - Vector3(0, -2, 0)).norm() < kRounding);
    CHECK((report.pivot_W - Vector3(0.2, 0.3, 0)).norm() < kRounding);
    CHECK((report.at_W - Vector3(0.6, 0.35, 0)).norm() < kRounding);
    const auto spin_after = [](double x_m) {
        StagedAxle pushed(make_beam());
        double spin = 0.0;
        for (int i = 0; i < 50; ++i) {
            spin = pushed
                       .push(make_contact(Vector3(x_m, 0.05, 0), Vector3::UnitY()),
                             make_push({0, 2, 0}))
                       .spin_rad_per_s;
        }
        return spin;
    };
    const double rim = spin_after(0.4);
    CHECK(spin_after(0.1) == Approx(rim / 4.0));
    CHECK(spin_after(-0.4) == Approx(-rim));
    CHECK(spin_after(0.0) == 0.0);
}

TEST_CASE("axle stage: of two touched solids each takes its share") {
    StagedAxle axle(make_beam_and_ball());
    ProxyContact contact = make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitY());
    contact.n_constraints = 2;
    contact.touches[0].push_m = 0.003;
    contact.touches[1] = {1, -1, Vector3::UnitX(), 0.004};
    // The whole force is 5 N along (4, 3); the beam holds its part along y.
    CHECK((axle.push(contact, make_push({4, 3, 0})).force_W - Vector3(0, -3, 0)).norm() <
          kRounding);
    // The other alone: nothing on the beam.
    const AxleReport other =
        axle.push(make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitX(), 1), make_push({4, 0, 0}));
    CHECK_FALSE(other.touched);
    CHECK(other.torque_Nm == 0.0);
}

TEST_CASE("axle stage: a ball presses where it touches, not where its middle is") {
    HapticPlan plan = make_beam();
    plan.proxy.cursor = SphereShape{0.02};
    CHECK(StagedAxle(plan)
              .push(make_contact(Vector3(0.4, 0.07, 0), Vector3::UnitY()), make_push({1, 2, 0}))
              .torque_Nm == Approx(0.4 * -2.0 - 0.05 * -1.0));
}

TEST_CASE("axle stage: the inertia that it tells is that about the pivot where it lies now") {
    HapticPlan plan = make_beam(0.1);
    plan.axles[0].axle.mass_kg = 2.0;
    StagedAxle axle(plan);
    axle.order.is_set = true;
    // Steiner: m d^2 more.
    for (const auto& [pivot_m, more_kg_m2] :
         {std::pair{0.0, 0.0}, {0.3, 2.0 * 0.09}, {-0.5, 2.0 * 0.25}, {0.0, 0.0}}) {
        axle.order.pivot_B = {pivot_m, 0, 0};
        CHECK(axle.obey().inertia_kg_m2 == Approx(0.1 + more_kg_m2).epsilon(1e-12));
    }
    CHECK(StagedAxle(plan).obey().inertia_kg_m2 == 0.1);
}

TEST_CASE("axle stage: a lesson sets angle and spin once, pivot and load for good") {
    StagedAxle axle(make_beam(0.1));
    axle.rest = {Pose::at(Vector3(0, 1, 0))};
    axle.order = {
        .n_angles = 1, .angle_rad = std::numbers::pi / 2, .n_spins = 1, .spin_rad_per_s = 2.0};
    CHECK(axle.obey().angle_rad == Approx(std::numbers::pi / 2 + 0.002));
    CHECK(axle.stage.put() == 1U);
    CHECK((axle.turned[0] * Vector3(0.5, 0, 0) - Vector3(0, 1.5, 0)).norm() < kRounding);
    // The same counts: nothing new.
    CHECK(axle.obey().angle_rad == Approx(std::numbers::pi / 2 + 0.004));
    CHECK(axle.stage.put() == 0U);
    axle.order.is_set = true;
    axle.order.pivot_B = {0.3, 0, 0};
    const AxleReport moved = axle.obey();
    CHECK(axle.stage.put() == 1U);
    CHECK((moved.pivot_W - Vector3(0.3, 1, 0)).norm() < kRounding);
    // What is no number is not taken.
    axle.order.n_spins = 2;
    axle.order.spin_rad_per_s = kNan;
    axle.order.pivot_B.x() = kNan;
    const AxleReport kept = axle.obey();
    CHECK(kept.spin_rad_per_s == Approx(2.0));
    CHECK(kept.pivot_W.x() == Approx(0.3));
}

TEST_CASE("axle stage: a round thing is turned by friction alone, and its surface goes with it") {
    for (const double friction : {0.0, 1.0}) {
        HapticPlan plan = make_globe();
        plan.solids[0].friction = {.static_coefficient = friction,
                                   .dynamic_coefficient = 0.8 * friction};
        plan.proxy.kind = ProxyKind::friction_cone;
        TurnedByLoop turned(plan);
        AxleReport report;
        // Down on the globe's right side, then towards the viewer.
        for (int i = 0; i < 1200; ++i) {
            const double way_m = i < 400 ? 0.0 : 0.05 * (i - 400) * 1e-3;
            const double in_m = i < 100 ? 0.0 : std::min((i - 100) * 1e-4, 0.004);
            report = turned.run(Vector3(0.101 - in_m, 0.0, way_m));
        }
        INFO(friction << ": " << report.angle_rad);
        // With friction the hand has gone 40 mm along a circle of 0.1 m: -0.4 rad about +Y.
        const double expected_rad = friction == 0.0 ? 0.0 : -std::atan2(0.04, 0.1);
        CHECK(report.angle_rad == Approx(expected_rad).margin(friction == 0.0 ? 1e-6 : 0.06));
    }
}

TEST_CASE("axle stage: a hand on the lightest body that is allowed rests, and the body with it") {
    for (const double stiffness : {500.0, 1000.0}) {
        HapticPlan plan = make_beam(kLeastRimMass_kg * 0.51 * 0.51);
        plan.coupling.stiffness_N_per_m = stiffness;
        plan.axles[0].axle.load_B = {-0.25, 0, 0};
        TurnedByLoop turned(plan);
        double fastest_rad_per_s = 0.0;
        AxleReport report;
        for (int i = 0; i < 8000; ++i) {
            // A weight on the left end, once the gate lets the hand hold the right one.
            if (i == 2500) {
                AxleOrders orders;
                orders.axles[0].is_set = true;
                orders.axles[0].load_N = 4.0;
                turned.axles->orders.publish(orders);
            }
            // A hand held still 2 mm above the right end, which the load lifts against it.
            report = turned.run(Vector3(0.45, 0.052, 0.0));
            const double spin = std::abs(report.spin_rad_per_s);
            fastest_rad_per_s = i > 6000 ? std::max(fastest_rad_per_s, spin) : 0.0;
        }
        INFO(stiffness);
        CHECK(fastest_rad_per_s < 1e-3);
        CHECK(report.torque_Nm == Approx(-1.0).epsilon(0.01));
    }
}

TEST_CASE("axle stage: bad plans are refused, and it is there where something turns, only there") {
    CHECK(validate_axles(make_beam(0.1)));
    CHECK(validate_axles(HapticPlan{}));
    const HapticPlan light = make_beam(0.02);
    CHECK(to_sentence(validate_axles(light).error()) ==
          "an inertia of 0.02 kg m^2 is too little for a body that a hand presses 0.51 m from its "
          "axis: it would shake; give it at least 0.02601 kg m^2.");
    CHECK_FALSE(validate(light));
    const auto refuses = [](auto spoil) {
        HapticPlan plan = make_beam();
        spoil(plan, plan.axles[0]);
        return !validate_axles(plan);
    };
    CHECK(refuses([](HapticPlan&, AxlePlan& axle) { axle.solid = 1; }));
    CHECK(refuses([](HapticPlan& plan, AxlePlan& axle) { plan.axles = {axle, axle}; }));
    CHECK(refuses([](HapticPlan&, AxlePlan& axle) { axle.axle.axis_W = Vector3(0, 0, 2); }));
    CHECK(refuses([](HapticPlan&, AxlePlan& axle) { axle.reach_m = kNan; }));
    CHECK(make_axle_stage(HapticPlan{}, nullptr) == nullptr);
    HapticPlan plan = make_beam();
    const auto stage = make_axle_stage(plan, nullptr);
    REQUIRE(stage != nullptr);
    CHECK(stage->memory_bytes() >= sizeof(AxleStage));
    CHECK(Bench(plan).stages().find("turning") != std::string::npos);
    plan.axles.clear();
    CHECK(Bench(plan).stages().find("turning") == std::string::npos);
}

// What an axle takes from a hand, a tool and a lesson, and what it leaves.

TEST_CASE("axle stage: what is not felt turns nothing; a wedge presses no harder than is felt") {
    for (const double most_N : {5.0, 0.3, 0.0}) {
        CHECK(StagedAxle(make_beam())
                  .push(make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitY()),
                        make_push({0, 50, 0}, most_N))
                  .torque_Nm == Approx(-most_N * 0.4));
    }
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
