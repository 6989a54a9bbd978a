#include "haptics/dynamics/joint.h"

#include "haptics/math/rotation.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

constexpr JointKind kKinds[] = {JointKind::ball, JointKind::hinge, JointKind::slider,
                                JointKind::fixed, JointKind::distance};

JointPlan make_plan(JointKind kind, Random& random) {
    return {.kind = kind,
            .body_a = 0,
            .body_b = 1,
            .anchor_W = random.in_cube(),
            .other_anchor_W = random.in_cube(),
            .axis_W = random.direction()};
}

Pose moved(const Pose& pose, const Vector6& velocity, double dt_s) {
    return {pose.position + dt_s * velocity.head<3>(),
            compute_exp(dt_s * velocity.tail<3>()) * pose.orientation};
}

Vector6 velocity_by_chance(Random& random) {
    Vector6 velocity;
    velocity << random.in_cube(), random.in_cube();
    return velocity;
}

TEST_CASE("joint: errors grow as the rows say, on the joint's place and a little off it") {
    Random random(1);
    constexpr double kStep_s = 1.0e-6;
    for (const JointKind kind : kKinds) {
        for (int i = 0; i < 40; ++i) {
            const Pose a{random.in_cube(), random.turn(3.0)};
            const Pose b{random.in_cube(), random.turn(3.0)};
            const Joint joint = make_joint(make_plan(kind, random), a, b);
            const Vector6 v_a = velocity_by_chance(random);
            const Vector6 v_b = velocity_by_chance(random);
            JointRows before;
            JointRows after;
            make_joint_rows(joint, a, b, 0.001, before);
            make_joint_rows(joint, moved(a, v_a, kStep_s), moved(b, v_b, kStep_s), 0.001, after);
            REQUIRE(before.count == joint.n_rows);
            for (int r = 0; r < before.count; ++r) {
                const auto row = static_cast<std::size_t>(r);
                REQUIRE(std::abs(before.errors[row]) < 1.0e-12);
                const double rate =
                    before.rows[row].jacobian_a.dot(v_a) + before.rows[row].jacobian_b.dot(v_b);
                REQUIRE(after.errors[row] / kStep_s == Approx(rate).margin(2.0e-5));
            }
        }
    }
}

TEST_CASE(
    "joint: a slider that is far out turns with its rail: its rows say how errors and travel "
    "grow") {
    Random random(5);
    constexpr double kStep_s = 1.0e-6;
    for (int i = 0; i < 40; ++i) {
        const Pose a{random.in_cube(), random.turn(3.0)};
        const Pose start{random.in_cube(), random.turn(3.0)};
        JointPlan plan = make_plan(JointKind::slider, random);
        plan.drive.motor_force = 1.0;
        const Joint joint = make_joint(plan, a, start);
        const Pose b{start.position + 0.8 * plan.axis_W.normalized(), start.orientation};
        CHECK(compute_joint_travel(joint, a, b) == Approx(0.8));
        const Vector6 v_a = velocity_by_chance(random);
        const Vector6 v_b = velocity_by_chance(random);
        JointRows before;
        JointRows after;
        make_joint_rows(joint, a, b, 0.001, before);
        const Pose later_a = moved(a, v_a, kStep_s);
        const Pose later_b = moved(b, v_b, kStep_s);
        make_joint_rows(joint, later_a, later_b, 0.001, after);
        REQUIRE(before.count == 6);
        for (std::size_t row = 0; row < 6; ++row) {
            const double rate =
                before.rows[row].jacobian_a.dot(v_a) + before.rows[row].jacobian_b.dot(v_b);
            const double grown = row == 5 ? compute_joint_travel(joint, later_a, later_b) - 0.8
                                          : after.errors[row] - before.errors[row];
            REQUIRE(grown / kStep_s == Approx(rate).margin(2.0e-5));
        }
    }
}

TEST_CASE("joint: as many rows as it takes degrees of freedom") {
    Random random(2);
    const int taken[] = {3, 5, 5, 6, 1};
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(make_joint(make_plan(kKinds[i], random), Pose{}, Pose{}).n_rows == taken[i]);
    }
}

