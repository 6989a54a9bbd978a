// Reliefs through the tool's stage and the loop.
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
        REQUIRE(now.texture_force.now_W == now.texture_W.force);
        given_J += before.texture_W.force.dot(moved_W);
        counted_J += 0.5 * (before.texture_force.now_W + now.texture_force.held_W).dot(moved_W);
        ideal_J = std::max(ideal_J, counted_J);
        most_J = std::max(most_J, kToolStiffness_N_per_m * 0.005 * kGain * kHeight_m);
        before = now;
    }
    CAPTURE(given_J, ideal_J, most_J);
    // One way round it gives, the other it takes.
    CHECK(way * given_J > 3.0 * most_J);
    CHECK(ideal_J < 2.5 * most_J);
}
