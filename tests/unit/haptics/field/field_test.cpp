#include "haptics/field/field.h"

#include "haptics/field/magnet.h"
#include "haptics/field/viscosity.h"
#include "tests/unit/haptics/field/field_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <rapidcheck.h>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-12;

// What a field gives that is wholly on, its anchor at rest.
Vector3 feel(const FieldPlan& plan, const Vector3& anchor, const Vector3& position,
             const Vector3& velocity) {
    FieldStage field(plan);
    FieldCommand command;
    command.anchor_W = anchor;
    Vector3 force = Vector3::Zero();
    for (int k = 0; k < 200; ++k) {
        force = field.step(command, position, velocity, kDt_s);
    }
    CHECK(field.strength() == 1.0);
    return force;
}

}  // namespace

TEST_CASE("spring: Hooke's law with a damper, in closed form") {
    const Vector3 force = feel(make_spring(), {0.1, 0.0, 0.0}, {0.02, 0.0, 0.0}, {0.0, 0.5, 0.0});
    CHECK((force - Vector3(8.0, -1.0, 0.0)).norm() < kRounding);
}

TEST_CASE("field: a liquid brakes and holds nothing, a magnet pulls and brakes nothing") {
    FieldPlan honey = make_spring();
    honey.kind = FieldKind::viscosity;
    const Vector3 velocity(0.0, 0.5, -1.0);
    CHECK((feel(honey, {0.1, 0.0, 0.0}, {0.02, 0.0, 0.0}, velocity) + 2.0 * velocity).norm() <
          kRounding);
    FieldPlan magnet = make_magnet();
    magnet.damping_Ns_per_m = 2.0;
    // At its range, 0.05 m, its peak.
    const Vector3 pull = feel(magnet, {0.1, 0.0, 0.0}, {0.05, 0.0, 0.0}, velocity);
    CHECK((pull - Vector3(3.0, 0.0, 0.0)).norm() < 1e-9);
}

TEST_CASE("viscosity: the force opposes the motion and its power is never positive") {
    CHECK(rc::check([](int x, int y, int z) {
        const Vector3 velocity = 1e-6 * Vector3(x, y, z);
        const Vector3 force = compute_viscous_force(velocity, 3.0);
        RC_ASSERT((force + 3.0 * velocity).norm() == 0.0);
        RC_ASSERT(force.dot(velocity) <= 0.0);
    }));
}

TEST_CASE(
    "magnet: zero at the centre, its peak at its range, nothing far away, never above the peak") {
    const Vector3 anchor(0.3, -0.1, 0.2);
    const Vector3 way = Vector3(2.0, -1.0, 2.0) / 3.0;
    CHECK(compute_magnet_force(anchor, anchor, 3.0, 0.05).norm() == 0.0);
    const Vector3 at_range = compute_magnet_force(anchor + 0.05 * way, anchor, 3.0, 0.05);
    CHECK((at_range + 3.0 * way).norm() < 1e-9);
    CHECK(compute_magnet_force(anchor + 0.5 * way, anchor, 3.0, 0.05).norm() < 1e-15);
    for (int i = 0; i < 1000; ++i) {
        const Vector3 force = compute_magnet_force(anchor + 0.0005 * i * way, anchor, 3.0, 0.05);
        REQUIRE(force.norm() <= 3.0 * (1.0 + kRounding));
        REQUIRE(force.dot(way) <= 0.0);
    }
}

TEST_CASE(
    "magnet: the force is the slope of its potential, and its stiffness at the centre is as "
    "stated") {
    const auto potential_J = [](double r_m) {
        const double s = r_m / 0.05;
        return -3.0 * 0.05 * std::exp(0.5 * (1.0 - s * s));
    };
    for (const double r_m : {0.001, 0.02, 0.05, 0.09, 0.15}) {
        const double h = 1e-6;
        const double slope = (potential_J(r_m + h) - potential_J(r_m - h)) / (2.0 * h);
        const double force =
            compute_magnet_force(Vector3(r_m, 0, 0), Vector3::Zero(), 3.0, 0.05).x();
        CHECK(force == Approx(-slope).margin(1e-6));
    }
    const double near_N = compute_magnet_force(Vector3(1e-6, 0, 0), Vector3::Zero(), 3.0, 0.05).x();
    CHECK(near_N / 1e-6 == Approx(-3.0 * std::sqrt(std::exp(1.0)) / 0.05).epsilon(1e-6));
}

