// Two cubes on the ends of a thin rod, joined by balls, that spin freely: a slender body has hardly any moment about itself, so the least
// torque too much about it runs away, and the joints hand it on to all. And links that go round far within a step.
#include "haptics/dynamics/rigid_world.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/rigid_worlds.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace fulcrum::stability {
namespace {

struct SpinningChain {
    SolidShape rod = CapsuleShape{0.005, 0.1};
    double rod_spin_rad_per_s = 0.0;  // about itself
    double off_axis_m = 0.0;          // of the joints
};

RigidWorldPlan make_spinning_chain(const SpinningChain& chain) {
    constexpr double kSpin_rad_per_s = 20.0;
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    const Vector3 spin(0.0, 0.0, kSpin_rad_per_s);
    for (const double side : {-1.0, 1.0}) {
        plan.bodies.push_back({.shape = BoxShape{Vector3::Constant(0.02)},
                               .mass_kg = 1.0,
                               .pose_W = Pose::at({side * 0.2, 0.0, 0.0}),
                               .velocity_W = {{0.0, side * 0.2 * kSpin_rad_per_s, 0.0}, spin}});
        plan.joints.push_back({.kind = JointKind::ball,
                               .body_a = side < 0.0 ? 0 : 1,
                               .body_b = 2,
                               .anchor_W = {side * 0.12, side * chain.off_axis_m, 0.0}});
    }
    plan.bodies[0].velocity_W.linear.z() = 0.02;  // out of the plane
    plan.bodies.push_back(
        {.shape = chain.rod,
         .mass_kg = 0.1,
         .pose_W = {Vector3::Zero(), Quaternion(AngleAxis(M_PI / 2, Vector3::UnitZ()))},
         .velocity_W = {Vector3::Zero(), spin + Vector3(chain.rod_spin_rad_per_s, 0.0, 0.0)}});
    return plan;
}

// Of what it began with, in 10 s.
double find_gain(const SpinningChain& chain) {
    const auto world = make_rigid_world(make_spinning_chain(chain));
    const double energy_J = world->compute_energy_J();
    double gain = 0.0;
    for (int i = 0; i < 10000; ++i) {
        world->step(1.0e-3);
        gain = worse(gain, world->compute_energy_J() / energy_J - 1.0);
    }
    return gain;
}

Finding spin_thin_chain() {
    double worst = 0.0;
    for (const SpinningChain& chain :
         {SpinningChain{}, SpinningChain{.rod = CapsuleShape{0.001, 0.1}},
          SpinningChain{.rod_spin_rad_per_s = 600.0}, SpinningChain{.rod_spin_rad_per_s = 2.0e4},
          // Three different moments, and joints that go round with the rod.
          SpinningChain{.rod = BoxShape{{0.005, 0.1, 0.02}}, .rod_spin_rad_per_s = 1000.0},
          SpinningChain{
              .rod = CapsuleShape{0.02, 0.1}, .rod_spin_rad_per_s = 600.0, .off_axis_m = 0.01}}) {
        worst = worse(worst, find_gain(chain));
    }
    return {worst, 0.01, {}};
}

constexpr int kLinks = 4;
constexpr double kLink_m = 0.1;

// Links in a row from the origin on, the first one pinned there or free.
RigidWorldPlan make_row_of_links(double spin_rad_per_s, bool is_pinned) {
    RigidWorldPlan plan;
    plan.settings.gravity_W.setZero();
    plan.settings.sleep_after_s = 0.0;
    const double middle_m = is_pinned ? 0.0 : 0.5 * kLinks * kLink_m;
    for (int i = 0; i < kLinks; ++i) {
        const double at_m = (i + 0.5) * kLink_m;
        plan.bodies.push_back(
            {.shape = CapsuleShape{0.01, 0.03},
             .mass_kg = 0.1,
             .pose_W = {{at_m, 0.0, 0.0}, Quaternion(AngleAxis(M_PI / 2, Vector3::UnitZ()))},
             .velocity_W = {{0.0, (at_m - middle_m) * spin_rad_per_s, 0.0},
                            {0.0, 0.0, spin_rad_per_s}}});
        plan.joints.push_back({.kind = JointKind::ball,
                               .body_a = i - 1,
                               .body_b = i,
                               .anchor_W = {i * kLink_m, 0.0, 0.0}});
    }
    if (!is_pinned) {
        plan.joints.erase(plan.joints.begin());
    }
    plan.bodies[0].velocity_W.linear.z() = 0.3;  // out of the plane
    return plan;
}

// How far the pins of such links part: the first one's from the world where it is pinned.
double find_parted_m(const RigidWorld& world, bool is_pinned) {
    const Vector3 half(0.0, 0.5 * kLink_m, 0.0);
    double parted_m = is_pinned ? (world.shape_pose_W(0) * half).norm() : 0.0;
    for (int i = 1; i < kLinks; ++i) {
        parted_m = worse(parted_m,
                         (world.shape_pose_W(i - 1) * -half - world.shape_pose_W(i) * half).norm());
    }
    return parted_m;
}

constexpr double kMostParted_m = 5.0e-5;

struct SpunLinks {
    double parted_m = 0.0;
    double changed = 0.0;  // energy, of what it was
};

SpunLinks spin_links(double spin_rad_per_s, double step_s, bool is_pinned) {
    const auto world = make_rigid_world(make_row_of_links(spin_rad_per_s, is_pinned));
    const double energy_J = world->compute_energy_J();
    SpunLinks spun;
    for (int i = 0; i < static_cast<int>(4.0 / step_s); ++i) {
        world->step(step_s);
        spun.parted_m = worse(spun.parted_m, find_parted_m(*world, is_pinned));
        spun.changed = worse(spun.changed, std::abs(world->compute_energy_J() / energy_J - 1.0));
    }
    return spun;
}

SpunLinks spin_all_links() {
    SpunLinks all;
    for (const double step_s : {1.0e-3, 1.0e-2}) {
        for (const double spin_rad_per_s : {15.0, 30.0, 100.0}) {
            for (const bool is_pinned : {false, true}) {
                const SpunLinks spun = spin_links(spin_rad_per_s, step_s, is_pinned);
                all.parted_m = worse(all.parted_m, spun.parted_m);
                all.changed = worse(all.changed, spun.changed);
            }
        }
    }
    return all;
}

// A motor swings a row of links round, with weight, and a clock of slow steps.
double drive_links() {
    RigidWorldPlan plan = make_row_of_links(0.0, true);
    plan.settings.gravity_W = {0.0, -9.81, 0.0};
    plan.settings.slow_period_s = 0.01;
    plan.joints[0].kind = JointKind::hinge;
    plan.joints[0].axis_W = Vector3::UnitZ();
    plan.joints[0].drive = {.motor_speed = 30.0, .motor_force = 20.0};
    const auto world = make_rigid_world(plan);
    double parted_m = 0.0;
    for (int i = 0; i < 4000; ++i) {
        world->step(1.0e-3);
        parted_m = worse(parted_m, find_parted_m(*world, true));
    }
    return parted_m;
}

const HardCase kPins{{"pins of a spinning chain",
                      "four links spin at 15 to 100 rad/s, free or pinned at an end, in steps of 1 "
                      "and 10 ms",
                      "how far any pin parts", "m", [] {
                          return Finding{spin_all_links().parted_m, kMostParted_m, {}};
                      }}};
const HardCase kKept{
    {"energy of a spinning chain", "the same", "energy won or lost, of all", "", [] {
         return Finding{spin_all_links().changed, 0.01, {}};
     }}};
const HardCase kDriven{
    {"pins of a driven chain",
     "a motor of 30 rad/s swings four links round against their weight, in steps "
     "of 10 ms",
     "how far any pin parts", "m", [] {
         return Finding{drive_links(), kMostParted_m, {}};
     }}};
const HardCase kThinChain{
    {"spinning thin chain",
     "two cubes of 1 kg on a thin rod of 0.1 kg spin for 10 s, the rod about itself too",
     "energy won, of all", "", spin_thin_chain}};

}  // namespace
}  // namespace fulcrum::stability
