// Reliefs through the tool's stage and the loop.
#include "haptics/loop/tool_stage.h"
#include "haptics/tool/tool_plan.h"
#include "tests/support/tool_scene.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace fulcrum;
using namespace fulcrum::test;

namespace {

constexpr double kStiffness_N_per_m = 400.0;
constexpr double kTop_m = 0.05;
constexpr double kWave_m = 0.004;
constexpr double kHeight_m = 2.0e-4;
constexpr double kGain = 3.0;
constexpr double kSlope = kGain * std::numbers::pi * kHeight_m / kWave_m;  // as felt, at most

// A box of 20 x 4 x 20 cm whose top is at height 0, and a ball of 2 cm; with grooves, or smooth.
HapticPlan make_floor(bool is_rough, double scale = 1.0) {
    HapticPlan plan;
    plan.safety.soft_start_s = 0.0;
    plan.safety.max_slew_N_per_s = 5000.0;
    plan.workspace.scale = scale;
    plan.solids.push_back({.body = 3,
                           .shape = BoxShape{Vector3(0.1, 0.02, 0.1)},
                           .initial_pose_W = Pose::at(Vector3(0, -0.02, 0))});
    ToolScene scene = make_ball_tool(ToolMethod::god_object);
    scene.settings.coupling.shift.stiffness_N_per_m = kStiffness_N_per_m / scale;
    ToolPlan tool = *make_tool_of(scene, {make_box({0.2, 0.04, 0.2}).value()});
    if (is_rough) {
        std::get<std::vector<GodObjectPlan>>(tool.objects)[0].texture =
            std::make_shared<const Texture>(
                TextureSettings{SineTexture{kWave_m, 0.0}, TextureLaw::lateral, kHeight_m, kGain});
    }
    plan.tool = std::make_shared<const ToolPlan>(std::move(tool));
    return plan;
}

void begin(Bench& bench, double scale) {
    bench.device.pose_D = Pose::at(Vector3(0, kTop_m / scale, 0));
    bench.run(200);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
}

ToolRound make_round(const Vector3& hand_W, std::span<const Pose> solids_W, double now_s) {
    return {
        .hand = {Pose::at(hand_W), {}}, .solid_poses_W = solids_W, .now_s = now_s, .dt_s = kDt_s};
}

}  // namespace

TEST_CASE("tool stage: a relief is felt beside the spring, and told as texture") {
    for (const double scale : {1.0, 2.0}) {
        Bench rough(make_floor(true, scale));
        Bench plain(make_floor(false, scale));
        std::size_t slot = 0;
        while (rough.loop.effects()[slot].effect != Effect::texture) {
            REQUIRE(++slot < rough.loop.effects().size());
        }
        CHECK(std::ranges::none_of(plain.loop.effects(), [](const EffectSlot& each) {
            return each.effect == Effect::texture;
        }));
        double most_N = 0.0;
        begin(rough, scale);
        begin(plain, scale);
        for (int i = 0; i < 3000; ++i) {
            const double down = std::min(1.0, 0.001 * i);
            const Pose hand = Pose::at(
                Vector3(0.02 * std::sin(0.002 * i), kTop_m + (0.014 - kTop_m) * down, 0.01) /
                scale);
            rough.device.pose_D = hand;
            plain.device.pose_D = hand;
            rough.run(1);
            plain.run(1);
            const Vector3 more_W =
                rough.loop.state().commanded_W.force - plain.loop.state().commanded_W.force;
            REQUIRE(rough.loop.state().proxy_position_W == plain.loop.state().proxy_position_W);
            if (i > 1500) {
                most_N = std::max(most_N, std::abs(more_W.x()));
                // The floor pushes up as it did.
                REQUIRE(std::abs(more_W.y()) < 0.05);
            }
            // Over it, nothing.
            REQUIRE((plain.loop.state().commanded_W.force.norm() > 0.0 || more_W.isZero(0.0)));
        }
        // K d gain times the slope, less what the passivity stage takes.
        const double wanted_N = kStiffness_N_per_m / scale * 0.006 * kSlope;
        CHECK(most_N > 0.8 * wanted_N);
        CHECK(most_N < 1.2 * wanted_N);
    }
}

TEST_CASE("tool stage: pumped by a relief that gives more than it took, only its loan is ideal") {
    const double way = GENERATE(1.0, -1.0);
    const HapticPlan plan = make_floor(true);
    ToolStage stage(plan);
    REQUIRE(stage.has_texture());
    const Pose floor_W = plan.solids[0].initial_pose_W;
    Vector3 hand_W(0.0, 0.03, 0.01);
    double now_s = 0.0;
    ToolForce before = stage.step(make_round(hand_W, {&floor_W, 1}, now_s));
    double given_J = 0.0;
    double ideal_J = 0.0;
    double counted_J = 0.0;
    double most_J = 0.0;
    for (int i = 0; i < 20000; ++i) {
        now_s += kDt_s;
        // Pressed downhill, lifted uphill, over half a wave of 4 mm.
        const double phase = 2.0 * std::numbers::pi * i / 400.0;
        const Vector3 next_W(0.001 * std::cos(phase), 0.017 - way * 0.002 * std::sin(phase), 0.01);
        const Vector3 moved_W = next_W - hand_W;
        hand_W = next_W;
        const ToolForce now = stage.step(make_round(hand_W, {&floor_W, 1}, now_s));
        REQUIRE((now.wrench_W.force - now.spring_W.force - now.texture_W.force).norm() < 1.0e-9);
        REQUIRE(now.texture_force.now_W == now.texture_W.force);
        given_J += before.texture_W.force.dot(moved_W);
        counted_J += 0.5 * (before.texture_force.now_W + now.texture_force.held_W).dot(moved_W);
        ideal_J = std::max(ideal_J, counted_J);
        most_J = std::max(most_J, kStiffness_N_per_m * 0.005 * kGain * kHeight_m);
        before = now;
    }
    CAPTURE(given_J, ideal_J, most_J);
    // One way round it gives, the other it takes.
    CHECK(way * given_J > 3.0 * most_J);
    CHECK(ideal_J < 2.5 * most_J);
}
