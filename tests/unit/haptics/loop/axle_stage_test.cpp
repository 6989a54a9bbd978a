#include "haptics/loop/axle_stage.h"

#include "tests/unit/haptics/loop/axle_stage_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>

using namespace fulcrum;

TEST_CASE("axle stage: a hand's force turns a body by r x F over its inertia") {
    const HapticPlan plan = make_beam(0.1);
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    const Pose rest[] = {Pose::at(Vector3(0.2, 0.3, 0))};
    // 2 N downwards on the beam, 0.4 m to the right: the beam pushes the hand up.
    for (int i = 0; i < 100; ++i) {
        (void)stage.turn(rest, proxy);
        stage.push(make_contact(Vector3(0.6, 0.35, 0), Vector3::UnitY()),
                   {Vector3(0, 2, 0), Vector3(0, 2, 0), kLimit_N}, 1e-3);
    }
    REQUIRE(channels->frame.take());
    const AxleReport& report = channels->frame.value().axles[0];
    CHECK(channels->frame.value().n_axles == 1);
    CHECK(report.touched);
    CHECK(report.torque_Nm == Approx(-0.8));
    CHECK(report.spin_rad_per_s == Approx(-0.8 / 0.1 * 0.1));
    CHECK(report.angle_rad == Approx(-0.5 * 8.0 * 0.01));
    CHECK((report.force_W - Vector3(0, -2, 0)).norm() < kRounding);
    CHECK((report.pivot_W - Vector3(0.2, 0.3, 0)).norm() < kRounding);
    CHECK((report.at_W - Vector3(0.6, 0.35, 0)).norm() < kRounding);
}

TEST_CASE("axle stage: the same push near the axis turns less, and through the axis not at all") {
    const HapticPlan plan = make_beam();
    const auto spin_after = [&](const Vector3& at_W) {
        const auto channels = std::make_unique<AxleChannels>();
        AxleStage stage(plan, channels.get());
        StillProxy proxy;
        const Pose rest[] = {Pose{}};
        for (int i = 0; i < 50; ++i) {
            (void)stage.turn(rest, proxy);
            stage.push(make_contact(at_W, Vector3::UnitY()),
                       {Vector3(0, 2, 0), Vector3(0, 2, 0), kLimit_N}, 1e-3);
        }
        REQUIRE(channels->frame.take());
        return channels->frame.value().axles[0].spin_rad_per_s;
    };
    const double rim = spin_after(Vector3(0.4, 0.05, 0));
    CHECK(spin_after(Vector3(0.1, 0.05, 0)) == Approx(rim / 4.0));
    CHECK(spin_after(Vector3(-0.4, 0.05, 0)) == Approx(-rim));
    CHECK(spin_after(Vector3(0.0, 0.05, 0)) == 0.0);
}

TEST_CASE("axle stage: of two touched solids each takes its share") {
    HapticPlan plan = make_beam();
    plan.solids.push_back({.body = 1, .shape = SphereShape{0.1}});
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    const Pose rest[] = {Pose{}, Pose{}};
    (void)stage.turn(rest, proxy);
    ProxyContact contact = make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitY());
    contact.n_constraints = 2;
    contact.touches[0].push_m = 0.003;
    contact.touches[1] = {1, -1, Vector3::UnitX(), 0.004};
    // The whole force is 5 N along (4, 3); the beam holds its part along y.
    stage.push(contact, {Vector3(4, 3, 0), Vector3(4, 3, 0), kLimit_N}, 1e-3);
    REQUIRE(channels->frame.take());
    CHECK((channels->frame.value().axles[0].force_W - Vector3(0, -3, 0)).norm() < kRounding);
    // The other alone: nothing on the beam.
    (void)stage.turn(rest, proxy);
    stage.push(make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitX(), 1),
               {Vector3(4, 0, 0), Vector3(4, 0, 0), kLimit_N}, 1e-3);
    REQUIRE(channels->frame.take());
    CHECK_FALSE(channels->frame.value().axles[0].touched);
    CHECK(channels->frame.value().axles[0].torque_Nm == 0.0);
}

TEST_CASE("axle stage: the damper drags a body along only where friction holds") {
    const HapticPlan plan = make_beam();
    for (const double drag_m : {0.0, 0.001}) {
        const auto channels = std::make_unique<AxleChannels>();
        AxleStage stage(plan, channels.get());
        StillProxy proxy;
        const Pose rest[] = {Pose{}};
        (void)stage.turn(rest, proxy);
        ProxyContact contact = make_contact(Vector3(0.4, 0.05, 0), Vector3::UnitY());
        contact.touches[0].drag_W = Vector3(drag_m, 0, 0);
        // 2 N of the spring; the damper gives 1 N along the normal and 3 N along the surface.
        stage.push(contact, {Vector3(3, 3, 0), Vector3(0, 2, 0), kLimit_N}, 1e-3);
        REQUIRE(channels->frame.take());
        const Vector3 expected = drag_m > 0.0 ? Vector3(-3, -3, 0) : Vector3(0, -3, 0);
        CHECK((channels->frame.value().axles[0].force_W - expected).norm() < kRounding);
    }
}

