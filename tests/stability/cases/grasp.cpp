// Two cursors with friction take a box between them: it hangs by friction alone, and the box is a rigid body that both push.
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/touchable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace fulcrum::stability {
namespace {

constexpr double kEdge_m = 0.1;
constexpr double kMass_kg = 0.2;
constexpr double kGravity = 9.81;
constexpr double kPeriod_s = 0.001;
constexpr double kSqueeze_m = 0.006;  // how far each hand is within its face
constexpr double kStiffness_N_per_m = 1000.0;
// What hangs between two points swings; the fingers' own damping, of the box against the world, ends it.
constexpr double kDamping_Ns_per_m = 2.0;

// The box between two hands; each pushes with -k (proxy - hand) where its proxy stands.
class Grasp {
  public:
    explicit Grasp(const FrictionSettings& friction) {
        const SolidPlan box{.body = 0,
                            .shape = touchable(make_box(Vector3::Constant(kEdge_m))),
                            .friction = friction};
        for (std::size_t i = 0; i < 2; ++i) {
            fingers_[i] = make_proxy({.kind = ProxyKind::friction_cone}, {box},
                                     {{.stiffness_N_per_m = kStiffness_N_per_m}, kPeriod_s});
            fingers_[i]->reset(hand(i, -0.01, 0.0));
        }
        state_.pose_W = Pose{Vector3::Zero(), Quaternion::Identity()};
    }

    // Both hands `squeeze_m` within their faces, `lift_m` up. Gravity acts only while `falls`, as if a table held the box.
    void step(double squeeze_m, double lift_m, bool falls) {
        Wrench wrench{Vector3(0.0, falls ? -kMass_kg * kGravity : 0.0, 0.0), Vector3::Zero()};
        for (std::size_t i = 0; i < 2; ++i) {
            const Vector3 at_W = hand(i, squeeze_m, lift_m);
            const ProxyContact& contact = fingers_[i]->step(at_W, {&state_.pose_W, 1});
            for (const SolidTouch& touch : contact.active()) {
                const Vector3 force_W =
                    -kStiffness_N_per_m * (touch.push_m * touch.normal_W + touch.drag_W);
                wrench.force += force_W;
                wrench.torque += (contact.position_W - state_.pose_W.position).cross(force_W);
            }
        }
        wrench.force -= kDamping_Ns_per_m * state_.velocity_W.linear;
        wrench.torque -= 1.0e-3 * state_.velocity_W.angular;
        (void)step_rigid_body({.integrator = Integrator::semi_implicit_euler}, inertia_,
                              ConstantLoad(wrench), 0.0, kPeriod_s, state_);
    }
    [[nodiscard]] const RigidState& state() const { return state_; }

  private:
    // The first comes from the left, the second from the right, a little above the box's middle.
    [[nodiscard]] static Vector3 hand(std::size_t i, double squeeze_m, double lift_m) {
        const double side = i == 0 ? -1.0 : 1.0;
        return {side * (0.5 * kEdge_m - squeeze_m), 0.01 + lift_m, 0.0};
    }

    Inertia inertia_ = make_box_inertia(kMass_kg, Vector3::Constant(kEdge_m));
    RigidState state_;
    std::array<std::unique_ptr<Proxy>, 2> fingers_;
};

// How far the box is from where the hands carry it, after they took it, lifted it by 0.2 m and held it for two seconds.
double lift(const FrictionSettings& friction) {
    Grasp grasp(friction);
    const auto smooth = [](double s) {
        const double u = std::clamp(s, 0.0, 1.0);
        return u * u * (3.0 - 2.0 * u);
    };
    double worst_m = 0.0;
    for (int i = 0; i < 5000; ++i) {
        const double t = kPeriod_s * i;
        const double lift_m = 0.2 * smooth((t - 0.8) / 1.5);
        grasp.step(kSqueeze_m * smooth(t / 0.3) - 0.01 * (1.0 - smooth(t / 0.1)), lift_m, t > 0.5);
        if (t > 2.8) {
            worst_m = worse(worst_m, std::abs(grasp.state().pose_W.position.y() - lift_m));
        }
    }
    return worst_m;
}

// 12 N of friction at most carry 2 N: the box sags by m g / 2 k, 1 mm, and the rest is creep.
Finding lift_box() {
    return {lift({0.8, 0.6, 0.0}), 1.1 * kMass_kg * kGravity / (2.0 * kStiffness_N_per_m), ""};
}

// 1.2 N of friction at most cannot: the box must be seen to slip, or the first case shows nothing.
Finding drop_box() {
    const double fallen_m = lift({0.1, 0.1, 0.0});
    return {fallen_m > 0.1 ? 0.0 : 1.0, 0.5, "fell"};
}

const HardCase kLift{{"two fingers lift a box",
                      "two cursors squeeze a rigid box of 0.2 kg and lift it by friction alone",
                      "how far it hangs from where the hands carry it", "m", lift_box}};
const HardCase kDrop{{"two slippery fingers let a box slip",
                      "the same with a coefficient of 0.1, too little for the weight",
                      "1 when the box stayed nevertheless", "", drop_box}};

}  // namespace
}  // namespace fulcrum::stability
