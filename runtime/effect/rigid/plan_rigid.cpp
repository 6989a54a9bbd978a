#include "runtime/effect/rigid/plan_rigid.h"

#include "haptics/collision/collision_mesh.h"
#include "haptics/dynamics/shape_inertia.h"
#include "haptics/geometry/shape.h"
#include "runtime/scene/body_shape.h"
#include "runtime/scene/shape_models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <variant>

namespace fulcrum::runtime {
namespace {

constexpr double kUsualFriction = 0.5;   // of what has no material: wood on wood
constexpr double kSlowPeriod_s = 0.01;   // of what no hand touches
constexpr std::size_t kManyBodies = 24;  // from here on a second thread pays
constexpr std::uint32_t kGripButtons = 1U;
// Of a bucket: as the model of that name is inside; outside its walls are as thick as a field of its distances can tell.
constexpr double kBucket_kg = 0.05;
constexpr double kBucketFoot = 0.75;  // of the opening's radius
constexpr double kBucketWall = 0.1;
constexpr int kBucketSides = 24;

BodyShape find_kind(const BodyDescription& body) {
    const BodyShape asked = body.collides_as;
    const BodyShape named = asked != BodyShape::model ? asked : shape_of_model(body.model);
    return named != BodyShape::model ? named : BodyShape::hull;
}

Error about(const BodyDescription& body, const Error& error) {
    return {"the " + body.noun + ": " + error.message, at_line(body.line), error.what_to_do};
}

RigidBodyPlan make_ground(const LessonDescription& lesson) {
    return {.role = BodyRole::ground,
            .pose_W = Pose::at(Vector3(0.0, lesson.ground_height_m, 0.0)),
            .static_friction = kUsualFriction,
            .dynamic_friction = kUsualFriction};
}

/// A solid of the haptic plan as the world has it: it moves, or stays where it is.
Expected<RigidBodyPlan> make_world_body(const LessonDescription& lesson, const SolidPlan& solid,
                                        const SolidLoader& load_solid) {
    const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solid.body)];
    const BodyDescription simulated = as_simulated(body);
    // What is felt as its mesh has been loaded already.
    const MeshShape* const known =
        body.felt_as == BodyShape::model ? find_mesh(solid.shape) : nullptr;
    const auto mesh = body.simulated_model.empty() && known != nullptr ? Expected<MeshShape>(*known)
                                                                       : load_solid(simulated);
    if (!mesh) {
        return tl::unexpected(mesh.error());
    }
    const auto shape = make_body_shape(find_kind(simulated), *mesh);
    if (!shape) {
        return tl::unexpected(about(body, shape.error()));
    }
    std::shared_ptr<const SampledShape> sampled;
    if (std::holds_alternative<MeshShape>(*shape)) {
        auto made = SampledShape::make(*shape);
        if (!made) {
            return tl::unexpected(about(body, made.error()));
        }
        sampled = std::move(*made);
    }
    RigidBodyPlan plan{.shape = *shape,
                       .sampled = std::move(sampled),
                       .role = body.rigid ? BodyRole::moves : BodyRole::stays,
                       .mass_kg = body.mass_kg,
                       .pose_W = solid.initial_pose_W,
                       .static_friction = kUsualFriction,
                       .dynamic_friction = kUsualFriction};
    if (body.material != kNoMaterial) {
        const FrictionSettings& felt =
            lesson.materials[static_cast<std::size_t>(body.material)].felt.friction;
        plan.static_friction = felt.static_coefficient;
        plan.dynamic_friction = std::min(felt.dynamic_coefficient, felt.static_coefficient);
    }
    RigidWorldPlan alone;
    alone.bodies = {plan};
    if (const auto good = validate(alone); !good) {
        return tl::unexpected(about(body, good.error()));
    }
    return plan;
}

JointPlan make_joint(const JointDescription& joint, std::int32_t other, std::int32_t body) {
    JointPlan plan{
        .kind = joint.kind,
        .body_a = other,
        .body_b = body,
        .anchor_W = joint.at_W,
        .other_anchor_W = joint.other_at_W,
        .axis_W = joint.axis_W,
        .drive = {
            .motor_speed = joint.speed, .motor_force = joint.force, .friction = joint.friction}};
    // Without an end it has none in the world either.
    if (joint.lowest > -kAnyTravel) {
        plan.drive.lower = joint.lowest;
    }
    if (joint.highest < kAnyTravel) {
        plan.drive.upper = joint.highest;
    }
    return plan;
}

