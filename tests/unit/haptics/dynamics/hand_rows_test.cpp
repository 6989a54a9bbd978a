#include "haptics/dynamics/hand_rows.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace fulcrum {
namespace {

constexpr double kRowStep_s = 0.01;
const Inertia kRowInertia{0.2, {1.0e-4, 2.0e-4, 3.0e-4}};

BodyHold make_row_hold() {
    BodyHold hold{.at_W = {0.03, 0.0, 0.0}, .push_W = {{2.0, 1.0, 0.0}, {0.0, 0.0, 0.05}}};
    hold.slopes = {600.0, 5.0, 0.5, 0.01, 0.04};
    hold.bounds = {.along_W = Vector3::UnitX(), .friction_N = 0.7, .most_N = 3.0, .most_Nm = 0.2};
    return hold;
}

TEST_CASE("hand rows: a push answers with its spring and its damper, each with its share") {
    RigidState state;
    state.velocity_W.linear = {-0.1, 0.0, 0.0};
    const HandRows rows = make_hand_rows(make_row_hold(), kRowInertia, state, kRowStep_s);
    REQUIRE(rows.count == 7);
    const double spring_kg = kRowStep_s * kRowStep_s * 600.0;
    const double damper_kg = kRowStep_s * 5.0 + 0.04;
    const double share = spring_kg / (spring_kg + damper_kg);
    // The body comes on: the spring is shorter by h u at the end of the step.
    const double force_N = 2.0 + kRowStep_s * 600.0 * 0.1;
    const RowConstraint& spring = rows.rows[0];
    CHECK(spring.softness == Approx(1.0 / spring_kg));
    CHECK(spring.target == Approx(-0.1 + kRowStep_s * share * force_N / spring_kg));
    CHECK(spring.least == 0.0);
    CHECK(spring.most == Approx(kRowStep_s * share * 3.0));
    const RowConstraint& damper = rows.rows[1];
    CHECK(damper.softness == Approx(1.0 / damper_kg));
    CHECK(damper.target == Approx(-0.1 + kRowStep_s * (1.0 - share) * force_N / damper_kg));
    CHECK(damper.most == Approx(kRowStep_s * (1.0 - share) * 3.0));
    CHECK(rows.balls[1].n_along == 2);
    CHECK(rows.balls[1].most == Approx(kRowStep_s * 3.0));
}

TEST_CASE("hand rows: a push without force has its spring alone") {
    BodyHold hold = make_row_hold();
    hold.push_W.force.setZero();
    hold.bounds.friction_N = 0.0;
    const HandRows rows = make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s);
    REQUIRE(rows.count == 4);
    CHECK(rows.rows[0].softness == Approx(1.0 / (kRowStep_s * kRowStep_s * 600.0)));
    CHECK(rows.rows[0].target == 0.0);
    // One that goes away before it is none either.
    RigidState state;
    state.velocity_W.linear.x() = 0.5;
    const HandRows left = make_hand_rows(hold, kRowInertia, state, kRowStep_s);
    CHECK(left.rows[0].target == Approx(0.5));
}

TEST_CASE("hand rows: across it holds what friction bears, and turns no more than it may") {
    const HandRows rows = make_hand_rows(make_row_hold(), kRowInertia, RigidState{}, kRowStep_s);
    CHECK(rows.rows[2].most == Approx(kRowStep_s * 0.7));
    CHECK(rows.rows[2].least == Approx(-kRowStep_s * 0.7));
    CHECK(rows.balls[0].first == 2);
    CHECK(rows.balls[0].count == 2);
    CHECK(rows.balls[0].most == Approx(kRowStep_s * 0.7));
    CHECK(rows.rows[6].most == Approx(kRowStep_s * 0.2));
    CHECK(rows.rows[6].softness == Approx(1.0 / (kRowStep_s * (kRowStep_s * 0.5 + 0.01))));
    CHECK(rows.rows[6].impulse == Approx(kRowStep_s * 0.05));
}

TEST_CASE("hand rows: what pulls beyond its bounds counts as the nearest within, by its length") {
    BodyHold hold = make_row_hold();
    hold.bounds.along_W.setZero();
    hold.push_W.force = {20.0, -40.0, 40.0};
    hold.push_W.torque = {3.0, 4.0, 0.0};
    const HandRows rows = make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s);
    CHECK(rows.rows[0].impulse == Approx(kRowStep_s * 1.0));
    CHECK(rows.rows[1].impulse == Approx(-kRowStep_s * 2.0));
    CHECK(rows.rows[2].impulse == Approx(kRowStep_s * 2.0));
    CHECK(rows.rows[3].impulse == Approx(kRowStep_s * 0.12));
    CHECK(rows.rows[4].impulse == Approx(kRowStep_s * 0.16));
}

TEST_CASE("hand rows: a hand that stands gives less as its body goes on, where it holds it then") {
    BodyHold hold = make_row_hold();
    RigidState after;
    after.pose_W = {{0.001, 0.0, 0.0}, Quaternion(AngleAxis(0.5 * M_PI, Vector3::UnitZ()))};
    after.velocity_W = {{0.0, 0.2, 0.0}, {0.0, 0.0, 3.0}};
    carry_hold(RigidState{}, after, hold);
    CHECK((hold.at_W - Vector3(0.001, 0.03, 0.0)).norm() < 1.0e-15);
    // k (-0.029, 0.03) and b (0, 0.2) + b w x (0, 0.03) = b (-0.09, 0.2).
    CHECK(hold.push_W.force.x() == Approx(2.0 + 600.0 * 0.029 + 5.0 * 0.09));
    CHECK(hold.push_W.force.y() == Approx(1.0 - 600.0 * 0.03 - 5.0 * 0.2));
    CHECK(hold.push_W.torque.z() == Approx(0.05 - 0.5 * 0.5 * M_PI - 0.01 * 3.0));
}

TEST_CASE("hand rows: a grip holds every way, and what is not bounded above nothing has no row") {
    BodyHold hold = make_row_hold();
    hold.bounds.along_W.setZero();
    HandRows rows = make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s);
    REQUIRE(rows.count == 6);
    CHECK(rows.rows[0].least == Approx(-kRowStep_s * 3.0));
    CHECK(rows.rows[2].least == Approx(-kRowStep_s * 3.0));
    CHECK(rows.rows[3].most == Approx(kRowStep_s * 0.2));
    hold.bounds.most_N = 0.0;
    hold.bounds.most_Nm = 0.0;
    CHECK(make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s).count == 0);
}

TEST_CASE("hand rows: without slopes a force is given as it is, no further than its bound") {
    BodyHold hold = make_row_hold();
    hold.slopes = {};
    hold.push_W.force.x() = 5.0;
    const HandRows rows = make_hand_rows(hold, kRowInertia, RigidState{}, kRowStep_s);
    REQUIRE(rows.count == 6);
    // 5 N along and 0.7 N across, cut to 3 N together.
    const double length_N = std::hypot(5.0, 0.7);
    CHECK(rows.rows[0].least == Approx(kRowStep_s * 3.0 * 5.0 / length_N));
    CHECK(rows.rows[0].most == rows.rows[0].least);
    CHECK(rows.rows[0].softness == 0.0);
    CHECK(std::hypot(rows.rows[1].impulse, rows.rows[2].impulse) ==
          Approx(kRowStep_s * 3.0 * 0.7 / length_N));
}

}  // namespace
}  // namespace fulcrum
