// Two cubes on the ends of a thin rod, joined by balls, that spin freely: a slender body has hardly any moment about itself, so the least
// torque too much about it runs away, and the joints hand it on to all.
#include "haptics/dynamics/rigid_world.h"
#include "tests/stability/cases/stability_case.h"

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
         .pose_W = {Vector3::Zero(), Quaternion(Eigen::AngleAxisd(M_PI / 2, Vector3::UnitZ()))},
         .velocity_W = {Vector3::Zero(), spin + Vector3(chain.rod_spin_rad_per_s, 0.0, 0.0)}});
    return plan;
}

// Of what it began with, in 10 s.
double find_gain(const SpinningChain& chain) {
    auto world = RigidWorld::create(make_spinning_chain(chain));
    if (!world) {
        throw std::runtime_error(to_sentence(world.error()));
    }
    const double energy_J = (*world)->compute_energy_J();
    double gain = 0.0;
    for (int i = 0; i < 10000; ++i) {
        (*world)->step(1.0e-3);
        gain = worse(gain, (*world)->compute_energy_J() / energy_J - 1.0);
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

const HardCase kThinChain{
    {"spinning thin chain",
     "two cubes of 1 kg on a thin rod of 0.1 kg spin for 10 s, the rod about itself too",
     "energy won, of all", "", spin_thin_chain}};

}  // namespace
}  // namespace fulcrum::stability
