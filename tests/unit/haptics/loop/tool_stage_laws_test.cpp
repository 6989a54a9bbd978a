#include "haptics/surface/energy_loan.h"
#include "haptics/tool/tool_plan.h"
#include "tests/unit/haptics/loop/tool_stage_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kStiffness = 500.0;
constexpr double kHalf_m = 0.02;
constexpr double kDepth_m = 0.004;
constexpr double kSpeed_m_per_s = 0.05;

// A cube of 4 cm over the floor.
struct Led : LedStage {
    explicit Led(ToolMethod method)
        : LedStage(
              make_tool_floor({.tool = make_box(Vector3::Constant(2.0 * kHalf_m)).value(),
                               .inertia = make_box_inertia(0.05, Vector3::Constant(2.0 * kHalf_m)),
                               .method = method},
                              1.0, kStiffness)) {}
    ToolForce step(double hand_m, double top_m) {
        solids_W[0] = Pose::at(Vector3(0.0, top_m - 0.02, 0.0));
        return LedStage::step(Vector3(0.0, hand_m, 0.0));
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

constexpr double kWave_m = 0.004;
constexpr double kHeight_m = 2.0e-4;
constexpr double kGain = 3.0;
constexpr double kSlope = kGain * std::numbers::pi * kHeight_m / kWave_m;  // as felt, at most

// A box of 20 x 4 x 20 cm whose top is at height 0, and a ball of 2 cm; with grooves, or smooth.
HapticPlan make_floor(bool is_rough, double scale = 1.0) {
    HapticPlan plan = make_tool_floor(make_ball_tool(ToolMethod::god_object), scale);
    ToolPlan tool = *plan.tool;
    if (is_rough) {
        std::get<std::vector<GodObjectPlan>>(tool.objects)[0].texture =
            std::make_shared<const Texture>(
                TextureSettings{SineTexture{kWave_m, 0.0}, TextureLaw::lateral, kHeight_m, kGain});
    }
    plan.tool = std::make_shared<const ToolPlan>(std::move(tool));
    return plan;
}

}  // namespace

// What the stage tells of a tool's contact, and how it takes solids that are told to be elsewhere, now and then or at once.

TEST_CASE("tool stage: what is told of a contact is its spring: push, direction and energy") {
    Led led(ToolMethod::god_object);
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

TEST_CASE("tool stage: a solid that is told of now and then presses as one told of always") {
    // The floor rises at 5 cm/s under a hand that stands; every 20th round it is told of.
    constexpr int kEvery = 20;
    const auto method = GENERATE(ToolMethod::field_sampling, ToolMethod::implicit_penalty);
    const auto most_N = [method](int every) {
        Led led(method);
        (void)led.press(0.002);
        double most = 0.0;
        for (int i = 1; i <= 200; ++i) {
            const double top_m = kSpeed_m_per_s * kDt_s * (i / every * every);
            most = std::max(most, led.step(kHalf_m - 0.002, top_m).wrench_W.force.y());
        }
        return most;
    };
    const double often_N = most_N(1);
    const double seldom_N = most_N(kEvery);
    CAPTURE(often_N, seldom_N);
    CHECK(often_N > 2.0);
    CHECK(seldom_N < 1.1 * often_N);
    CHECK(seldom_N > 0.9 * often_N);
}

TEST_CASE("tool stage: a solid that is told to move no more stands still") {
    Led moved(ToolMethod::implicit_penalty);
    Led stood(ToolMethod::implicit_penalty);
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

TEST_CASE("tool stage: a solid put elsewhere at once is felt as one that always stood there") {
    const auto method = GENERATE(ToolMethod::field_sampling, ToolMethod::voxel_sampling,
                                 ToolMethod::implicit_penalty, ToolMethod::god_object);
    const HapticPlan plan = make_tool_floor(test::make_ball_tool(method));
    const Pose here = plan.solids[0].initial_pose_W;
    const Pose gone = Pose::at(Vector3(0, -2.0e4, 0));
    LedStage put(plan);
    LedStage still(plan);
    const auto differ_at = [&](double y, const Pose& solid_W) {
        put.solids_W[0] = solid_W;
        return (put.step(Vector3(0, y, 0)).wrench_W.force -
                still.step(Vector3(0, y, 0)).wrench_W.force)
            .norm();
    };
    // Shown for a moment while the hand is in it, hidden, and shown again a second later.
    (void)differ_at(0.0, here);
    put.stage->let_go(1U);
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(differ_at(kTop_m, gone) == 0.0);
    }
    put.stage->let_go(1U);
    double most_N = 0.0;
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(differ_at(kTop_m - 0.00005 * i, here) < 1.0e-6);
        most_N = std::max(most_N, put.stage->pushes()[0].force_W.norm());
    }
    CHECK(most_N > 1.0);
}

// Reliefs through the tool's stage and the loop.

TEST_CASE("tool stage: a relief is felt beside the spring, and told as texture") {
    for (const double scale : {1.0, 2.0}) {
        ToolBench rough(make_floor(true, scale));
        ToolBench plain(make_floor(false, scale));
        std::size_t slot = 0;
        while (rough.loop.effects()[slot].effect != Effect::texture) {
            REQUIRE(++slot < rough.loop.effects().size());
        }
        CHECK(std::ranges::none_of(plain.loop.effects(), [](const EffectSlot& each) {
            return each.effect == Effect::texture;
        }));
        double most_N = 0.0;
        for (int i = 0; i < 3000; ++i) {
            const double down = std::min(1.0, 0.001 * i);
            const Pose hand = Pose::at(
                Vector3(0.02 * std::sin(0.002 * i), kTop_m + (0.014 - kTop_m) * down, 0.01) /
                scale);
            for (ToolBench* bench : {&rough, &plain}) {
                bench->device.pose_D = hand;
                bench->run(1);
            }
            const Vector3 more_W =
                rough.state().commanded_W.force - plain.state().commanded_W.force;
            REQUIRE(rough.state().proxy_position_W == plain.state().proxy_position_W);
            if (i > 1500) {
                most_N = std::max(most_N, std::abs(more_W.x()));
                // The floor pushes up as it did.
                REQUIRE(std::abs(more_W.y()) < 0.05);
            }
            // Over it, nothing.
            REQUIRE((plain.state().commanded_W.force.norm() > 0.0 || more_W.isZero(0.0)));
        }
        // K d gain times the slope, less what the passivity stage takes.
        const double wanted_N = kToolStiffness_N_per_m / scale * 0.006 * kSlope;
        CHECK(most_N > 0.8 * wanted_N);
        CHECK(most_N < 1.2 * wanted_N);
    }
}

TEST_CASE("tool stage: pumped by a relief that gives more than it took, only its loan is ideal") {
    const double way = GENERATE(1.0, -1.0);
    LedStage led(make_floor(true));
    REQUIRE(led.stage->has_texture());
    Vector3 hand_W(0.0, 0.03, 0.01);
    ToolForce before = led.step(hand_W);
    double given_J = 0.0;
    double ideal_J = 0.0;
    double counted_J = 0.0;
    double most_J = 0.0;
    for (int i = 0; i < 20000; ++i) {
        // Pressed downhill, lifted uphill, over half a wave of 4 mm.
        const double phase = 2.0 * std::numbers::pi * i / 400.0;
        const Vector3 next_W(0.001 * std::cos(phase), 0.017 - way * 0.002 * std::sin(phase), 0.01);
        const Vector3 moved_W = next_W - hand_W;
        hand_W = next_W;
        const ToolForce now = led.step(hand_W);
        REQUIRE((now.wrench_W.force - now.spring_W.force - now.texture_W.force).norm() < 1.0e-9);
        // The relief's alone.
        const Vector3 asked_W = now.elastic_force.now_W - now.spring_W.force;
        const Vector3 held_W = now.elastic_force.held_W - now.spring_W.force;
        REQUIRE((asked_W - now.texture_W.force).norm() < 1.0e-12);
        given_J += before.texture_W.force.dot(moved_W);
        counted_J += 0.5 * (before.texture_W.force + held_W).dot(moved_W);
        ideal_J = std::max(ideal_J, counted_J);
        most_J = std::max(most_J, kToolStiffness_N_per_m * 0.005 * kGain * kHeight_m);
        before = now;
    }
    CAPTURE(given_J, ideal_J, most_J);
    // One way round it gives, the other it takes.
    CHECK(way * given_J > 3.0 * most_J);
    // In 20 s; what fades of the debt is lent again.
    CHECK(ideal_J < (2.5 + 20.0 / kDebtMemory_s) * most_J);
}
