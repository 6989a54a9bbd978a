// What a hand holds all the time.
#include "haptics/dynamics/rigid_loop.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/tool_plan.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/haptics/loop/body_stage_fixture.h"

#include <algorithm>

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

TEST_CASE(
    "body stage: what is held is put where the hand is known to be, and as often as its motion "
    "begins anew") {
    StagedBody body(make_held_plan());
    const auto put_at = [&](const GrippingHand& hand, double now_s) {
        (void)body.felt(now_s);
        (void)body.stage.grip({}, hand);
        const HandPushes told = body.push_nothing(4.0, now_s);
        return told.count == 1 && told.pushes[0].puts ? told.pushes[0].pose_W.position.x() : -1.0;
    };
    GrippingHand hand{Pose::at({0.2, 0.0, 0.0})};
    hand.is_there = false;
    // Before the hand's place is known, and while a reading jumps, nothing is put anywhere; that the world told of it is no answer.
    CHECK(put_at(hand, 1.0) == -1.0);
    body.tell(tell_held(1.001, Pose::at({0.5, 0.0, 0.0}), 0));
    CHECK(put_at(hand, 1.001) == -1.0);
    hand.is_there = true;
    CHECK(put_at(hand, 1.002) == 0.2);
    // The hand's motion begins anew before the world has answered: its answer is to the place before.
    body.stage.let_go();
    hand.pose_W.position.x() = 0.4;
    body.tell(tell_held(1.003, Pose::at({0.2, 0.0, 0.0}), 1));
    CHECK(put_at(hand, 1.003) == 0.4);
    CHECK(body.stage.held_pose_W() == nullptr);
    body.tell(tell_held(1.004, hand.pose_W, 2));
    CHECK(put_at(hand, 1.004) == -1.0);
    CHECK(body.stage.held_pose_W() != nullptr);
}

// A bucket alone, a small box in a world without weight, and the hand in which it is; its way from the middle.
struct HeldBucket {
    static HapticPlan make_hand(const Vector3& middle_W) {
        HapticPlan plan;
        plan.workspace.pose_WD.position = middle_W;
        plan.expects_lesson = false;
        plan.solids = {{.body = 0,
                        .shape = BoxShape{{0.1, 0.1, 0.1}},
                        .initial_pose_W = Pose::at({0.0, 9.0, 0.0})}};
        plan.rigid = {{.solid = 1, .mass_kg = 0.05, .moment_kg_m2 = 1.0e-4, .is_held = true}};
        return plan;
    }
    static RigidLoopPlan make_world(const Vector3& middle_W) {
        RigidLoopPlan plan;
        plan.world.settings.gravity_W.setZero();
        plan.world.bodies = {
            {.shape = BoxShape{{0.05, 0.05, 0.05}}, .mass_kg = 0.05, .pose_W = Pose::at(middle_W)}};
        plan.scene_bodies = {kNoBody};
        plan.solids = {kNoBody, 0};
        plan.carrier = 0;
        return plan;
    }
    explicit HeldBucket(const Vector3& middle_W = Vector3::Zero()) : from_W(middle_W) {
        channels->rigid = rigid.get();
        RigidChannels* const hands[] = {rigid.get()};
        world = RigidLoop::create(make_world(middle_W), nullptr, hands).value();
        loop = std::make_unique<HapticLoop>(make_hand(middle_W), device, *channels);
    }
    [[nodiscard]] Vector3 way_W() const { return world->world().shape_pose_W(0).position - from_W; }
    // How far it was at most.
    double run(int n) {
        double most_m = 0.0;
        for (int i = 0; i < n; ++i) {
            now_s += 1.0e-3;
            loop->step(now_s);
            world->step(now_s);
            most_m = std::max(most_m, way_W().norm());
        }
        return most_m;
    }
    double now_s = 0.0;
    Vector3 from_W;
    ScriptedDevice device;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    std::unique_ptr<RigidChannels> rigid = std::make_unique<RigidChannels>();
    std::unique_ptr<RigidLoop> world;
    std::unique_ptr<HapticLoop> loop;
};

TEST_CASE("body stage: a reading that jumps and comes back leaves a bucket in the hand") {
    HeldBucket bucket;
    CHECK(bucket.run(3000) < 1.0e-9);
    bucket.device.pose_D.position.x() += 0.5;
    double most_m = bucket.run(1);
    bucket.device.pose_D.position.x() -= 0.5;
    most_m = std::max(most_m, bucket.run(3000));
    CHECK(most_m < 1.0e-9);
    // Where the hand stays there it goes along.
    bucket.device.pose_D.position.x() += 0.5;
    (void)bucket.run(5);
    CHECK(bucket.way_W().x() == Approx(0.5));
}

TEST_CASE("body stage: before the hand's place is known a bucket stays where it is") {
    HeldBucket bucket({0.3, 0.0, 0.0});
    bucket.device.gives_pose = false;
    CHECK(bucket.run(100) < 1.0e-9);
    bucket.device.gives_pose = true;
    bucket.device.pose_D.position.x() = 0.2;
    (void)bucket.run(5);
    CHECK(bucket.way_W().x() == Approx(0.2));
}

TEST_CASE("body stage: a shut gate holds a bucket on, and the hand feels nothing of it") {
    StagedBody body(make_held_plan());
    GrippingHand hand{Pose::at({0.0, 0.02, 0.0}), {}, 0U, false};
    CHECK(body.stage.grip({}, hand).force_W.norm() == 0.0);
    CHECK(body.push_nothing(0.0, 0.999).pushes[0].puts);
    body.tell(tell_held(1.0, Pose{}, 1));
    (void)body.felt(1.0);
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
