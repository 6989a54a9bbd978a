// Worlds of rigid bodies for hard cases, benchmarks and tests: one that cannot be made ends them with its sentence.
#pragma once

#include "haptics/dynamics/rigid_world.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace fulcrum {

/// Bodies that are never put to sleep, and have their weight.
inline RigidWorldPlan plan_awake(std::vector<RigidBodyPlan> bodies) {
    RigidWorldPlan plan;
    plan.settings.sleep_after_s = 0.0;
    plan.bodies = std::move(bodies);
    return plan;
}
/// The same without.
inline RigidWorldPlan plan_weightless(std::vector<RigidBodyPlan> bodies) {
    RigidWorldPlan plan = plan_awake(std::move(bodies));
    plan.settings.gravity_W.setZero();
    return plan;
}

/// A mass of 0 is by the density of water.
inline RigidBodyPlan plan_body(const SolidShape& shape, const Pose& pose_W, double mass_kg = 0.0,
                               const Twist& velocity_W = {}) {
    return {.shape = shape, .mass_kg = mass_kg, .pose_W = pose_W, .velocity_W = velocity_W};
}
inline RigidBodyPlan plan_ball(double radius_m, const Vector3& at_W, double mass_kg = 0.0,
                               const Vector3& velocity_W = Vector3::Zero()) {
    return plan_body(SphereShape{radius_m}, Pose::at(at_W), mass_kg, {velocity_W, Vector3::Zero()});
}
inline RigidBodyPlan plan_box(const Vector3& half_size_m, const Vector3& at_W,
                              double mass_kg = 0.0) {
    return plan_body(BoxShape{half_size_m}, Pose::at(at_W), mass_kg);
}
inline RigidBodyPlan plan_cube(double half_m, const Vector3& at_W, double mass_kg = 0.0) {
    return plan_box(Vector3::Constant(half_m), at_W, mass_kg);
}
inline RigidBodyPlan plan_wall(const SolidShape& shape, const Vector3& at_W) {
    RigidBodyPlan wall = plan_body(shape, Pose::at(at_W));
    wall.role = BodyRole::stays;
    return wall;
}
/// Level, at height 0.
inline RigidBodyPlan plan_ground(double friction = 0.6) {
    return {.role = BodyRole::ground, .static_friction = friction, .dynamic_friction = friction};
}
inline RigidBodyPlan with_restitution(RigidBodyPlan body, double restitution) {
    body.restitution = restitution;
    return body;
}

inline std::unique_ptr<RigidWorld> make_rigid_world(const RigidWorldPlan& plan) {
    auto world = RigidWorld::create(plan);
    if (!world) {
        throw std::runtime_error(to_sentence(world.error()));
    }
    return std::move(*world);
}

/// In steps of a millisecond.
inline void run(RigidWorld& world, double time_s) {
    constexpr double kStep_s = 1.0e-3;
    for (int i = 0; i < static_cast<int>(std::lround(time_s / kStep_s)); ++i) {
        world.step(kStep_s);
    }
}

}  // namespace fulcrum