TEST_CASE("field: it switches on along a ramp and then obeys its law") {
    const FieldPlan plan = make_spring();
    FieldStage field(plan);
    FieldCommand command;
    command.anchor_W = plan.anchor_W;
    const Vector3 position(0.0, 0.0, 0.0);
    const Vector3 velocity(0.0, 0.1, 0.0);
    const Vector3 full(10.0, -0.2, 0.0);
    for (int k = 1; k <= 200; ++k) {
        const double strength = std::min(k * kDt_s * 10.0, 1.0);
        REQUIRE((field.step(command, position, velocity, kDt_s) - strength * full).norm() < 1e-9);
    }
    command.strength = 0.5;
    for (int k = 0; k < 200; ++k) {
        (void)field.step(command, position, velocity, kDt_s);
    }
    CHECK((field.step(command, position, velocity, kDt_s) - 0.5 * full).norm() < 1e-9);
    command.on = false;
    for (int k = 1; k < 50; ++k) {
        const double strength = 0.5 - 10.0 * k * kDt_s;
        REQUIRE((field.step(command, position, velocity, kDt_s) - strength * full).norm() < 1e-9);
    }
    (void)field.step(command, position, velocity, kDt_s);
    CHECK(field.step(command, position, velocity, kDt_s).norm() == 0.0);
}

TEST_CASE("field: a strength outside 0 to 1 counts as the nearest") {
    FieldStage field(make_spring());
    FieldCommand command;
    command.strength = 50.0;
    for (int k = 0; k < 300; ++k) {
        (void)field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s);
    }
    CHECK(field.strength() == 1.0);
    command.strength = -3.0;
    for (int k = 0; k < 300; ++k) {
        (void)field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s);
    }
    CHECK(field.strength() == 0.0);
}

TEST_CASE(
    "field: an anchor that jumps is followed in closed form, and a field that was off starts at "
    "it") {
    FieldPlan plan = make_spring();
    plan.damping_Ns_per_m = 0.0;
    FieldStage field(plan);
    FieldCommand command;
    command.anchor_W = Vector3(0.05, 0.0, 0.0);
    for (int k = 0; k < 200; ++k) {
        (void)field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s);
    }
    CHECK(field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s).x() == Approx(5.0));
    command.anchor_W = Vector3(0.0, 0.02, 0.0);
    for (int k = 1; k <= 50; ++k) {
        const double left = std::exp(-k * kDt_s / 0.02);
        const Vector3 anchor =
            command.anchor_W + left * (Vector3(0.05, 0.0, 0.0) - command.anchor_W);
        REQUIRE(
            (field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s) - 100.0 * anchor).norm() <
            1e-9);
    }
}

TEST_CASE("field: a time that is no time passes none") {
    FieldStage field(make_spring());
    const FieldCommand command;
    for (int k = 0; k < 50; ++k) {
        (void)field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s);
    }
    const double before = field.strength();
    REQUIRE(before == Approx(0.5));
    for (const double dt_s : {std::numeric_limits<double>::quiet_NaN(), -0.01, -1e300}) {
        CHECK(field.step(command, Vector3::Zero(), Vector3::Zero(), dt_s).allFinite());
        CHECK(field.strength() == before);
    }
}

TEST_CASE("field: an anchor at the end of all numbers is no place, and a field gets over it") {
    for (const bool while_on : {false, true}) {
        FieldPlan plan = make_spring();
        plan.damping_Ns_per_m = 0.0;
        FieldStage field(plan);
        FieldCommand command;
        command.anchor_W = Vector3(0.05, 0.0, 0.0);
        for (int k = 0; k < (while_on ? 200 : 0); ++k) {
            (void)field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s);
        }
        for (int k = 0; k < 200; ++k) {
            command.anchor_W = Vector3(k % 2 == 0 ? 1e308 : -1e308, 0.0, 0.0);
            REQUIRE(field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s).norm() <= 5.0001);
        }
        CHECK(field.strength() == 0.0);
        command.anchor_W = Vector3(0.05, 0.0, 0.0);
        for (int k = 0; k < 200; ++k) {
            (void)field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s);
        }
        CHECK(field.step(command, Vector3::Zero(), Vector3::Zero(), kDt_s).x() == Approx(5.0));
    }
}