TEST_CASE("joint: travel is the angle of a hinge and the way of a slider, from where they were") {
    JointPlan plan{
        .body_a = -1, .body_b = 0, .anchor_W = {1.0, 0.0, 0.0}, .axis_W = {0.0, 0.0, 2.0}};
    plan.kind = JointKind::hinge;
    const Pose start{{0.5, 0.2, 0.0}, Quaternion(AngleAxis(0.4, Vector3::UnitX()))};
    const Joint hinge = make_joint(plan, Pose{}, start);
    CHECK(compute_joint_travel(hinge, Pose{}, start) == Approx(0.0).margin(1.0e-14));
    for (const double angle_rad : {0.3, -1.0, 3.0, -3.0}) {
        const Quaternion turn(AngleAxis(angle_rad, Vector3::UnitZ()));
        const Pose turned{plan.anchor_W + turn * (start.position - plan.anchor_W),
                          turn * start.orientation};
        CHECK(compute_joint_travel(hinge, Pose{}, turned) == Approx(angle_rad));
    }
    plan.kind = JointKind::slider;
    const Joint slider = make_joint(plan, Pose{}, start);
    CHECK(compute_joint_travel(slider, Pose{},
                               {start.position + Vector3(0.0, 0.0, 0.25), start.orientation}) ==
          Approx(0.25));
    plan.kind = JointKind::ball;
    CHECK(compute_joint_travel(make_joint(plan, Pose{}, start), Pose{}, start) == 0.0);
}

TEST_CASE(
    "joint: a limit asks for no more than the way that is left, a motor for its speed with its "
    "force") {
    JointPlan plan{.kind = JointKind::slider, .body_a = -1, .body_b = 0, .axis_W = {1.0, 0.0, 0.0}};
    plan.drive = {
        .lower = -0.1, .upper = 0.3, .motor_speed = 2.0, .motor_force = 5.0, .friction = 1.0};
    const Joint slider = make_joint(plan, Pose{}, Pose{});
    REQUIRE(slider.n_rows == 8);
    JointRows rows;
    make_joint_rows(slider, Pose{}, Pose::at({0.05, 0.0, 0.0}), 0.01, rows);
    CHECK(rows.rows[5].target == 2.0);
    CHECK(rows.rows[5].most == Approx(0.05));
    CHECK(rows.rows[6].target == Approx(-15.0));
    CHECK(rows.rows[6].least == 0.0);
    CHECK(rows.rows[7].target == Approx(25.0));
    CHECK(rows.rows[7].most == 0.0);
    make_joint_rows(slider, Pose{}, Pose::at({0.32, 0.0, 0.0}), 0.01, rows);
    CHECK(rows.rows[7].target == 0.0);
    CHECK(rows.errors[7] == Approx(0.02));
    CHECK(rows.errors[6] == 0.0);
    make_joint_rows(slider, Pose{}, Pose::at({-0.12, 0.0, 0.0}), 0.01, rows);
    CHECK(rows.errors[6] == Approx(-0.02));
}

TEST_CASE(
    "joint: what joins nothing, has no axis or no length, or drives that are none, is refused") {
    Random random(3);
    const auto is_refused = [](const JointPlan& plan) { return !validate(plan, 2, "joint 0"); };
    JointPlan plan = make_plan(JointKind::hinge, random);
    CHECK_FALSE(is_refused(plan));
    for (const auto& spoil :
         {+[](JointPlan& p) { p.body_b = 2; }, +[](JointPlan& p) { p.body_b = 0; },
          +[](JointPlan& p) { p.axis_W.setZero(); },
          +[](JointPlan& p) { p.anchor_W.x() = std::nan(""); },
          +[](JointPlan& p) { p.drive.lower = 0.1; },
          +[](JointPlan& p) { p.drive.motor_force = -1.0; },
          +[](JointPlan& p) { p.drive.friction = std::nan(""); },
          +[](JointPlan& p) {
              p.kind = JointKind::ball;
              p.drive.friction = 1.0;
          },
          +[](JointPlan& p) {
              p.kind = JointKind::distance;
              p.other_anchor_W = p.anchor_W;
          }}) {
        JointPlan spoilt = plan;
        spoil(spoilt);
        CHECK(is_refused(spoilt));
    }
}

}  // namespace
}  // namespace fulcrum
