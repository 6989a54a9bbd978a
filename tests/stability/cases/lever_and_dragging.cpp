#include "haptics/collision/collision_mesh.h"
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/tool_scene.h"

#include <cmath>
#include <initializer_list>
#include <memory>
#include <numbers>

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

constexpr double kReach_m = 0.03;
constexpr double kPeriod_s = 2.0;
constexpr double kSettle_s = 1.0;
constexpr double kCoefficient = 0.5;
constexpr FrictionSettings kCoulomb{kCoefficient, kCoefficient, 0.0};
// Two steps of the encoder: one step is worth 0.2 N of push here, and the fingertip yields to it.
constexpr double kShake_um = 110.0;
// Would move the bare handle at 0.15 m/s; a floor as stiff without friction comes to a third of it.
constexpr double kExcess_mJ = 0.5;

struct Course {
    double worst_shake_m = 0.0;  // the hand about its own mean over 21 ms, in any direction
    double mean_ratio = 0.0;     // of drag to push
    double peak_J = 0.0;         // given to the hand beyond what the ideal scene gives
};

// As stiff as the map of stable walls allows for this hand.
HapticPlan make_plan(const HumanImpedance& human, const FrictionSettings& friction) {
    HapticPlan plan = make_floor_plan();
    plan.proxy.kind = ProxyKind::friction_cone;
    plan.coupling.stiffness_N_per_m = find_stiffness_inside(human, plan.coupling.damping_Ns_per_m);
    plan.solids.front().friction = friction;
    return plan;
}

// Down onto the floor, then to and fro for four seconds.
Course drag(const HapticPlan& plan, const SimulatedArmSettings& arm) {
    HeldArm held(plan, arm);
    held.aim(-kFloorPress_m);
    held.run(kSettle_s);
    Course course;
    std::array<Vector3, 21> window;
    window.fill(held.position_m());
    double sum = 0.0;
    int n = 0;
    const double start_x = held.position_m().x();
    for (int i = 0; i < 4000; ++i) {
        const double phase = 2.0 * std::numbers::pi * 0.001 * i / kPeriod_s;
        const double speed = std::cos(phase);
        held.aim_at({start_x + kReach_m * std::sin(phase), -kFloorPress_m, 0.017});
        held.step();
        window[static_cast<std::size_t>(i) % window.size()] = held.position_m();
        if (i < 500) {
            continue;  // it starts with a jerk
        }
        course.peak_J = worse(course.peak_J, held.state().force_energy.excess_J);
        if (std::abs(speed) < 0.5) {
            continue;  // near the turning points it sticks, and bends its course
        }
        Vector3 mean = Vector3::Zero();
        for (const Vector3& p : window) {
            mean += p / static_cast<double>(window.size());
        }
        // Ten rounds ago, in the middle of a course that is nearly straight.
        const Vector3& middle = window[static_cast<std::size_t>(i - 10) % window.size()];
        course.worst_shake_m = worse(course.worst_shake_m, (middle - mean).norm());
        const Vector3& proxy_W = held.state().proxy_position_W;
        const Vector3 pull = proxy_W - held.state().tool_pose_W.position;
        // On the way up the circle grows, and the proxy may rest for a round: never more than the coefficient, mostly it.
        sum += std::abs(pull.x()) / pull.y();
        ++n;
    }
    course.mean_ratio = sum / n;
    return course;
}

Finding shake_in_fingertip() {
    return {
        1e6 * drag(make_plan(kFingertip, kCoulomb), make_arm_over_floor(kFingertip)).worst_shake_m,
        kShake_um, ""};
}
Finding shake_under_arm() {
    return {1e6 * drag(make_plan(kArm, kCoulomb), make_arm_over_floor(kArm)).worst_shake_m,
            kShake_um, ""};
}
Finding keep_coefficient() {
    const Course course = drag(make_plan(kFingertip, kCoulomb), make_arm_over_floor(kFingertip));
    return {std::abs(course.mean_ratio - kCoefficient), 0.01 * kCoefficient, ""};
}
Finding give_no_energy() {
    return {
        1e3 * drag(make_plan(kFingertip, {1.0, 0.4, 2.0}), make_arm_over_floor(kFingertip)).peak_J,
        kExcess_mJ, ""};
}

const HardCase kShakeTip{
    {"dragging over a rough floor, fingertip",
     "a fingertip drags to and fro over a floor with a coefficient of 0.5, as stiff as it can be",
     "how far the hand shakes about its course", "um", shake_in_fingertip}};
const HardCase kShakeArm{{"dragging over a rough floor, arm",
                          "the same with the whole arm behind it",
                          "how far the hand shakes about its course", "um", shake_under_arm}};
const HardCase kRatio{{"dragging over a rough floor, coefficient",
                       "while it slides in closed loop the drag is 0.5 of the push",
                       "difference of their mean ratio", "", keep_coefficient}};
const HardCase kEnergy{{"sticking and slipping",
                        "static friction of twice the dynamic, a little viscosity",
                        "energy beyond what the ideal scene gives", "mJ", give_no_energy}};

}  // namespace

}  // namespace fulcrum::stability
