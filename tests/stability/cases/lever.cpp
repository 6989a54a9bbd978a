// A hand on what turns about an axle, with a point or with an upright cylinder: a lever from 1 : 1 to 1 : 1000, and the lightest
// body that a plan may have.
#include "haptics/collision/collision_mesh.h"
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/tool_scene.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kShort_m = 0.5;  // from the lever's middle to each place where something presses
constexpr double kHalfTool_m = 0.03;
constexpr double kQuiet_m = 5.0e-5;  // what a still hand may be moved by
constexpr double kLightest_kg_m2 = kLeastRimMass_kg * kShort_m * kShort_m;

// What presses the lever, and how.
struct Presser {
    std::shared_ptr<const ToolPlan> tool;  // none: a point
    double reach_m = 0.0;                  // of the tool below the hand
    double lower_s = 0.0;                  // the hand goes down in this time
    double settle_s = 6.0;
};

TriangleMesh make_beam() {
    return make_box(Vector3(1.16, 0.04, 0.1)).value();
}

// With a tool the lever settles more slowly: in a fingertip its swing falls to an e-th in 1.2 s.
Presser make_cylinder_presser() {
    test::ToolScene scene{.tool = make_cylinder(0.012, 2.0 * kHalfTool_m, 48).value(),
                          .inertia = {0.02, {6.7e-6, 1.4e-6, 6.7e-6}},
                          .method = ToolMethod::field_sampling,
                          .voxel_m = 0.003,
                          .n_points = 500};
    scene.settings.coupling.turn.stiffness_Nm_per_rad = 0.5;
    return {.tool = test::make_tool_of(scene, {make_beam()}),
            .reach_m = kHalfTool_m,
            .lower_s = 0.5,
            .settle_s = 12.0};
}

// A beam whose right end lies under the arm, and a weight on its left end that the hand balances with one newton.
HapticPlan make_lever_plan(const Presser& presser, double ratio, double inertia_kg_m2) {
    HapticPlan plan = make_floor_plan();
    plan.solids[0].shape = CollisionMesh::create(make_beam()).value();
    plan.solids[0].initial_pose_W =
        Pose::at(Vector3(0.013 - kShort_m, -0.02 - presser.reach_m, 0.017));
    AxlePlan lever;
    lever.axle.inertia_kg_m2 = inertia_kg_m2;
    lever.axle.pivot_B = {-kShort_m + 2.0 * kShort_m / (1.0 + ratio), -0.02, 0.0};
    lever.axle.load_B = {-kShort_m, -0.02, 0.0};
    lever.axle.load_N = ratio;
    lever.axle.lowest_rad = -0.12;
    lever.axle.highest_rad = 0.12;
    lever.reach_m = kShort_m + std::abs(lever.axle.pivot_B.x());
    plan.axles.push_back(lever);
    plan.tool = presser.tool;
    return plan;
}

struct Held {
    double shaking_m = 0.0;  // how far the hand goes to and fro in the last second
    double force_N = 0.0;    // what it holds the lever with, upwards on the hand
};

Held hold(const Presser& presser, const HumanImpedance& human, double ratio, double inertia_kg_m2) {
    HeldArm held(make_lever_plan(presser, ratio, inertia_kg_m2), make_arm_over_floor(human));
    const int n_lower = static_cast<int>(1000.0 * presser.lower_s);
    for (int i = 0; i < n_lower; ++i) {
        held.aim(0.02 - 0.03 * i / n_lower);
        held.step();
    }
    held.aim(-0.01);
    held.run(presser.settle_s);
    Swing swing;
    swing.take(held.height_m());
    double force_N = 0.0;
    for (int i = 0; i < 1000; ++i) {
        held.step();
        swing.take(held.height_m());
        force_N += held.state().applied_W.force.y() / 1000.0;
    }
    // A hand that has lost the lever would be still as well.
    return held.state().touched_body == 0 ? Held{swing.width(), force_N} : Held{std::nan(""), 0.0};
}

// The worst of three hands at each ratio.
Finding find_worst(const Presser& presser, std::initializer_list<double> ratios,
                   double inertia_kg_m2) {
    Finding finding{0.0, kQuiet_m, {}};
    for (const double ratio : ratios) {
        for (const HumanImpedance& human : kHands) {
            const Held held = hold(presser, human, ratio, inertia_kg_m2);
            finding.take(held.shaking_m, describe("1 : %g, held with %.3f N", ratio, held.force_N));
            // One newton balances the weight; the lever's own friction and slope leave it between these.
            if (!(held.force_N > 0.9 && held.force_N < 1.1)) {
                finding.worst = std::nan("");
            }
        }
    }
    return finding;
}

Finding hold_lever() {
    return find_worst({}, {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0}, 0.4);
}

Finding hold_lightest() {
    return find_worst({}, {1.0}, kLightest_kg_m2);
}

Finding hold_lever_with_tool() {
    return find_worst(make_cylinder_presser(), {1.0, 30.0, 1000.0}, 0.4);
}

Finding hold_lightest_with_tool() {
    return find_worst(make_cylinder_presser(), {1.0}, kLightest_kg_m2);
}

constexpr const char* kMeasured = "movement of the hand in a second; one newton holds it";
const HardCase kLever{
    {"lever from 1 : 1 to 1 : 1000",
     "a hand holds down the long arm of a lever whose short arm carries 1 to 1000 N", kMeasured,
     "m", hold_lever}};
const HardCase kLightest{{"lightest body on a hinge",
                          "a hand holds the lightest lever that a plan may have, against a weight",
                          kMeasured, "m", hold_lightest}};
const HardCase kToolOnLever{{"tool on a lever from 1 : 1 to 1 : 1000",
                             "a cylinder in the hand holds down the lever, upright", kMeasured, "m",
                             hold_lever_with_tool}};
const HardCase kToolOnLightest{{"tool on the lightest body on a hinge",
                                "a cylinder in the hand holds down the lightest lever", kMeasured,
                                "m", hold_lightest_with_tool}};

}  // namespace
}  // namespace fulcrum::stability