Expected<void> add_joints(const LessonDescription& lesson, RigidLoopPlan& rigid) {
    const auto world_body_of = [&](const std::string& name) {
        for (std::size_t i = 0; i < rigid.scene_bodies.size(); ++i) {
            const std::int32_t scene = rigid.scene_bodies[i];
            if (scene >= 0 && lesson.bodies[static_cast<std::size_t>(scene)].name == name) {
                return static_cast<std::int32_t>(i);
            }
        }
        return kNoBody;
    };
    for (const BodyDescription& body : lesson.bodies) {
        if (!body.rigid || !body.rigid->joint) {
            continue;
        }
        const JointDescription& joint = *body.rigid->joint;
        rigid.world.joints.push_back(make_joint(
            joint, joint.to.empty() ? kNoBody : world_body_of(joint.to), world_body_of(body.name)));
        if (const auto good = validate(rigid.world); !good) {
            return tl::unexpected(about(body, good.error()));
        }
    }
    return {};
}

/// What is simulated of a body, and how, counts among rigid ones alone.
Expected<void> refuse_simulated(const LessonDescription& lesson) {
    if (lesson.contacts.line > 0) {
        return fail("world:contacts is for rigid bodies, and the lesson has none",
                    at_line(lesson.contacts.line), "leave it out, or make a body rigid = true");
    }
    for (const BodyDescription& body : lesson.bodies) {
        if (!body.simulated_model.empty() || body.collides_as != BodyShape::model) {
            return fail("the " + body.noun + " has a " +
                            (body.simulated_model.empty() ? "shape" : "simulated_model") +
                            ", and no body of the lesson is rigid",
                        at_line(body.line), "leave it out, or add rigid = true");
        }
    }
    return {};
}

/// With three digits, and not more than it is.
double rounded_down(double mass_kg) {
    const double last_digit = std::pow(10.0, std::floor(std::log10(mass_kg)) - 2.0);
    return std::floor(mass_kg / last_digit) * last_digit;
}

/// How the hand meets it, and what a teacher should know of that.
Expected<void> add_touch(const BodyDescription& body, const RigidBodyPlan& simulated,
                         std::size_t solid, double most_N, Plan& plan, double gravity_m_per_s2) {
    const auto inertia = compute_shape_inertia_of_mass(simulated.shape, simulated.mass_kg);
    if (!inertia) {
        return tl::unexpected(about(body, inertia.error()));
    }
    plan.haptic.rigid.push_back({solid, body.mass_kg, inertia->inertia.moments_kg_m2.maxCoeff(),
                                 plan.haptic.tool ? 0U : kGripButtons});
    const double weight_N = body.mass_kg * gravity_m_per_s2;
    if (weight_N > kWeightShareOfLimit * most_N) {
        const double liftable_N = kWeightShareOfLimit * most_N;
        char text[300];
        std::snprintf(text, sizeof(text),
                      "The %s weighs %.2f N, and a hand that may feel %.1f N lifts %.2f N at most, "
                      "so it can only be pushed; to be lifted its mass, which is %.3g kg, must be "
                      "%.3g kg at most (lesson.lua:%d).",
                      body.noun.c_str(), weight_N, most_N, liftable_N, body.mass_kg,
                      rounded_down(liftable_N / gravity_m_per_s2), body.line);
        plan.notices.emplace_back(text);
    }
    return {};
}

/// Each solid of the hand's plan, but what turns on the hand's own hinges.
Expected<void> add_world_bodies(const LessonDescription& lesson, const SolidLoader& load_solid,
                                double most_lifted_N, RigidLoopPlan& rigid, Plan& plan) {
    const double gravity = lesson.gravity_W.norm();
    for (std::size_t i = 0; i < plan.haptic.solids.size(); ++i) {
        const SolidPlan& solid = plan.haptic.solids[i];
        const BodyDescription& body = lesson.bodies[static_cast<std::size_t>(solid.body)];
        rigid.solids.push_back(kNoBody);
        if (body.hinge) {
            continue;
        }
        const auto simulated = make_world_body(lesson, solid, load_solid);
        if (!simulated) {
            return tl::unexpected(simulated.error());
        }
        const auto index = static_cast<std::int32_t>(rigid.world.bodies.size());
        rigid.world.bodies.push_back(*simulated);
        rigid.scene_bodies.push_back(body.rigid ? solid.body : kNoBody);
        if (!body.rigid) {
            continue;
        }
        rigid.solids.back() = index;
        if (!body.visible) {
            rigid.hidden.push_back(index);
        }
        plan.felt_weight_N[static_cast<std::size_t>(solid.body)] = body.mass_kg * gravity;
        if (auto good = add_touch(body, *simulated, i, most_lifted_N, plan, gravity); !good) {
            return good;
        }
    }
    return {};
}

