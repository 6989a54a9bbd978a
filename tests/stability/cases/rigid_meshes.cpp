// Rigid bodies of triangles that are not convex: they hold, ring and hook into each other.
#include "haptics/geometry/shape.h"
#include "tests/stability/cases/stability_case.h"
#include "tests/support/hollow_meshes.h"
#include "tests/support/rigid_worlds.h"
#include "tests/support/touchable.h"

#include <cmath>
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

}  // namespace
}  // namespace fulcrum::stability
