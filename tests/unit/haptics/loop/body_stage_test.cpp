#include "haptics/loop/body_stage.h"

#include "haptics/math/rotation.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/body_stage_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

using namespace fulcrum;

namespace {

// What the world hears of the hand on either solid: it touches the first with 5 N, and grips the second with 3 N.
std::array<double, 2> touch_and_grip(double most_N) {
    HapticPlan plan = make_body_plan(2U);
    plan.rigid.push_back({0, 0.5, 2.0e-3, 0U});
    StagedBody body(plan);
    RigidFrame frame;
    frame.stamp_s = 1.0;
    frame.solids[0].is_present = frame.solids[1].is_present = true;
    body.tell(frame);
    const Pose rest[] = {Pose{}, Pose{}};
    (void)body.stage.place(rest, 1.0);
    GrippingHand hand{Pose::at({0.0, 0.1, 0.0}), {}, 2U};
    body.grip_top(hand);
    (void)body.stage.place(rest, 1.001);
    hand.pose_W.position.y() = 0.105;
    (void)body.stage.grip({}, hand);
    const HandPushes& told = body.push(5.0, 1.001, most_N, 0.1, 0);
    std::array<double, 2> forces_N{};
    for (std::int32_t i = 0; i < told.count; ++i) {
        const RigidPush& push = told.pushes[static_cast<std::size_t>(i)];
        forces_N[static_cast<std::size_t>(push.solid)] = push.hold.push_W.force.norm();
    }
    return forces_N;
}

// Gripped at its top by a hand that pulls it up by 10 mm and has turned it by 1.5 rad.
void grip_and_turn(StagedBody& body, GrippingHand& hand) {
    body.tell(1.0, Vector3::Zero(), Vector3::Zero());
    (void)body.felt(1.0);
    hand = {Pose::at({0.0, 0.1, 0.0}), {}, 2U};
    body.grip_top(hand);
    (void)body.felt(1.001);
    hand.pose_W = {Vector3(0.0, 0.11, 0.0), compute_exp(Vector3(0.0, 0.0, 1.5))};
    (void)body.stage.grip({}, hand);
}

}  // namespace