TEST_CASE("axle stage: a ball presses where it touches, not where its middle is") {
    HapticPlan plan = make_beam();
    plan.proxy.cursor = SphereShape{0.02};
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    const Pose rest[] = {Pose{}};
    (void)stage.turn(rest, proxy);
    stage.push(make_contact(Vector3(0.4, 0.07, 0), Vector3::UnitY()),
               {Vector3(1, 2, 0), Vector3(1, 2, 0), kLimit_N}, 1e-3);
    REQUIRE(channels->frame.take());
    CHECK(channels->frame.value().axles[0].torque_Nm == Approx(0.4 * -2.0 - 0.05 * -1.0));
}

TEST_CASE("axle stage: the inertia that it tells is that about the pivot where it lies now") {
    HapticPlan plan = make_beam(0.1);
    plan.axles[0].axle.mass_kg = 2.0;
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    const Pose rest[] = {Pose{}};
    AxleOrders orders;
    const auto told_kg_m2 = [&](double pivot_m) {
        orders.axles[0].is_set = true;
        orders.axles[0].pivot_B = {pivot_m, 0, 0};
        channels->orders.publish(orders);
        (void)stage.turn(rest, proxy);
        stage.push({}, {}, 1e-3);
        REQUIRE(channels->frame.take());
        return channels->frame.value().axles[0].inertia_kg_m2;
    };
    // Steiner: m d^2 more.
    CHECK(told_kg_m2(0.0) == 0.1);
    CHECK(told_kg_m2(0.3) == Approx(0.1 + 2.0 * 0.09).epsilon(1e-12));
    CHECK(told_kg_m2(-0.5) == Approx(0.1 + 2.0 * 0.25).epsilon(1e-12));
    CHECK(told_kg_m2(0.0) == Approx(0.1).epsilon(1e-12));
}

TEST_CASE("axle stage: a lesson sets angle and spin once, pivot and load for good") {
    const HapticPlan plan = make_beam(0.1);
    const auto channels = std::make_unique<AxleChannels>();
    AxleStage stage(plan, channels.get());
    StillProxy proxy;
    const Pose rest[] = {Pose::at(Vector3(0, 1, 0))};
    AxleOrders orders;
    orders.axles[0] = {
        .n_angles = 1, .angle_rad = std::numbers::pi / 2, .n_spins = 1, .spin_rad_per_s = 2.0};
    channels->orders.publish(orders);
    const auto poses = stage.turn(rest, proxy);
    CHECK(proxy.n_put == 1);
    CHECK(proxy.put == 0);
    CHECK((poses[0] * Vector3(0.5, 0, 0) - Vector3(0, 1.5, 0)).norm() < kRounding);
    stage.push({}, {}, 1e-3);
    channels->orders.publish(orders);  // the same counts: nothing new
    (void)stage.turn(rest, proxy);
    CHECK(proxy.n_put == 1);
    REQUIRE(channels->frame.take());
    CHECK(channels->frame.value().axles[0].angle_rad == Approx(std::numbers::pi / 2 + 0.002));
    orders.axles[0].is_set = true;
    orders.axles[0].pivot_B = {0.3, 0, 0};
    channels->orders.publish(orders);
    (void)stage.turn(rest, proxy);
    CHECK(proxy.n_put == 2);
    stage.push({}, {}, 1e-3);
    REQUIRE(channels->frame.take());
    CHECK((channels->frame.value().axles[0].pivot_W - Vector3(0.3, 1, 0)).norm() < kRounding);
    // What is no number is not taken.
    orders.axles[0].n_spins = 2;
    orders.axles[0].spin_rad_per_s = std::numeric_limits<double>::quiet_NaN();
    orders.axles[0].pivot_B.x() = std::numeric_limits<double>::quiet_NaN();
    channels->orders.publish(orders);
    (void)stage.turn(rest, proxy);
    stage.push({}, {}, 1e-3);
    REQUIRE(channels->frame.take());
    CHECK(channels->frame.value().axles[0].spin_rad_per_s == Approx(2.0));
    CHECK(channels->frame.value().axles[0].pivot_W.x() == Approx(0.3));
}

