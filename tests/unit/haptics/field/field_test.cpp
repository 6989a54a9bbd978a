#include "haptics/field/field.h"

#include "haptics/field/magnet.h"
#include "haptics/field/viscosity.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <rapidcheck.h>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kRounding = 1e-12;

FieldPlan make_spring() {
    FieldPlan plan;
    plan.kind = FieldKind::spring;
    plan.anchor_W = Vector3(0.1, 0.0, 0.0);
    plan.stiffness_N_per_m = 100.0;
    plan.damping_Ns_per_m = 2.0;
    return plan;
}

FieldPlan make_magnet() {
    FieldPlan plan;
    plan.kind = FieldKind::magnet;
    plan.peak_force_N = 3.0;
    plan.range_m = 0.05;
    return plan;
}

// Spring forces alone.
FieldPlan make_undamped() {
    FieldPlan plan = make_spring();
    plan.damping_Ns_per_m = 0.0;
    return plan;
}

FieldPlan make_liquid() {
    FieldPlan plan = make_spring();
    plan.kind = FieldKind::viscosity;
    return plan;
}

// A hand that rests at a place for so many steps; what it feels in the last.
Vector3 rest(FieldStage& field, const FieldCommand& command, int n_steps = 200,
             const Vector3& at = Vector3::Zero(), const Vector3& velocity = Vector3::Zero()) {
    Vector3 force = Vector3::Zero();
    for (int k = 0; k < n_steps; ++k) {
        force = field.step(command, at, velocity, kDt_s);
    }
    return force;
}

// What a field gives that is wholly on, its anchor at rest.
Vector3 feel(const FieldPlan& plan, const Vector3& anchor, const Vector3& position,
             const Vector3& velocity) {
    FieldStage field(plan);
    FieldCommand command;
    command.anchor_W = anchor;
    const Vector3 force = rest(field, command, 200, position, velocity);
    CHECK(field.strength() == 1.0);
    return force;
}

}  // namespace

TEST_CASE("spring: Hooke's law with a damper, in closed form") {
    const Vector3 force = feel(make_spring(), {0.1, 0.0, 0.0}, {0.02, 0.0, 0.0}, {0.0, 0.5, 0.0});
    CHECK((force - Vector3(8.0, -1.0, 0.0)).norm() < kRounding);
}

