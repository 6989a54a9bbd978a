// What a world of rigid bodies is made of: bodies with shapes, the joints between them, and how it is stepped.
#pragma once

#include "haptics/base/error.h"
#include "haptics/collision/sampled_shape.h"
#include "haptics/collision/solid_shape.h"
#include "haptics/constraint/contact_solver.h"
#include "haptics/dynamics/joint_plan.h"
#include "haptics/math/spatial.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum {

/// What moves a body.
enum class BodyRole : std::uint8_t {
    moves,  ///< by forces, contacts and joints
    stays,  ///< nothing; a wall
    ground  ///< nothing; all below the plane y = 0 of its frame, whatever its shape
};

struct RigidBodyPlan {
    SolidShape shape = SphereShape{};
    /// Of this shape, where it has been made already; else made with the world, where a mesh is in it.
    std::shared_ptr<const SampledShape> sampled{};
    BodyRole role = BodyRole::moves;
    double density_kg_per_m3 = 1000.0;  ///< above 0
    double mass_kg = 0.0;               ///< 0: by the density; else above 0
    Pose pose_W{};                      ///< of the shape's frame
    Twist velocity_W{};                 ///< of the centre of mass
    double static_friction = 0.6;       ///< 0 to 10; of two bodies the root of the product
    double dynamic_friction = 0.6;      ///< 0 to the static one
    double restitution = 0.0;           ///< 0 to 1; of two bodies the greater
};

/// Fixed at load.
struct RigidWorldSettings {
    Vector3 gravity_W{0.0, -9.81, 0.0};  ///< m/s^2, each component within 1000
    /// Overlap goes at this rate, 0 to 1000 1/s, but no faster than `most_push_m_per_s`, 0 to 100: bodies are moved and get no speed from it.
    double push_rate_per_s = 50.0;
    double most_push_m_per_s = 0.5;
    double least_bounce_m_per_s = 0.05;  ///< slower impacts do not bounce; 0 to 100
    /// Bodies that touch are asleep when none of them has moved faster than these for `sleep_after_s`, 0 to 3600; 0: never.
    double sleep_after_s = 0.5;
    double sleep_speed_m_per_s = 2.0e-3;  ///< 0 to 1, spin times the body's radius too
    double slow_period_s =
        0.0;  ///< islands that no hand touches are stepped this seldom, 0 to 0.02; 0: each step
    /// Of bodies near each other, to 1e6; a pair with a mesh counts as eight. 0: 1024 or eight a body, whichever is more, but no more than
    /// there are. Of more the nearest count.
    int most_pairs = 0;
    int n_threads =
        1;  ///< that solve islands, the caller's among them, 1 to 16; the result is the same
    ContactSolverSettings solver{};
};

struct RigidWorldPlan {
    RigidWorldSettings settings{};
    std::vector<RigidBodyPlan> bodies;  ///< at most 10000
    std::vector<JointPlan> joints;      ///< at most 10000
};

/// What a world of this plan reserves for its bodies, pairs and solvers, no less and no more than twice; meshes and their samples come on
/// top. More than 4 GB is refused.
[[nodiscard]] double estimate_bytes(const RigidWorldPlan& plan);

/// Refuses what is out of its range, with the number of the body or joint.
[[nodiscard]] Expected<void> validate(const RigidWorldPlan& plan);

}  // namespace fulcrum
