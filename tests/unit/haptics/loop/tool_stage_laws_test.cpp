// What the stage tells of a tool's contact, and how it takes solids that are told to be elsewhere now and then.
#include "haptics/loop/tool_stage.h"
#include "tests/support/tool_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <span>

using namespace fulcrum;

namespace {

constexpr double kDt_s = 0.001;
constexpr double kStiffness = 500.0;
constexpr double kHalf_m = 0.02;
constexpr double kDepth_m = 0.004;

// A box whose top is at height 0, and a cube of 4 cm.
HapticPlan make_floor(ToolMethod method) {
    HapticPlan plan;
    plan.solids.push_back({.body = 0,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0, -0.02, 0))});
    test::ToolScene scene{.tool = make_box(Vector3::Constant(2.0 * kHalf_m)).value(),
                          .inertia = make_box_inertia(0.05, Vector3::Constant(2.0 * kHalf_m)),
                          .method = method};
    scene.settings.coupling.shift.stiffness_N_per_m = kStiffness;
    plan.tool = test::make_tool_of(scene, {make_box({0.2, 0.04, 0.2}).value()});
    return plan;
}

struct Led {
    std::unique_ptr<ToolStage> stage;
    double now_s = 0.0;

    explicit Led(const HapticPlan& plan) : stage(make_tool_stage(plan)) {}
    ToolForce step(double hand_m, double top_m) {
        now_s += kDt_s;
        const Pose solid[] = {Pose::at(Vector3(0.0, top_m - 0.02, 0.0))};
        return stage->step({.hand = {Pose::at(Vector3(0.0, hand_m, 0.0)), {}},
                            .solid_poses_W = solid,
                            .now_s = now_s,
                            .dt_s = kDt_s});
    }
    // From above, down to where the cube is pressed so deep.
    ToolForce press(double depth_m) {
        ToolForce felt;
        for (int i = 0; i <= 400; ++i) {
            felt = step(kHalf_m + 0.01 - (0.01 + depth_m) * std::min(1.0, i / 200.0), 0.0);
        }
        return felt;
    }
};

}  // namespace

TEST_CASE("tool stage: what is told of a contact is its spring: push, direction and energy") {
    const HapticPlan plan = make_floor(ToolMethod::god_object);
    Led led(plan);
    const ToolForce felt = led.press(kDepth_m);
    const double push_N = kStiffness * kDepth_m;
    CHECK(felt.wrench_W.force.y() == Approx(push_N).epsilon(1.0e-3));
    CHECK(felt.contact.push == Approx(push_N).epsilon(1.0e-3));
    CHECK((felt.contact.normal - Vector3::UnitY()).norm() < 1.0e-6);
    CHECK(felt.contact.force.y() == Approx(push_N).epsilon(1.0e-3));
    CHECK(felt.contact.energy_J == Approx(0.5 * push_N * kDepth_m).epsilon(2.0e-3));
    // The floor takes what the hand feels, and the cube's middle is over its own.
    CHECK(led.stage->pushes()[0].force_W.y() == Approx(-push_N).epsilon(1.0e-3));
    CHECK(led.stage->solid() == 0);
}

TEST_CASE(
    "tool stage: a solid that is told of now and then presses as hard as one told of always") {
    // The floor rises at 5 cm/s under a hand that stands; every 20th round it is told of.
    constexpr double kSpeed_m_per_s = 0.05;
    constexpr int kEvery = 20;
    const auto method = GENERATE(ToolMethod::field_sampling, ToolMethod::implicit_penalty);
    const HapticPlan plan = make_floor(method);
    Led often(plan);
    Led seldom(plan);
    (void)often.press(0.002);
    (void)seldom.press(0.002);
    double most_often_N = 0.0;
    double most_seldom_N = 0.0;
    for (int i = 1; i <= 200; ++i) {
        const double hand_m = kHalf_m - 0.002;
        const int told = i / kEvery * kEvery;
        most_often_N = std::max(most_often_N,
                                often.step(hand_m, kSpeed_m_per_s * kDt_s * i).wrench_W.force.y());
        most_seldom_N = std::max(
            most_seldom_N, seldom.step(hand_m, kSpeed_m_per_s * kDt_s * told).wrench_W.force.y());
    }
    CAPTURE(most_often_N, most_seldom_N);
    CHECK(most_often_N > 2.0);
    CHECK(most_seldom_N < 1.1 * most_often_N);
    CHECK(most_seldom_N > 0.9 * most_often_N);
}

TEST_CASE("tool stage: a solid that is told to move no more stands still") {
    constexpr double kSpeed_m_per_s = 0.05;
    const HapticPlan plan = make_floor(ToolMethod::implicit_penalty);
    Led moved(plan);
    Led stood(plan);
    (void)moved.press(0.002);
    (void)stood.press(0.002);
    double top_m = 0.0;
    for (int i = 0; i < 60; ++i) {
        top_m = kSpeed_m_per_s * kDt_s * i;
        (void)moved.step(kHalf_m - 0.002, top_m);
    }
    ToolForce after;
    ToolForce always;
    for (int i = 0; i < 500; ++i) {
        after = moved.step(kHalf_m - 0.002 + top_m, top_m);
        always = stood.step(kHalf_m - 0.002, 0.0);
    }
    CHECK(after.wrench_W.force.y() == Approx(always.wrench_W.force.y()).epsilon(1.0e-3));
    CHECK(always.wrench_W.force.y() > 0.5);
}
