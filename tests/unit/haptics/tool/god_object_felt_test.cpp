// What hand and objects feel between two sets of contacts, and of sets that come late: with a relief, and in its fade.
#include "haptics/geometry/shape.h"
#include "haptics/tool/god_object_tool.h"
#include "tests/support/god_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace fulcrum {
namespace {

constexpr double kDt_s = 0.001;
constexpr double kHalf_m = 0.01;
constexpr double kStiffness = 500.0;
const MovingFrame kFloor{Pose::at({0.0, -0.05, 0.0}), {}};  // its top is y = 0

// A block on grooves along z; so heavy to turn that it stays as it is held.
GodObjectTool make_block_on_grooves(bool own_motion) {
    GodObjectPlan plan{.object = GodSurface::create(make_box({0.6, 0.1, 0.6}).value()),
                       .tool = GodSurface::create(test::make_cube(2.0 * kHalf_m))};
    plan.texture = std::make_shared<const Texture>(
        TextureSettings{SineTexture{0.0043, 0.0}, TextureLaw::lateral, 2.0e-4, 1.0});
    GodObjectSettings settings = test::make_sudden_settings(test::make_still_inertia());
    settings.own_motion = own_motion;
    return GodObjectTool::build({plan}, settings).value();
}

// Pressed `depth_m` deep, so far along.
Pose hand_at(double x_m, double depth_m) {
    return Pose::at({x_m, kHalf_m - depth_m, 0.02});
}

// Down from above, and left to come to rest.
ToolFelt press(GodObjectTool& tool, double x_m, double depth_m, double& t_s) {
    tool.place(hand_at(x_m, -0.002));
    ToolFelt felt;
    for (int i = 0; i < 80; ++i) {
        t_s += kDt_s;
        felt = tool.move({hand_at(x_m, depth_m), {}}, {&kFloor, 1}, t_s, kDt_s);
        if (BesideTask* const beside = tool.beside(); beside != nullptr) {
            (void)beside->run_once();
        }
    }
    return felt;
}

}  // namespace

TEST_CASE("god object felt: between steps the relief weakens with the push, and never grows") {
    GodObjectTool tool = make_block_on_grooves(true);
    double t_s = 0.0;
    const ToolFelt felt = press(tool, 0.011, 0.002, t_s);
    const double relief_N = felt.texture_W.force.x();
    REQUIRE(std::abs(relief_N) > 0.01);
    const auto felt_at = [&](double depth_m) { return tool.force(hand_at(0.011, depth_m)).force; };
    CHECK(felt_at(0.002).x() == Approx(relief_N).epsilon(1.0e-6));
    CHECK(felt_at(0.001).x() == Approx(0.5 * relief_N).epsilon(1.0e-2));
    CHECK(felt_at(0.004).x() == Approx(relief_N).epsilon(1.0e-6));
    CHECK(felt_at(0.004).y() == Approx(2.0 * kStiffness * 0.002).epsilon(1.0e-2));
    CHECK(felt_at(-0.001).isZero(0.0));
}

TEST_CASE("god object felt: beside its motion it feels grooves as a tool in line a step before") {
    GodObjectTool in_line = make_block_on_grooves(true);
    GodObjectTool beside = make_block_on_grooves(false);
    double t_s = 0.0;
    (void)press(in_line, 0.0, 0.002, t_s);
    t_s = 0.0;
    (void)press(beside, 0.0, 0.002, t_s);
    Vector3 before = Vector3::Zero();
    double most_N = 0.0;
    for (int i = 0; i < 400; ++i) {
        t_s += kDt_s;
        // Fast enough that the relief is evened over a step's way.
        const Pose hand = hand_at(0.0004 * std::min(i, 300), 0.002);
        const ToolFelt late = beside.move({hand, {}}, {&kFloor, 1}, t_s, kDt_s);
        REQUIRE(beside.beside()->run_once());
        CAPTURE(i);
        if (i > 20) {
            REQUIRE((late.texture_W.force - before).norm() < 1.0e-4);
        }
        before = in_line.move({hand, {}}, {&kFloor, 1}, t_s, kDt_s).texture_W.force;
        most_N = std::max(most_N, before.norm());
    }
    CHECK(most_N > 0.02);
    // At rest there nothing is evened over the way that it came.
    GodObjectTool pressed = make_block_on_grooves(true);
    CHECK((press(pressed, 0.0004 * 300, 0.002, t_s).texture_W.force - before).norm() <
          1.0e-3 * most_N);
}

TEST_CASE("god object felt: what is late is felt as weakly between two steps as in them") {
    GodObjectTool tool = make_block_on_grooves(false);
    double t_s = 0.0;
    (void)press(tool, 0.011, 0.002, t_s);
    const Pose hand = hand_at(0.011, 0.002);
    int n_faded = 0;
    for (int i = 0; i < 250; ++i) {
        t_s += kDt_s;
        const ToolFelt felt = tool.move({hand, {}}, {&kFloor, 1}, t_s, kDt_s);
        CAPTURE(i);
        REQUIRE((tool.force(hand).force - felt.felt_W.force).norm() < 1.0e-9);
        REQUIRE((tool.force(hand).torque - felt.felt_W.torque).norm() < 1.0e-9);
        n_faded += felt.felt_W.force.y() < 0.9 && felt.felt_W.force.y() > 0.1 ? 1 : 0;
    }
    CHECK(n_faded > 50);
    CHECK(tool.force(hand).force == Vector3::Zero());
}

TEST_CASE(
    "god object felt: stopped over grooves it feels them once the way it came is evened out") {
    const auto texture = std::make_shared<const Texture>(
        TextureSettings{SineTexture{0.0043, 0.0}, TextureLaw::lateral, 2.0e-4, 1.0});
    GodTexture felt(texture, {.stiffness_N_per_m = kStiffness, .reach_m = 0.02, .fade_s = 0.03});
    constexpr double kForce_N = 1.0;
    // Where the grooves are steepest.
    constexpr double kEnd_m = 4 * 0.0043;
    constexpr double kStep_m = 0.002;
    const auto feel = [&](double from_m, double to_m) {
        felt.begin(Pose::at({from_m, 0.0, 0.0}), Pose::at({to_m, 0.0, 0.0}), kForce_N);
        felt.add({to_m, 0.0, 0.0}, Vector3::UnitY(), kForce_N);
        return felt.finish(kDt_s).force.x();
    };
    double fast_N = 0.0;
    for (int i = 40; i > 0; --i) {
        fast_N = feel(kEnd_m - kStep_m * i, kEnd_m - kStep_m * (i - 1));
    }
    double stopped_N = 0.0;
    for (int i = 0; i < 12; ++i) {
        stopped_N = feel(kEnd_m, kEnd_m);
    }
    const double steepest_N = kForce_N * std::abs(texture->relief({kEnd_m, 0.0}).slope_u);
    CAPTURE(fast_N, stopped_N, steepest_N);
    CHECK(std::abs(fast_N) < 0.2 * steepest_N);
    CHECK(std::abs(stopped_N) > 0.9 * steepest_N);
}

}  // namespace fulcrum
