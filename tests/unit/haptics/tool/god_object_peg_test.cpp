// A peg of 288 triangles and a hole of 280, a thousandth wider: in, turned, wedged, out.
#include "haptics/math/rotation.h"
#include "tests/support/god_scene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fulcrum {
namespace {

using test::kGodDt_s;

constexpr double kRadius_m = 0.01;
constexpr double kClearance = 1.001;
constexpr double kLength_m = 0.04;
constexpr double kBlock_m = 0.03;  // how long the hole is
constexpr double kMass_kg = 0.05;

// make_cylinder stands along y; the hole goes along z.
TriangleMesh make_peg() {
    const TriangleMesh upright = make_cylinder(kRadius_m, kLength_m, 72).value();
    std::vector<Vector3> vertices = upright.vertices_B();
    for (Vector3& v : vertices) {
        v = Vector3(v.x(), -v.z(), v.y());
    }
    return TriangleMesh::build(std::move(vertices), upright.triangles()).value();
}

Inertia make_peg_inertia() {
    const double across = kMass_kg * (3.0 * kRadius_m * kRadius_m + kLength_m * kLength_m) / 12.0;
    return {kMass_kg, {across, across, 0.5 * kMass_kg * kRadius_m * kRadius_m}};
}

struct PegTrial {
    TriangleMesh peg = make_peg();
    TriangleMesh block = test::make_block_with_hole(35, kRadius_m* kClearance, 0.03, kBlock_m);
    GodObjectTool tool;
    double most_force_N = 0.0;
    double most_step_N = 0.0;
    Vector3 last_N{Vector3::Zero()};
    int n_crossing = 0;
    double t_s = 0.0;

    PegTrial()
        : tool(test::make_god_tool(peg, {block}, test::make_god_settings(make_peg_inertia()))) {}
    void step(const Pose& handle) {
        const MovingFrame object{};
        const ToolFelt felt = tool.move({handle, {}}, {&object, 1}, t_s, kGodDt_s);
        t_s += kGodDt_s;
        most_force_N = std::max(most_force_N, felt.felt_W.force.norm());
        most_step_N = std::max(most_step_N, (felt.felt_W.force - last_N).norm());
        last_N = felt.felt_W.force;
        n_crossing += test::do_cross(block, {}, peg, tool.pose_W()) ? 1 : 0;
    }
};

// From 0 to 1, without a jump of the speed.
double ease(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

TEST_CASE(
    "god-object tool: a peg goes into a hole a thousandth wider, is turned in it and comes out") {
    PegTrial trial;
    REQUIRE(trial.peg.triangles().size() == 288);
    REQUIRE(trial.block.triangles().size() == 280);
    const double above_m = 0.5 * (kLength_m + kBlock_m);
    trial.tool.place(Pose::at({0.001, -0.0007, above_m + 0.004}));
    double deepest_m = 1.0;
    double most_turn_rad = 0.0;
    constexpr int kSteps = 3700;
    for (int i = 0; i < kSteps; ++i) {
        const double t_s = i * kGodDt_s;
        // Down onto the rim beside the hole, over it, down, out again.
        const double aside = 1.0 - ease(2.0 * (t_s - 0.5));
        const double down =
            0.0046 * ease(2.0 * t_s) + 0.0254 * ease(t_s - 1.1) - 0.03 * ease(t_s - 2.8);
        // It is not pressed aside any more where it leaves the hole: what nothing is near is not felt.
        const double trembling = 0.003 * (ease(2.0 * (t_s - 1.6)) - ease(2.5 * (t_s - 2.8)));
        const double turn_rad = 1.5 * ease(t_s - 1.6);
        const Pose handle{
            Vector3(0.001 * aside + trembling * std::sin(8.0 * t_s),
                    -0.0007 * aside + trembling * std::cos(6.5 * t_s), above_m + 0.004 - down),
            compute_exp(Vector3(0.01 * aside + 6.0 * trembling * std::sin(5.0 * t_s), 0.0, 0.0)) *
                compute_exp(Vector3(0.0, 0.0, turn_rad))};
        trial.step(handle);
        deepest_m = std::min(deepest_m, trial.tool.centre_W().z());
        most_turn_rad =
            std::max(most_turn_rad, compute_log(trial.tool.pose_W().orientation).norm());
    }
    CAPTURE(trial.most_force_N, trial.most_step_N, deepest_m, most_turn_rad);
    CHECK(trial.n_crossing == 0);
    CHECK(deepest_m < above_m - 0.02);
    CHECK(most_turn_rad > 1.4);
    CHECK(trial.tool.centre_W().z() > above_m);
    CHECK(trial.most_force_N > 0.5);
    CHECK(trial.most_step_N < 0.02 * trial.most_force_N);
}

}  // namespace
}  // namespace fulcrum
