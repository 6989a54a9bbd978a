// A hand on what turns about an axle: a lever from 1 : 1 to 1 : 1000, and the lightest body that a plan may have.
#include "haptics/geometry/shape.h"
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kShort_m = 0.5;  // from the lever's middle to each place where something presses
constexpr double kQuiet_m = 5.0e-5;  // what a still hand may be moved by
constexpr double kSettle_s = 6.0;

// A beam whose right end lies under the arm, and a weight on its left end that the hand balances with one newton.
HapticPlan make_lever_plan(double ratio, double inertia_kg_m2) {
    const auto mesh = make_box(Vector3(1.16, 0.04, 0.1)).and_then([](const TriangleMesh& box) {
        return CollisionMesh::create(box);
    });
    if (!mesh) {
        throw std::runtime_error(to_sentence(mesh.error()));
    }
    HapticPlan plan = make_floor_plan();
    plan.solids[0].shape = *mesh;
    plan.solids[0].initial_pose_W = Pose::at(Vector3(0.013 - kShort_m, -0.02, 0.017));
    AxlePlan lever;
    lever.axle.inertia_kg_m2 = inertia_kg_m2;
    lever.axle.pivot_B = {-kShort_m + 2.0 * kShort_m / (1.0 + ratio), -0.02, 0.0};
    lever.axle.load_B = {-kShort_m, -0.02, 0.0};
    lever.axle.load_N = ratio;
    lever.axle.lowest_rad = -0.12;
    lever.axle.highest_rad = 0.12;
    lever.reach_m = kShort_m + std::abs(lever.axle.pivot_B.x());
    plan.axles.push_back(lever);
    return plan;
}

// How far the hand goes to and fro in the last second of holding the lever down.
double find_shaking(const HumanImpedance& human, double ratio, double inertia_kg_m2) {
    HeldArm held(make_lever_plan(ratio, inertia_kg_m2), make_arm_over_floor(human));
    held.aim(-0.01);
    held.run(kSettle_s);
    double lowest_m = held.height_m();
    double highest_m = lowest_m;
    for (int i = 0; i < 1000; ++i) {
        held.step();
        lowest_m = std::min(lowest_m, held.height_m());
        highest_m = std::max(highest_m, held.height_m());
    }
    // A hand that has lost the lever would be still as well.
    return held.state().touched_body == 0 ? highest_m - lowest_m : std::nan("");
}

// The worst of three hands at each ratio.
Finding find_worst(std::initializer_list<double> ratios, double inertia_kg_m2) {
    Finding finding{0.0, kQuiet_m, {}};
    for (const double ratio : ratios) {
        for (const HumanImpedance& human : {kFingertip, kArm, kPosture}) {
            const double shaking_m = find_shaking(human, ratio, inertia_kg_m2);
            if (!(shaking_m <= finding.worst)) {
                finding.note = "1 : " + std::to_string(static_cast<int>(ratio));
            }
            finding.worst = worse(finding.worst, shaking_m);
        }
    }
    return finding;
}

Finding hold_lever() {
    return find_worst({1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0}, 0.4);
}

Finding hold_lightest() {
    return find_worst({1.0}, kLeastRimMass_kg * kShort_m * kShort_m);
}

const HardCase kLever{
    {"lever from 1 : 1 to 1 : 1000",
     "a hand holds down the long arm of a lever whose short arm carries 1 to 1000 N",
     "movement of the hand in a second", "m", hold_lever}};
const HardCase kLightest{{"lightest body on a hinge",
                          "a hand holds the lightest lever that a plan may have, against a weight",
                          "movement of the hand in a second", "m", hold_lightest}};

}  // namespace
}  // namespace fulcrum::stability