TEST_CASE(
    "axle stage: a round thing is turned by its friction alone, and its surface goes with it") {
    for (const double friction : {0.0, 1.0}) {
        HapticPlan plan = make_globe();
        plan.solids[0].friction = {.static_coefficient = friction,
                                   .dynamic_coefficient = 0.8 * friction};
        plan.proxy.kind = ProxyKind::friction_cone;
        const auto axles = std::make_unique<AxleChannels>();
        HapticChannels* given = nullptr;
        ScriptedDevice device;
        const auto channels = std::make_unique<HapticChannels>();
        channels->axles = axles.get();
        given = channels.get();
        REQUIRE(validate(plan));
        HapticLoop loop(plan, device, *given);
        ForceCommand command;
        command.lesson_alive = true;
        double now_s = 0.0;
        // Down on the globe's right side, then towards the viewer.
        for (int i = 0; i < 1200; ++i) {
            now_s += kDt_s;
            command.stamp_s = now_s;
            channels->command.publish(command);
            const double way_m = i < 400 ? 0.0 : 0.05 * (i - 400) * 1e-3;
            const double in_m = i < 100 ? 0.0 : std::min((i - 100) * 1e-4, 0.004);
            device.pose_D = Pose::at(Vector3(0.101 - in_m, 0.0, way_m));
            loop.step(now_s);
        }
        REQUIRE(axles->frame.take());
        const AxleReport& report = axles->frame.value().axles[0];
        INFO(friction << ": " << report.angle_rad);
        if (friction == 0.0) {
            CHECK(std::abs(report.angle_rad) < 1e-6);
        } else {
            // The hand has gone 40 mm along a circle of 0.1 m: -0.4 rad about +Y.
            CHECK(report.angle_rad == Approx(-std::atan2(0.04, 0.1)).margin(0.06));
        }
    }
}

TEST_CASE("axle stage: a hand on the lightest body that is allowed rests, and the body with it") {
    for (const double stiffness : {500.0, 1000.0}) {
        HapticPlan plan = make_beam();
        plan.coupling.stiffness_N_per_m = stiffness;
        plan.axles[0].axle.inertia_kg_m2 = kLeastRimMass_kg * 0.51 * 0.51;
        plan.axles[0].axle.load_B = {-0.25, 0, 0};
        REQUIRE(validate(plan));
        const auto axles = std::make_unique<AxleChannels>();
        ScriptedDevice device;
        const auto channels = std::make_unique<HapticChannels>();
        channels->axles = axles.get();
        HapticLoop loop(plan, device, *channels);
        ForceCommand command;
        command.lesson_alive = true;
        double fastest_rad_per_s = 0.0;
        for (int i = 0; i < 8000; ++i) {
            const double now_s = (i + 1) * kDt_s;
            command.stamp_s = now_s;
            channels->command.publish(command);
            // A weight on the left end, once the gate lets the hand hold the right one.
            if (i == 2500) {
                AxleOrders orders;
                orders.axles[0].is_set = true;
                orders.axles[0].load_N = 4.0;
                axles->orders.publish(orders);
            }
            // A hand held still 2 mm above the right end, which the load lifts against it.
            device.pose_D = Pose::at(Vector3(0.45, 0.052, 0.0));
            loop.step(now_s);
            REQUIRE(axles->frame.take());
            const double spin = std::abs(axles->frame.value().axles[0].spin_rad_per_s);
            fastest_rad_per_s = i > 6000 ? std::max(fastest_rad_per_s, spin) : 0.0;
        }
        INFO(stiffness);
        CHECK(fastest_rad_per_s < 1e-3);
        CHECK(axles->frame.value().axles[0].torque_Nm == Approx(-1.0).epsilon(0.01));
    }
}

TEST_CASE("axle stage: plans that make no sense are refused with a sentence") {
    HapticPlan plan = make_beam(0.1);
    CHECK(validate_axles(plan));
    CHECK(validate_axles(HapticPlan{}));
    plan.axles[0].axle.inertia_kg_m2 = 0.02;
    CHECK(to_sentence(validate_axles(plan).error()) ==
          "an inertia of 0.02 kg m^2 is too little for a body that a hand presses 0.51 m from its "
          "axis: it would shake; give it at least 0.02601 kg m^2.");
    CHECK_FALSE(validate(plan));
    plan = make_beam();
    plan.axles[0].solid = 1;
    CHECK_FALSE(validate_axles(plan));
    plan = make_beam();
    plan.axles.push_back(plan.axles[0]);
    CHECK_FALSE(validate_axles(plan));
    plan = make_beam();
    plan.axles[0].axle.axis_W = Vector3(0, 0, 2);
    CHECK_FALSE(validate_axles(plan));
    plan = make_beam();
    plan.axles[0].reach_m = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate_axles(plan));
}

TEST_CASE("axle stage: it is there where something turns, and only there") {
    CHECK(make_axle_stage(HapticPlan{}, nullptr) == nullptr);
    const HapticPlan plan = make_beam();
    const auto stage = make_axle_stage(plan, nullptr);
    REQUIRE(stage != nullptr);
    CHECK(stage->memory_bytes() >= sizeof(AxleStage));
    ScriptedDevice device;
    const auto channels = std::make_unique<HapticChannels>();
    const auto has_turning = [&](const HapticPlan& of) {
        const HapticLoop loop(of, device, *channels);
        for (const StageInfo& info : loop.stages()) {
            if (info.stage == HapticStage::turning) {
                return info.bytes > 0;
            }
        }
        return false;
    };
    CHECK(has_turning(plan));
    HapticPlan still = plan;
    still.axles.clear();
    CHECK_FALSE(has_turning(still));
}