TEST_CASE("field: a liquid brakes and holds nothing, a magnet pulls and brakes nothing") {
    const Vector3 velocity(0.0, 0.5, -1.0);
    const Vector3 drag = feel(make_liquid(), {0.1, 0.0, 0.0}, {0.02, 0.0, 0.0}, velocity);
    CHECK((drag + 2.0 * velocity).norm() < kRounding);
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

TEST_CASE("magnet: zero at the centre, its peak at its range, the slope of its potential") {
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
    CHECK((rest(field, command, 201, position, velocity) - 0.5 * full).norm() < 1e-9);
    command.on = false;
    for (int k = 1; k < 50; ++k) {
        const double strength = 0.5 - 10.0 * k * kDt_s;
        REQUIRE((field.step(command, position, velocity, kDt_s) - strength * full).norm() < 1e-9);
    }
    CHECK(rest(field, command, 2, position, velocity).norm() == 0.0);
}

TEST_CASE("field: a strength outside 0 to 1 is the nearest; an anchor that jumps is followed") {
    FieldStage field(make_spring());
    FieldCommand command;
    command.strength = 50.0;
    (void)rest(field, command, 300);
    CHECK(field.strength() == 1.0);
    command.strength = -3.0;
    (void)rest(field, command, 300);
    CHECK(field.strength() == 0.0);
    field = FieldStage(make_undamped());
    command = FieldCommand();
    command.anchor_W = Vector3(0.05, 0.0, 0.0);
    CHECK(rest(field, command, 201).x() == Approx(5.0));
    command.anchor_W = Vector3(0.0, 0.02, 0.0);
    for (int k = 1; k <= 50; ++k) {
        const double left = std::exp(-k * kDt_s / 0.02);
        const Vector3 anchor =
            command.anchor_W + left * (Vector3(0.05, 0.0, 0.0) - command.anchor_W);
        REQUIRE((rest(field, command, 1) - 100.0 * anchor).norm() < 1e-9);
    }
}

TEST_CASE("field: a time that is no time passes none") {
    FieldStage field(make_spring());
    const FieldCommand command;
    (void)rest(field, command, 50);
    const double before = field.strength();
    REQUIRE(before == Approx(0.5));
    for (const double dt_s : {kNan, -0.01, -1e300}) {
        CHECK(field.step(command, Vector3::Zero(), Vector3::Zero(), dt_s).allFinite());
        CHECK(field.strength() == before);
    }
}

TEST_CASE("field: anchors and commands that are none let go; the largest gains are its law's") {
    for (const bool while_on : {false, true}) {
        FieldStage field(make_undamped());
        FieldCommand command;
        command.anchor_W = Vector3(0.05, 0.0, 0.0);
        (void)rest(field, command, while_on ? 200 : 0);
        for (int k = 0; k < 200; ++k) {
            command.anchor_W = Vector3(k % 2 == 0 ? 1e308 : -1e308, 0.0, 0.0);
            REQUIRE(rest(field, command, 1).norm() <= 5.0001);
        }
        CHECK(field.strength() == 0.0);
        command.anchor_W = Vector3(0.05, 0.0, 0.0);
        CHECK(rest(field, command, 201).x() == Approx(5.0));
    }
    const auto slope = [](const FieldPlan& plan) {
        const double h = 1e-7;
        const Vector3 away = plan.anchor_W + Vector3(h, 0, 0);
        return -feel(plan, plan.anchor_W, away, Vector3::Zero()).x() / h;
    };
    for (const FieldPlan& plan : {make_spring(), make_magnet(), make_liquid()}) {
        const FieldGains gains = compute_largest_gains(plan);
        CHECK(gains.stiffness_N_per_m == Approx(slope(plan)).margin(1e-6).epsilon(1e-6));
        CHECK(
            gains.damping_Ns_per_m ==
            Approx(-feel(plan, plan.anchor_W, plan.anchor_W, Vector3(1, 0, 0)).x()).margin(1e-12));
    }
    FieldStage field(make_magnet());
    FieldCommand command;
    const Vector3 at(0.05, 0, 0);
    (void)rest(field, command, 200, at);
    command.anchor_W.x() = kNan;
    for (int k = 0; k < 200; ++k) {
        REQUIRE(rest(field, command, 1, at).allFinite());
    }
    CHECK(field.strength() == 0.0);
    command = {};
    command.strength = kInfinity;
    CHECK(rest(field, command, 1, at).norm() == 0.0);
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
        (void)rest(field, command, 200, x, velocity);
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
        (void)rest(field, command, 200, x, velocity);
        CHECK(field.elastic().now_W.norm() == 0.0);
        CHECK(field.elastic().held_W.norm() == 0.0);
    }
    FieldStage liquid(make_liquid());
    CHECK(liquid.step({}, Vector3::Zero(), Vector3(1, 0, 0), kDt_s).x() < 0.0);
    CHECK(liquid.elastic().now_W.norm() == 0.0);
    CHECK(liquid.elastic().held_W.norm() == 0.0);
}

TEST_CASE("field: coefficients outside their ranges are refused, at their bounds accepted") {
    check_refused(make_spring(), {[](auto& plan) { plan.stiffness_N_per_m = -0.1; },
                                  [](auto& plan) { plan.damping_Ns_per_m = -1.0; }});
    check_refused(make_magnet(), {[](auto& plan) { plan.range_m = 0.0; },
                                  [](auto& plan) { plan.range_m = 0.002; },  // 2473 N/m inside
                                  [](auto& plan) { plan.peak_force_N = kNan; },
                                  [](auto& plan) { plan.anchor_W.y() = kInfinity; }});
    struct Bound {
        FieldKind kind;
        double FieldPlan::*number;
        double last, first_out;
    };
    for (const Bound& bound :
         {Bound{FieldKind::spring, &FieldPlan::stiffness_N_per_m, 2000.0, 2000.1},
          Bound{FieldKind::viscosity, &FieldPlan::damping_Ns_per_m, 50.0, 50.1},
          Bound{FieldKind::magnet, &FieldPlan::peak_force_N, 10.0, 10.1},
          Bound{FieldKind::magnet, &FieldPlan::range_m, 100.0, 100.1},
          Bound{FieldKind::magnet, &FieldPlan::range_m, 0.001, 0.0009}}) {
        FieldPlan plan;
        plan.kind = bound.kind;
        plan.range_m = 1.0;
        plan.*bound.number = bound.last;
        CHECK(validate(plan));
        plan.*bound.number = bound.first_out;
        CAPTURE(bound.first_out);
        CHECK_FALSE(validate(plan));
    }
    FieldPlan stiff = make_spring();
    stiff.stiffness_N_per_m = 2001.0;
    CHECK(is_refused(validate(stiff), "0 to 2000"));
    // 10 N over 8.2 mm: 2011 N/m at the centre.
    FieldPlan steep = make_magnet();
    steep.peak_force_N = 10.0;
    steep.range_m = 0.0083;
    CHECK(validate(steep));
    steep.range_m = 0.0082;
    CHECK_FALSE(validate(steep));
}