/// A lesson's bucket among rigid bodies is one of them, which the hand holds by the middle of its rim.
Expected<void> add_bucket(const LessonDescription& lesson, RigidLoopPlan& rigid, Plan& plan) {
    const BucketDescription& bucket = lesson.bucket;
    if (plan.haptic.solids.size() == static_cast<std::size_t>(kMaxSolids)) {
        return fail("the bucket would be one rigid body too many", at_line(bucket.line),
                    "use at most " + std::to_string(kMaxSolids - 1) + " solid bodies beside it");
    }
    const double rim_m = bucket.opening_radius_m;
    const auto shape =
        make_cup(rim_m, kBucketFoot * rim_m, bucket.depth_m, kBucketWall * rim_m, kBucketSides)
            .and_then([](const TriangleMesh& cup) { return CollisionMesh::create(cup); });
    auto sampled = shape.and_then([](const MeshShape& cup) { return SampledShape::make(cup); });
    const auto inertia = sampled.and_then(
        [&](const auto& /*made*/) { return compute_shape_inertia_of_mass(*shape, kBucket_kg); });
    if (!inertia) {
        return fail("the bucket: " + inertia.error().message, at_line(bucket.line),
                    inertia.error().what_to_do);
    }
    rigid.carrier = static_cast<std::int32_t>(rigid.world.bodies.size());
    rigid.world.bodies.push_back({.shape = *shape,
                                  .sampled = std::move(*sampled),
                                  .mass_kg = kBucket_kg,
                                  .pose_W = Pose::at(lesson.hand.centre_W),
                                  .static_friction = kUsualFriction,
                                  .dynamic_friction = kUsualFriction});
    rigid.scene_bodies.push_back(kNoBody);
    rigid.solids.push_back(rigid.carrier);
    plan.haptic.rigid.push_back({.solid = plan.haptic.solids.size(),
                                 .mass_kg = kBucket_kg,
                                 .moment_kg_m2 = inertia->inertia.moments_kg_m2.maxCoeff(),
                                 .is_held = true});
    return {};
}

/// Where all that may fall into it weighs more than the hand holds up.
void tell_bucket_load(const LessonDescription& lesson, double most_N, Plan& plan) {
    double weight_N = kBucket_kg * lesson.gravity_W.norm();
    for (const BodyDescription& body : lesson.bodies) {
        weight_N += body.rigid ? body.mass_kg * lesson.gravity_W.norm() : 0.0;
    }
    if (weight_N > kWeightShareOfLimit * most_N) {
        char text[300];
        std::snprintf(text, sizeof(text),
                      "The bucket and all that may fall into it weigh %.2f N, and a hand that may "
                      "feel %.1f N holds up %.2f N at most: with more it sinks; give the bodies "
                      "less mass, or let fewer fall (lesson.lua:%d).",
                      weight_N, most_N, kWeightShareOfLimit * most_N, lesson.bucket.line);
        plan.notices.emplace_back(text);
    }
}

}  // namespace

Expected<void> add_rigid_bodies(const LessonDescription& lesson, const SolidLoader& load_solid,
                                const PlanOptions& options, Plan& plan) {
    if (std::ranges::none_of(lesson.bodies,
                             [](const BodyDescription& body) { return body.rigid.has_value(); })) {
        return refuse_simulated(lesson);
    }
    RigidLoopPlan rigid;
    rigid.world.settings.gravity_W = lesson.gravity_W;
    rigid.world.settings.slow_period_s = kSlowPeriod_s;
    rigid.world.settings.solver.method = lesson.contacts.method;
    rigid.world.settings.solver.friction_shape = lesson.contacts.friction;
    rigid.rate_hz = std::min(rigid.rate_hz, lesson.hand.rate_hz);
    rigid.world.bodies = {make_ground(lesson)};
    rigid.scene_bodies = {kNoBody};
    const double most_N = std::min(options.site.force_N, options.device_force_limit_N);
    // A hand that holds a bucket lifts nothing by itself.
    const double most_lifted_N =
        lesson.bucket.present ? std::numeric_limits<double>::infinity() : most_N;
    if (auto good = add_world_bodies(lesson, load_solid, most_lifted_N, rigid, plan); !good) {
        return good;
    }
    if (lesson.bucket.present) {
        if (auto good = add_bucket(lesson, rigid, plan); !good) {
            return good;
        }
        tell_bucket_load(lesson, most_N, plan);
    }
    if (auto good = add_joints(lesson, rigid); !good) {
        return good;
    }
    rigid.world.settings.n_threads =
        options.live && rigid.world.bodies.size() > kManyBodies ? 2 : 1;
    if (auto good = validate(rigid); !good) {
        return good;
    }
    plan.rigid = std::move(rigid);
    return {};
}

}  // namespace fulcrum::runtime
