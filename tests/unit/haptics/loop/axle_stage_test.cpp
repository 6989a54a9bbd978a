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

TEST_CASE("axle stage: a hand's force turns a body by r x F over its inertia") {
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
}

TEST_CASE("axle stage: the same push near the axis turns less, and through the axis not at all") {
    const auto spin_after = [](double x_m) {
        StagedAxle axle(make_beam());
        double spin = 0.0;
        for (int i = 0; i < 50; ++i) {
            spin = axle.push(make_contact(Vector3(x_m, 0.05, 0), Vector3::UnitY()),
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

TEST_CASE("axle stage: the damper drags a body along only where friction holds") {
    for (const double drag_m : {0.0, 0.001}) {
        ProxyContact contact = make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitY());
        contact.touches[0].drag_W = Vector3(drag_m, 0, 0);
        // 2 N of the spring; the damper gives 1 N along the normal and 3 N along the surface.
        const AxleReport report =
            StagedAxle(make_beam()).push(contact, {Vector3(3, 3, 0), Vector3(0, 2, 0), kLimit_N});
        const Vector3 expected = drag_m > 0.0 ? Vector3(-3, -3, 0) : Vector3(0, -3, 0);
        CHECK((report.force_W - expected).norm() < kRounding);
    }
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
    CHECK(axle.proxy.n_put == 1);
    CHECK(axle.proxy.put == 0);
    CHECK((axle.turned[0] * Vector3(0.5, 0, 0) - Vector3(0, 1.5, 0)).norm() < kRounding);
    // The same counts: nothing new.
    CHECK(axle.obey().angle_rad == Approx(std::numbers::pi / 2 + 0.004));
    CHECK(axle.proxy.n_put == 1);
    axle.order.is_set = true;
    axle.order.pivot_B = {0.3, 0, 0};
    const AxleReport moved = axle.obey();
    CHECK(axle.proxy.n_put == 2);
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

TEST_CASE("axle stage: plans that make no sense are refused with a sentence") {
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
}

TEST_CASE("axle stage: it is there where something turns, and only there") {
    CHECK(make_axle_stage(HapticPlan{}, nullptr) == nullptr);
    HapticPlan plan = make_beam();
    const auto stage = make_axle_stage(plan, nullptr);
    REQUIRE(stage != nullptr);
    CHECK(stage->memory_bytes() >= sizeof(AxleStage));
    CHECK(Bench(plan).stages().find("turning") != std::string::npos);
    plan.axles.clear();
    CHECK(Bench(plan).stages().find("turning") == std::string::npos);
}