TEST_CASE("field: its largest gains are the slopes of its law, of a magnet at the centre") {
    const auto slope = [](const FieldPlan& plan) {
        const double h = 1e-7;
        const Vector3 away = plan.anchor_W + Vector3(h, 0, 0);
        return -feel(plan, plan.anchor_W, away, Vector3::Zero()).x() / h;
    };
    FieldPlan honey = make_spring();
    honey.kind = FieldKind::viscosity;
    for (const FieldPlan& plan : {make_spring(), make_magnet(), honey}) {
        const FieldGains gains = compute_largest_gains(plan);
        CHECK(gains.stiffness_N_per_m == Approx(slope(plan)).margin(1e-6).epsilon(1e-6));
        CHECK(
            gains.damping_Ns_per_m ==
            Approx(-feel(plan, plan.anchor_W, plan.anchor_W, Vector3(1, 0, 0)).x()).margin(1e-12));
    }
}

TEST_CASE("field: a command that is not finite lets the field go") {
    FieldStage field(make_magnet());
    FieldCommand command;
    for (int k = 0; k < 200; ++k) {
        (void)field.step(command, Vector3(0.05, 0, 0), Vector3::Zero(), kDt_s);
    }
    command.anchor_W.x() = std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k < 200; ++k) {
        REQUIRE(field.step(command, Vector3(0.05, 0, 0), Vector3::Zero(), kDt_s).allFinite());
    }
    CHECK(field.strength() == 0.0);
    command = {};
    command.strength = std::numeric_limits<double>::infinity();
    CHECK(field.step(command, Vector3(0.05, 0, 0), Vector3::Zero(), kDt_s).norm() == 0.0);
}

TEST_CASE(
    "field: what it tells of its elastic part is its force without the damper, now and held") {
    for (const FieldPlan& plan : {make_spring(), make_magnet()}) {
        FieldStage field(plan);
        FieldCommand command;
        command.anchor_W = plan.anchor_W;
        const Vector3 velocity(0.3, -0.2, 0.1);
        Vector3 x(0.02, 0.01, -0.03);
        const auto pull = [&](const Vector3& anchor) {
            return feel(plan, anchor, x, Vector3::Zero());
        };
        // While it is switched on: held at the strength it had.
        (void)field.step(command, x, velocity, kDt_s);
        const double before = field.strength();
        x.x() += 0.001;
        const Vector3 force = field.step(command, x, velocity, kDt_s);
        CHECK((field.elastic().now_W - field.strength() * pull(plan.anchor_W)).norm() < kRounding);
        CHECK((field.elastic().held_W - before * pull(plan.anchor_W)).norm() < kRounding);
        const double damping = plan.kind == FieldKind::spring ? 2.0 : 0.0;
        CHECK((force - field.elastic().now_W + field.strength() * damping * velocity).norm() <
              kRounding);
        for (int k = 0; k < 200; ++k) {
            (void)field.step(command, x, velocity, kDt_s);
        }
        CHECK(field.elastic().now_W == field.elastic().held_W);
        // An anchor that is moved: held where it was.
        command.anchor_W = plan.anchor_W + Vector3(0.0, 0.05, 0.0);
        (void)field.step(command, x, velocity, kDt_s);
        const Vector3 moved =
            plan.anchor_W + (1.0 - std::exp(-kDt_s / kAnchorTime_s)) * Vector3(0.0, 0.05, 0.0);
        CHECK((field.elastic().now_W - pull(moved)).norm() < kRounding);
        CHECK((field.elastic().held_W - pull(plan.anchor_W)).norm() < kRounding);
        // Off and gone.
        command.on = false;
        for (int k = 0; k < 200; ++k) {
            (void)field.step(command, x, velocity, kDt_s);
        }
        CHECK(field.elastic().now_W.norm() == 0.0);
        CHECK(field.elastic().held_W.norm() == 0.0);
    }
    FieldPlan honey;
    honey.kind = FieldKind::viscosity;
    honey.damping_Ns_per_m = 3.0;
    FieldStage liquid(honey);
    CHECK(liquid.step({}, Vector3::Zero(), Vector3(1, 0, 0), kDt_s).x() < 0.0);
    CHECK(liquid.elastic().now_W.norm() == 0.0);
    CHECK(liquid.elastic().held_W.norm() == 0.0);
}
