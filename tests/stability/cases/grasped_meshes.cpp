#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/loads.h"
#include "haptics/geometry/shape.h"
#include "haptics/point/make_proxy.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/hollow_meshes.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/touchable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace fulcrum::stability {
namespace {

constexpr double kMeshStep_s = 1.0e-3;

RigidWorldPlan make_floor() {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies.push_back({.role = BodyRole::ground});
    return plan;
}

Quaternion turn_about(const Vector3& axis, double angle) {
    return Quaternion(AngleAxis(angle, axis));
}

// What is won over the energy at the start, of what the bodies may fall.
class EnergyWatch {
  public:
    EnergyWatch(const RigidWorld& world, double scale_J)
        : begin_J_(world.compute_energy_J()), scale_J_(scale_J) {}
    void look(const RigidWorld& world) {
        worst_ = worse(worst_, (world.compute_energy_J() - begin_J_) / scale_J_);
    }
    [[nodiscard]] double worst() const { return worst_; }

  private:
    double begin_J_;
    double scale_J_;
    double worst_ = 0.0;
};

Finding roll_in_bowl() {
    RigidWorldPlan plan = make_floor();
    plan.bodies.push_back({.shape = SolidShape(touchable(make_bowl(0.12, 0.1, 48, 12))),
                           .role = BodyRole::stays,
                           .pose_W = Pose::at({0.0, 0.12, 0.0})});
    plan.bodies.push_back(
        {.shape = SphereShape{0.02}, .mass_kg = 0.1, .pose_W = Pose::at({0.07, 0.12, 0.0})});
    const auto world = make_rigid_world(plan);
    EnergyWatch energy(*world, 0.1 * 9.81 * 0.1);
    double farthest_m = 0.0;
    for (int i = 0; i < 4000; ++i) {
        world->step(kMeshStep_s);
        energy.look(*world);
        const Vector3 from_middle = world->shape_pose_W(2).position - Vector3(0.0, 0.12, 0.0);
        farthest_m = worse(farthest_m, from_middle.norm());
    }
    const bool is_through = !(farthest_m < 0.081);
    return {is_through ? std::nan("") : energy.worst(), 0.01,
            is_through ? "the ball goes through the bowl" : ""};
}

Finding drop_rings() {
    RigidWorldPlan plan = make_floor();
    plan.bodies.push_back({.shape = CylinderShape{0.03, 0.2},
                           .role = BodyRole::stays,
                           .pose_W = Pose::at({0.0, 0.2, 0.0})});
    const SolidShape ring(touchable(make_torus(0.06, 0.02, 48, 24)));
    const auto sampled = SampledShape::make(ring);
    for (int i = 0; i < 3; ++i) {
        plan.bodies.push_back(
            {.shape = ring,
             .sampled = sampled.value(),
             .mass_kg = 0.3,
             .pose_W = {{0.004, 0.45 + 0.08 * i, 0.0}, turn_about(Vector3::UnitX(), 0.1 * i)}});
    }
    const auto world = make_rigid_world(plan);
    EnergyWatch energy(*world, 3.0 * 0.3 * 9.81 * 0.5);
    double deepest_m = 0.0;
    for (int i = 0; i < 1500; ++i) {
        world->step(kMeshStep_s);
        energy.look(*world);
        deepest_m = worse(deepest_m, world->report().deepest_m);
    }
    for (int i = 0; i < 3; ++i) {
        const Vector3 at = world->shape_pose_W(2 + i).position;
        const bool is_in_place =
            std::hypot(at.x(), at.z()) < 0.012 && std::abs(at.y() - 0.02 - 0.04 * i) < 2.0e-3;
        if (!is_in_place) {
            return {std::nan(""), 1.0e-3, "a ring does not lie round the pole"};
        }
    }
    return {energy.worst() > 1.0e-3 ? std::nan("") : deepest_m, 1.0e-3, {}};
}

Finding swing_links() {
    constexpr int kLinks = 5;
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    const SolidShape link(touchable(make_torus(0.05, 0.01, 48, 24)));
    const auto sampled = SampledShape::make(link);
    for (int i = 0; i < kLinks; ++i) {
        plan.bodies.push_back(
            {.shape = link,
             .sampled = sampled.value(),
             .role = i == 0 ? BodyRole::stays : BodyRole::moves,
             .mass_kg = 0.05,
             .pose_W = {{0.0798 * i, 0.0, 0.0},
                        turn_about(Vector3::UnitX(), i % 2 * 0.5 * std::numbers::pi)}});
    }
    const auto world = make_rigid_world(plan);
    EnergyWatch energy(*world, 0.2 * 9.81 * 0.3);
    double deepest_m = 0.0;
    for (int i = 0; i < 2000; ++i) {
        world->step(kMeshStep_s);
        energy.look(*world);
        deepest_m = worse(deepest_m, world->report().deepest_m);
        for (int j = 1; j < kLinks; ++j) {
            const double apart_m =
                (world->shape_pose_W(j).position - world->shape_pose_W(j - 1).position).norm();
            if (!(apart_m < 0.085)) {
                return {std::nan(""), 2.0e-3, "a link comes off at step " + std::to_string(i)};
            }
        }
    }
    // A fifth of a tube's thickness, where the chain is jerked straight at 4 m/s.
    return {energy.worst() > 1.0e-3 ? std::nan("") : deepest_m, 4.0e-3, {}};
}

Finding stand_as_meshes() {
    RigidWorldPlan plan = make_floor();
    const SolidShape cube(touchable(make_box({0.1, 0.1, 0.1})));
    const auto sampled = SampledShape::make(cube);
    for (int i = 0; i < 5; ++i) {
        plan.bodies.push_back({.shape = cube,
                               .sampled = sampled.value(),
                               .mass_kg = 1.0,
                               .pose_W = Pose::at({0.0, 0.05 + 0.1 * i, 0.0})});
    }
    const auto world = make_rigid_world(plan);
    double worst_m = 0.0;
    for (int i = 0; i < 2000; ++i) {
        world->step(kMeshStep_s);
        for (int j = 1; j <= 5; ++j) {
            worst_m = worse(
                worst_m,
                (world->shape_pose_W(j).position - Vector3(0.0, 0.05 + 0.1 * (j - 1), 0.0)).norm());
        }
        worst_m = worse(worst_m, world->report().deepest_m);
    }
    return {worst_m, 1.0e-4, {}};
}

const HardCase kBowl{{"mesh: a ball in a bowl",
                      "a ball rolls to and fro in a bowl of triangles for 4 s",
                      "energy won, of what it may fall", "", roll_in_bowl}};
const HardCase kRings{{"mesh: rings on a pole",
                       "three rings fall over a pole and lie on each other", "how far any overlaps",
                       "m", drop_rings}};
const HardCase kLinks{{"mesh: a chain of links",
                       "five rings that hang in each other are let go level and swing",
                       "how far any overlaps", "m", swing_links}};
const HardCase kCubes{{"mesh: a stack of cubes", "five cubes as meshes stand on each other for 2 s",
                       "how far any gets or overlaps", "m", stand_as_meshes}};

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
