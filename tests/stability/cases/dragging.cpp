// A hand that drags over a floor with friction, in closed loop on a simulated arm: no buzz, no energy from nowhere, and the
// drag that Coulomb says.
#include "tests/stability/cases/held_arm.h"
#include "tests/stability/cases/stability_case.h"

#include <cmath>
#include <numbers>

namespace fulcrum::stability {
namespace {

constexpr double kReach_m = 0.03;
constexpr double kPeriod_s = 2.0;
constexpr double kSettle_s = 1.0;
constexpr double kCoefficient = 0.5;
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

constexpr FrictionSettings kCoulomb{kCoefficient, kCoefficient, 0.0};

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
