// What a hand holds all the time.
#include "haptics/math/rotation.h"
#include "haptics/tool/tool_plan.h"
#include "tests/unit/haptics/loop/body_stage_fixture.h"

using namespace fulcrum;

namespace {

// A bucket behind the two solids, held all the time.
HapticPlan make_held_plan() {
    HapticPlan plan = make_body_plan();
    plan.rigid = {{.solid = 2, .mass_kg = 0.1, .moment_kg_m2 = 1.0e-3, .is_held = true}};
    return plan;
}

RigidFrame tell_held(double stamp_s, const Pose& held_W, std::uint32_t n_placements) {
    RigidFrame frame;
    frame.stamp_s = stamp_s;
    frame.solids[2] = {held_W, {}, 0.0, true, n_placements};
    return frame;
}

TEST_CASE("body stage: what is held all the time is put to the hand, then pulled by its origin") {
    StagedBody body(make_held_plan());
    const Quaternion turned = compute_exp(Vector3(0.0, 0.0, 0.3));
    const GrippingHand hand{{Vector3(0.2, 0.1, 0.0), turned}};
    // The hand's motion begins: until the world has put it there nothing is felt of it.
    body.tell(tell_held(1.0, Pose{}, 0));
    (void)body.felt(1.0);
    body.stage.let_go();
    CHECK(body.stage.grip({}, hand).force_W.norm() == 0.0);
    CHECK(body.stage.held_pose_W() == nullptr);
    const HandPushes put = body.push_nothing(4.0, 1.0);
    REQUIRE(put.count == 1);
    CHECK(put.pushes[0].puts);
    CHECK(put.pushes[0].solid == 2);
    CHECK((put.pushes[0].pose_W.position - hand.pose_W.position).norm() == 0.0);
    // There it hangs 5 mm below the hand.
    const Pose hangs{hand.pose_W.position - Vector3(0.0, 0.005, 0.0), turned};
    body.tell(tell_held(1.001, hangs, 1));
    (void)body.felt(1.001);
    CHECK(body.stage.put() == 3U);  // the hand touches nothing
    const GripForce felt = body.stage.grip({}, hand);
    CHECK(felt.force_W.y() == Approx(-600.0 * 0.005));
    CHECK(body.stage.gripped() == kNoBody);
    REQUIRE(body.stage.held_pose_W() != nullptr);
    CHECK(body.stage.held_pose_W()->position.y() == Approx(0.095));
    const HandPushes held = body.push_nothing(4.0, 1.001);
    REQUIRE(held.count == 1);
    CHECK_FALSE(held.pushes[0].puts);
    CHECK(held.pushes[0].hold.push_W.force.y() == Approx(3.0));
    CHECK(held.pushes[0].hold.push_W.torque.norm() < 1.0e-9);
}

TEST_CASE("body stage: a shut gate holds a bucket on, and the hand feels nothing of it") {
    StagedBody body(make_held_plan());
    body.tell(tell_held(1.0, Pose{}, 0));
    (void)body.felt(1.0);
    GrippingHand hand{Pose::at({0.0, 0.02, 0.0}), {}, 0U, false};
    CHECK(body.stage.grip({}, hand).force_W.norm() == 0.0);
    // With as much as the hand may ever feel: what the gate lets through in this round is nothing.
    const HandPushes held = body.push_nothing(0.0, 1.0);
    REQUIRE(held.count == 1);
    CHECK(held.pushes[0].hold.push_W.force.y() == Approx(SafetySettings{}.max_force_N));
    CHECK(held.pushes[0].hold.bounds.most_N == Approx(SafetySettings{}.max_force_N));
}

TEST_CASE("body stage: what cannot be held all the time is refused") {
    const auto refuses = [](auto spoil) {
        HapticPlan plan = make_held_plan();
        spoil(plan);
        return !validate_rigid(plan).has_value();
    };
    CHECK(validate_rigid(make_held_plan()));
    CHECK(refuses([](HapticPlan& plan) { plan.rigid[0].solid = 1; }));
    CHECK(refuses([](HapticPlan& plan) { plan.rigid[0].solid = 3; }));
    CHECK(refuses([](HapticPlan& plan) {
        plan.solids.resize(kMaxSolids);
        plan.rigid[0].solid = kMaxSolids;
    }));
    CHECK(refuses([](HapticPlan& plan) { plan.tool = std::make_shared<const ToolPlan>(); }));
}

}  // namespace