TEST_CASE("body stage: a body goes and turns on by its velocity, half as fast in half the time") {
    StagedBody body;
    CHECK(body.felt(0.0).position.x() == 9.0);
    CHECK(body.stage.age_s(0.0) == kInfinity);
    body.tell(1.0, {0.3, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0, 0.004);
    CHECK(body.felt(1.01).position.x() == Approx(0.3 + 2.0 * 0.014));
    CHECK(body.felt(1.03).position.x() == Approx(0.3 + 2.0 * 0.034));
    CHECK(body.stage.age_s(1.03) == Approx(0.03));
    // Not for ever.
    CHECK(body.felt(9.0).position.x() == Approx(0.3 + 2.0 * 0.125));
    // A frame of a time to come is as old as one of a time that long ago.
    StagedBody early;
    early.tell(11.0, Vector3::Zero(), Vector3::Zero());
    (void)early.felt(1.0);
    CHECK(early.stage.age_s(1.0) == Approx(10.0));
    body = StagedBody(make_body_plan(2U));
    RigidFrame frame;
    frame.stamp_s = 1.0;
    frame.rate = 0.5;
    frame.solids[1] = {Pose{}, {{2.0, 0.0, 0.0}, {0.0, 4.0, 0.0}}, 0.0, true, 0};
    body.tell(frame);
    const Pose felt_W = body.felt(1.02);
    CHECK(felt_W.position.x() == Approx(0.5 * 2.0 * 0.02));
    CHECK(compute_log(felt_W.orientation).y() == Approx(0.5 * 4.0 * 0.02));
    // Its grip's damper too.
    GrippingHand hand{Pose::at(felt_W.position), {}, 2U};
    (void)body.stage.grip(make_contact(felt_W.position, Vector3::UnitY(), 1), hand);
    (void)body.felt(1.02);
    CHECK((body.stage.grip({}, hand).force_W - Vector3(5.0 * 0.5 * 2.0, 0.0, 0.0)).norm() < 1.0e-9);
    for (const double rate : {-0.1, 1.1, std::nan("")}) {
        frame.stamp_s = 1.03;
        frame.rate = rate;
        body.tell(frame);
        (void)body.felt(1.03);
        CHECK(body.stage.age_s(1.03) == Approx(0.03));
    }
    body = StagedBody();
    frame = RigidFrame();
    frame.stamp_s = 1.0;
    frame.solids[1] = {Pose{}, {Vector3::Zero(), {0.0, 3.0, 0.0}}, 0.0, true, 0};
    body.tell(frame);
    const Quaternion turn = body.felt(1.05).orientation;
    CHECK(turn.angularDistance(compute_exp(Vector3(0.0, 0.15, 0.0))) < 1.0e-9);
}

TEST_CASE("body stage: what a frame corrects is felt little by little until the next is due") {
    StagedBody body;
    body.tell(1.00, Vector3::Zero(), {1.0, 0.0, 0.0});
    (void)body.felt(1.001);
    body.tell(1.02, {0.02, 0.0, 0.0}, {1.0, 0.0, 0.0});
    (void)body.felt(1.021);
    // It has stopped meanwhile: what was foretold is 0.06, what is told 0.04.
    body.tell(1.06, {0.04, 0.0, 0.0}, Vector3::Zero());
    double before_m = body.felt(1.06).position.x();
    CHECK(before_m == Approx(0.06).margin(0.6e-3));
    for (int i = 1; i <= 40; ++i) {
        const double now_m = body.felt(1.06 + 1.0e-3 * i).position.x();
        CHECK(std::abs(now_m - before_m) < 0.6e-3);
        before_m = now_m;
    }
    CHECK(before_m == Approx(0.04));
}

TEST_CASE("body stage: what a pause has to correct is not hurried by the frames after it") {
    StagedBody body;
    double now_s = 1.0;
    double before_m = 0.0;
    double fastest_m = 0.0;
    const auto feel = [&] {
        const double x = body.felt(now_s).position.x();
        fastest_m = std::max(fastest_m, std::abs(x - before_m));
        before_m = x;
        now_s += 1.0e-3;
    };
    // At 1 m/s, told each millisecond; then 50 ms of silence, in which it has stopped where it was.
    for (int i = 0; i < 200; ++i) {
        body.tell(now_s, {now_s - 1.0, 0.0, 0.0}, Vector3::UnitX());
        feel();
    }
    const double stopped_m = before_m;
    for (int i = 0; i < 50; ++i) {
        feel();
    }
    for (int i = 0; i < 60; ++i) {
        body.tell(now_s, {stopped_m, 0.0, 0.0}, Vector3::Zero());
        feel();
    }
    CHECK(fastest_m < 1.2e-3);
    CHECK(before_m == Approx(stopped_m).margin(1.0e-9));
    // Nor by a clock that goes back.
    body.tell(now_s - 0.5, {stopped_m + 0.03, 0.0, 0.0}, Vector3::Zero());
    feel();
    CHECK(fastest_m < 1.2e-3);
}

TEST_CASE("body stage: what was put elsewhere is there at once, and the proxy is told") {
    StagedBody body;
    body.tell(1.00, Vector3::Zero(), Vector3::Zero());
    (void)body.felt(1.0);
    CHECK(body.stage.put() == 2U);
    (void)body.felt(1.001);
    CHECK(body.stage.put() == 0U);
    body.tell(1.02, {0.5, 0.0, 0.0}, Vector3::Zero(), 1);
    CHECK(body.felt(1.02).position.x() == 0.5);
    CHECK(body.stage.put() == 2U);
    RigidFrame gone = body.channels->frame.value();
    gone.solids[1].is_present = false;
    body.tell(gone);
    CHECK(body.felt(1.03).position.y() < -1.0e3);
    CHECK(body.stage.put() == 2U);
}

TEST_CASE("body stage: a frame with what is no number in it is passed over") {
    StagedBody body;
    body.tell(1.0, {0.1, 0.0, 0.0}, Vector3::Zero());
    (void)body.felt(1.0);
    body.tell(1.1, Vector3::Constant(std::nan("")), Vector3::Zero());
    CHECK(body.felt(1.1).position.x() == 0.1);
    CHECK(body.stage.age_s(1.1) == Approx(0.1));
    for (const double bad_s : {std::nan(""), kInfinity, -0.01}) {
        body.tell(bad_s, Vector3::Zero(), Vector3::Zero());
        CHECK(body.felt(1.1).position.x() == 0.1);
        body.tell(1.1, Vector3::Zero(), Vector3::Zero(), 0, bad_s);
        CHECK(body.felt(1.1).position.x() == 0.1);
    }
    RigidFrame garbled;
    garbled.stamp_s = 1.1;
    garbled.solids[1].is_present = true;
    garbled.solids[1].pose_W.orientation = Quaternion(0.9, 0.0, 0.0, 0.0);
    body.tell(garbled);
    CHECK(body.felt(1.1).position.x() == 0.1);
    CHECK(body.stage.age_s(1.1) == Approx(0.1));
}

TEST_CASE("body stage: the world hears of a push with its place and its slopes, cut off with it") {
    StagedBody body;
    body.tell(1.0, Vector3::Zero(), Vector3::Zero());
    (void)body.felt(1.0);
    const HandPushes& told = body.push(8.0, 1.0);
    REQUIRE(told.count == 1);
    CHECK(told.stamp_s == 1.0);
    const RigidPush& push = told.pushes[0];
    CHECK(push.solid == 1);
    CHECK((push.hold.push_W.force - Vector3(-4.0, 0.0, 0.0)).norm() < kRounding);
    CHECK(push.hold.at_W.x() == Approx(0.1));
    CHECK(push.hold.slopes.stiffness_N_per_m == Approx(300.0));
    CHECK(push.hold.slopes.damping_Ns_per_m == Approx(2.5));
    CHECK(push.hold.slopes.late_mass_kg == Approx(0.5 * 0.008 * 5.0));
    // It pushes where it touches, and no further than the hand may feel.
    CHECK((push.hold.bounds.along_W + Vector3::UnitX()).norm() < kRounding);
    CHECK(push.hold.bounds.most_N == Approx(4.0));
    CHECK(push.hold.bounds.friction_N == 0.0);
    // What is no rigid body is not the world's.
    CHECK(body.push(8.0, 1.001, 4.0, 0.1, 0).count == 0);
}

TEST_CASE("body stage: the world hears how the hand took a body to be when it pushed it") {
    StagedBody body;
    body.tell(1.0, {0.2, 0.0, 0.0}, {0.5, 0.0, 0.0}, 3);
    const Pose felt_W = body.felt(1.02);
    const HandPushes& told = body.push(2.0, 1.02, 4.0, 0.3);
    REQUIRE(told.count == 1);
    CHECK(told.pushes[0].pose_W.position.x() == felt_W.position.x());
    CHECK(told.pushes[0].velocity_W.linear.x() == 0.5);
    CHECK(told.pushes[0].n_placements == 3);
}

TEST_CASE("body stage: friction holds by as much as it may; touch and grip together no more") {
    HapticPlan plan = make_body_plan();
    plan.solids[1].friction = {0.5, 0.4, 0.0};
    StagedBody body(plan);
    body.tell(1.0, Vector3::Zero(), Vector3::Zero());
    (void)body.felt(1.0);
    CHECK(body.push(3.0, 1.0).pushes[0].hold.bounds.friction_N == Approx(0.5 * 3.0));
    CHECK(touch_and_grip(9.0)[0] == Approx(5.0));
    CHECK(touch_and_grip(9.0)[1] == Approx(3.0));
    CHECK(touch_and_grip(4.0)[0] == Approx(2.5));
    CHECK(touch_and_grip(4.0)[1] == Approx(1.5));
}

TEST_CASE("body stage: a grip holds the place that was touched, as long as the button is down") {
    StagedBody body(make_body_plan(2U));
    body.tell(1.0, Vector3::Zero(), Vector3::Zero());
    (void)body.felt(1.0);
    const ProxyContact touch = make_contact({0.0, 0.1, 0.0}, Vector3::UnitY(), 1);
    GrippingHand hand{Pose::at({0.0, 0.099, 0.0}), {}, 1U};
    // Another button grips nothing; in the round in which it is pressed the touch is still felt.
    CHECK(body.stage.grip(touch, hand).force_W.norm() == 0.0);
    CHECK(body.stage.gripped() == kNoBody);
    hand.buttons = 3U;
    CHECK(body.stage.grip(touch, hand).force_W.norm() == 0.0);
    CHECK(body.stage.gripped() == 1);
    (void)body.felt(1.001);
    CHECK(body.stage.put() == 2U);
    // It goes on with the force of the touch, and pulls as well as pushes.
    CHECK((body.stage.grip({}, hand).force_W - Vector3(0.0, 0.6, 0.0)).norm() < kRounding);
    hand.pose_W.position.y() = 0.11;
    hand.twist_W.linear = {0.1, 0.0, 0.0};
    const GripForce pull = body.stage.grip({}, hand);
    CHECK((pull.spring_W - Vector3(0.0, -6.0, 0.0)).norm() < kRounding);
    CHECK((pull.force_W - Vector3(-0.5, -6.0, 0.0)).norm() < kRounding);
    // The body is turned with the hand: k_r = k I / m.
    hand.twist_W = {};
    hand.pose_W.orientation = compute_exp(Vector3(0.0, 0.0, 0.01));
    (void)body.stage.grip({}, hand);
    const HandPushes& told = body.push_nothing(4.0);
    REQUIRE(told.count == 1);
    CHECK(told.pushes[0].hold.bounds.along_W.norm() == 0.0);
    CHECK(told.pushes[0].hold.push_W.force.y() == Approx(4.0));
    CHECK(told.pushes[0].hold.push_W.torque.z() ==
          Approx(4.0 / 6.0 * 600.0 * 2.0e-3 / 0.5 * 0.01).epsilon(1.0e-6));
    hand.buttons = 0U;
    CHECK(body.stage.grip({}, hand).force_W.norm() == 0.0);
    CHECK(body.stage.gripped() == kNoBody);
}

TEST_CASE("body stage: a grip turns with no more than the hand may feel at the body's arm") {
    // 6 N, and 600 * 2e-3 / 0.5 * 1.5 = 3.6 Nm; r = sqrt(2e-3 / 0.5).
    const double arm_m = std::sqrt(2.0e-3 / 0.5);
    for (const double most_N : {9.0, 3.0, 0.0}) {
        StagedBody body(make_body_plan(2U));
        GrippingHand hand;
        grip_and_turn(body, hand);
        const HandPushes& told = body.push_nothing(most_N);
        REQUIRE(told.count == 1);
        const RigidPush& push = told.pushes[0];
        INFO("at most " << most_N);
        CHECK(push.hold.push_W.force.y() == Approx(std::min(6.0, most_N)).margin(kRounding));
        CHECK(push.hold.push_W.torque.z() == Approx(most_N * arm_m).margin(kRounding));
        // Cut off, it has its secant's slopes.
        CHECK(push.hold.slopes.stiffness_N_per_m ==
              Approx(600.0 * std::min(1.0, most_N / 6.0)).margin(kRounding));
        CHECK(push.hold.slopes.turn_stiffness_Nm_per_rad ==
              Approx(most_N * arm_m / 1.5).margin(kRounding));
    }
}

TEST_CASE("body stage: a grip ends where its body is put elsewhere or taken out, or it is let go") {
    for (const int how : {0, 1, 2}) {
        StagedBody body(make_body_plan(2U));
        GrippingHand hand;
        grip_and_turn(body, hand);
        REQUIRE(body.stage.gripped() == 1);
        if (how == 0) {
            body.tell(1.002, {0.1, 0.0, 0.0}, Vector3::Zero(), 1);
        } else if (how == 1) {
            body.stage.let_go();
        } else {
            RigidFrame gone;
            gone.stamp_s = 1.002;
            body.tell(gone);
        }
        (void)body.felt(1.002);
        CHECK(body.stage.gripped() == kNoBody);
        CHECK(body.stage.grip({}, hand).force_W.norm() == 0.0);
        CHECK(body.push_nothing(9.0).count == 0);
    }
}

TEST_CASE("body stage: a plan with rigid bodies that cannot be is refused") {
    const auto refuses = [](auto spoil) {
        HapticPlan plan = make_body_plan();
        spoil(plan);
        return !validate_rigid(plan).has_value();
    };
    CHECK(validate_rigid(make_body_plan()));
    CHECK(refuses([](HapticPlan& plan) { plan.rigid[0].solid = 2; }));
    CHECK(refuses([](HapticPlan& plan) { plan.rigid.push_back(plan.rigid[0]); }));
    CHECK(refuses([](HapticPlan& plan) { plan.rigid[0].mass_kg = 0.0; }));
    CHECK(refuses([](HapticPlan& plan) { plan.rigid[0].moment_kg_m2 = std::nan(""); }));
    CHECK(refuses([](HapticPlan& plan) { plan.axles.push_back({.solid = 1}); }));
    CHECK(make_body_stage(HapticPlan{}, nullptr) == nullptr);
    CHECK(make_body_stage(make_body_plan(), nullptr)->memory_bytes() > 0);
}
