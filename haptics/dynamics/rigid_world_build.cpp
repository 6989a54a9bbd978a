#include "haptics/base/range.h"
#include "haptics/collision/sampled_contacts.h"
#include "haptics/dynamics/hand_rows.h"
#include "haptics/dynamics/rigid_world.h"
#include "haptics/dynamics/shape_inertia.h"
#include "haptics/dynamics/unit_pose.h"
#include "haptics/math/length.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace fulcrum {
namespace {

constexpr std::size_t kMostBodies = 10000;
constexpr double kMostBytes = 4.0e9;

std::string name_of(const char* what, std::size_t i) {
    return std::string(what) + " " + std::to_string(i);
}

Expected<MeshInertia> find_inertia(const RigidBodyPlan& body) {
    return body.mass_kg > 0.0 ? compute_shape_inertia_of_mass(body.shape, body.mass_kg)
                              : compute_shape_inertia(body.shape, body.density_kg_per_m3);
}

Expected<void> check_settings(const RigidWorldSettings& settings) {
    const Range ranges[] = {
        {"gravity along x in metres per second squared", settings.gravity_W.x(), -1000.0, 1000.0},
        {"gravity along y in metres per second squared", settings.gravity_W.y(), -1000.0, 1000.0},
        {"gravity along z in metres per second squared", settings.gravity_W.z(), -1000.0, 1000.0},
        {"push rate in 1/s", settings.push_rate_per_s, 0.0, 1000.0},
        {"greatest push in metres per second", settings.most_push_m_per_s, 0.0, 100.0},
        {"least bounce in metres per second", settings.least_bounce_m_per_s, 0.0, 100.0},
        {"time before sleep in seconds", settings.sleep_after_s, 0.0, 3600.0},
        {"speed of sleep in metres per second", settings.sleep_speed_m_per_s, 0.0, 1.0},
        {"slow period in seconds", settings.slow_period_s, 0.0, 0.02},
        {"most pairs", static_cast<double>(settings.most_pairs), 0.0, 1.0e6},
        {"threads", static_cast<double>(settings.n_threads), 1.0, WorkerPool::kMostWorkers},
    };
    if (auto checked = check_ranges("the world's", ranges); !checked) {
        return checked;
    }
    return validate(settings.solver);
}

Expected<void> check_body(const RigidBodyPlan& body, const std::string& name) {
    const Range ranges[] = {
        {"static friction", body.static_friction, 0.0, 10.0},
        {"dynamic friction", body.dynamic_friction, 0.0, body.static_friction},
        {"restitution", body.restitution, 0.0, 1.0},
    };
    if (auto checked = check_ranges(name + "'s", ranges); !checked) {
        return checked;
    }
    const bool is_number = is_finite(body.pose_W) && has_turn(body.pose_W) &&
                           body.velocity_W.linear.allFinite() &&
                           body.velocity_W.angular.allFinite() && body.mass_kg >= 0.0;
    if (!is_number) {
        return fail(name + " has a pose, velocity or mass that is no number, or a turn of length 0",
                    {}, "give it finite ones");
    }
    const auto named = [&](Error error) {
        error.message = name + ": " + error.message;
        return error;
    };
    if (body.role == BodyRole::ground) {
        return {};
    }
    if (const auto shape = make_contact_shape(body.shape); !shape) {
        return tl::make_unexpected(named(shape.error()));
    }
    if (body.role == BodyRole::moves) {
        if (const auto inertia = find_inertia(body); !inertia) {
            return tl::make_unexpected(named(inertia.error()));
        }
    }
    return {};
}

RigidWorldBody make_body(const RigidBodyPlan& plan) {
    RigidWorldBody body{.shape = plan.role == BodyRole::ground
                                     ? make_half_space()
                                     : make_contact_shape(plan.shape).value(),
                        .static_friction = plan.static_friction,
                        .dynamic_friction = plan.dynamic_friction,
                        .restitution = plan.restitution,
                        .moves = plan.role == BodyRole::moves};
    if (body.moves) {
        const MeshInertia inertia = find_inertia(plan).value();
        body.inertia = inertia.inertia;
        body.X_PB = inertia.X_BP.inverse();
        body.state.velocity_W = plan.velocity_W;
    }
    body.shape.sampled = plan.role == BodyRole::ground ? nullptr : plan.sampled;
    body.lever_m = body.shape.bounding_radius_m + compute_length(body.X_PB.position);
    body.turn_PB = body.X_PB.orientation.toRotationMatrix();
    body.state.pose_W = with_unit_turn(plan.pose_W) * body.X_PB.inverse();
    body.state.pose_W.orientation.normalize();
    return body;
}

// No more than four hands on each of few bodies.
int find_most_held(const RigidWorldPlan& plan) {
    return std::min(kMostHeld, 4 * static_cast<int>(plan.bodies.size()));
}

RigidScene make_scene(const RigidWorldPlan& plan) {
    RigidScene scene{
        {}, ContactPairs(plan.settings.most_pairs), {}, BodyLoads(find_most_held(plan))};
    for (const RigidBodyPlan& body : plan.bodies) {
        scene.bodies.push_back(make_body(body));
    }
    for (const JointPlan& joint : plan.joints) {
        scene.joints.push_back(
            make_joint(joint, scene.pose_of(joint.body_a), scene.pose_of(joint.body_b)));
    }
    return scene;
}

// What a mesh meets, and what it is itself, where the plan has not made it: nothing in a world without meshes.
Expected<RigidWorldPlan> with_samples(RigidWorldPlan plan) {
    const auto is_mesh = [](const RigidBodyPlan& body) {
        return body.role != BodyRole::ground && std::holds_alternative<MeshShape>(body.shape);
    };
    if (std::ranges::none_of(plan.bodies, is_mesh)) {
        return plan;
    }
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
        RigidBodyPlan& body = plan.bodies[i];
        if (body.role == BodyRole::ground || body.sampled) {
            continue;
        }
        auto sampled = SampledShape::make(body.shape);
        if (!sampled) {
            sampled.error().message = name_of("body", i) + ": " + sampled.error().message;
            return tl::make_unexpected(sampled.error());
        }
        body.sampled = std::move(*sampled);
    }
    return plan;
}

int find_most_pairs(const RigidWorldPlan& plan) {
    if (plan.settings.most_pairs > 0) {
        return plan.settings.most_pairs;
    }
    const int n = static_cast<int>(plan.bodies.size());
    const auto n_meshes =
        static_cast<int>(std::ranges::count_if(plan.bodies, [](const RigidBodyPlan& body) {
            return std::holds_alternative<MeshShape>(body.shape);
        }));
    const int n_with_mesh = n_meshes * (n - n_meshes) + n_meshes * (n_meshes - 1) / 2;
    const int n_all = n * (n - 1) / 2 + (kMostPatches - 1) * n_with_mesh;
    return std::clamp(n_all, 1, std::max(1024, 8 * n + 8 * kMostPatches * n_meshes));
}

ContactCapacity find_capacity(const RigidWorldPlan& plan) {
    const auto n_moving = std::ranges::count(plan.bodies, BodyRole::moves,
                                             [](const auto& body) { return body.role; });
    return {.bodies = static_cast<int>(n_moving),
            .contacts = kMostContacts * find_most_pairs(plan),
            .rows = kMostJointRows * static_cast<int>(plan.joints.size()) +
                    kMostHandRows * find_most_held(plan)};
}

Expected<void> check_size(const RigidWorldPlan& plan) {
    if (plan.bodies.size() > kMostBodies || plan.joints.size() > kMostBodies) {
        return fail("a world has more than 10000 bodies or joints", {}, "make it smaller");
    }
    const double bytes = estimate_bytes(plan);
    if (bytes > kMostBytes) {
        return fail("a world of " + std::to_string(plan.bodies.size()) + " bodies and " +
                        std::to_string(find_most_pairs(plan)) + " pairs needs some " +
                        std::to_string(std::lround(bytes / 1.0e9)) +
                        " GB for its solvers, more than 4",
                    {}, "give it fewer bodies, pairs or threads, or the method newton");
    }
    return {};
}

}  // namespace

// A body's graph, order and blocks, a contact's and a row's places, the matrix of all rows that pivots are found in; and what all threads
// share of a pair. As measured, rounded up.
double estimate_bytes(const RigidWorldPlan& plan) {
    const ContactCapacity capacity = find_capacity(plan);
    const double n_bodies = capacity.bodies;
    const double n_rows = 3.0 * capacity.contacts + capacity.rows;
    const double n_pivots = std::min<double>(n_rows, kMostPivotRows);
    double solver = 0.0;
    switch (plan.settings.solver.method) {
        case ContactMethod::newton:
            solver = 5.0 * n_bodies * n_bodies + 2.15e4 * n_bodies + 2.45e3 * capacity.contacts +
                     1.15e3 * capacity.rows + 10.0 * n_pivots * n_pivots;
            break;
        case ContactMethod::dantzig:
            solver = 2.15e4 * n_bodies + 2.45e3 * capacity.contacts + 1.15e3 * capacity.rows +
                     16.0 * n_rows * n_rows;
            break;
        case ContactMethod::iterative:
            solver = 2.0e3 * n_bodies + 1.4e3 * capacity.contacts + 1.0e3 * capacity.rows;
            break;
    }
    return 1.0e5 + 950.0 * find_most_pairs(plan) + plan.settings.n_threads * solver;
}

Expected<void> validate(const RigidWorldPlan& plan) {
    if (auto checked = check_settings(plan.settings); !checked) {
        return checked;
    }
    if (auto checked = check_size(plan); !checked) {
        return checked;
    }
    for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
        if (auto checked = check_body(plan.bodies[i], name_of("body", i)); !checked) {
            return checked;
        }
    }
    const auto moves = [&](std::int32_t i) {
        return i >= 0 && plan.bodies[static_cast<std::size_t>(i)].role == BodyRole::moves;
    };
    for (std::size_t i = 0; i < plan.joints.size(); ++i) {
        const JointPlan& joint = plan.joints[i];
        const std::string name = name_of("joint", i);
        const auto n_bodies = static_cast<std::int32_t>(plan.bodies.size());
        if (auto checked = validate(joint, n_bodies, name); !checked) {
            return checked;
        }
        if (!moves(joint.body_a) && !moves(joint.body_b)) {
            return fail(name + " joins nothing that moves", {}, "join it to a body that moves");
        }
    }
    return {};
}

Expected<std::unique_ptr<RigidWorld>> RigidWorld::create(const RigidWorldPlan& plan) {
    if (const auto valid = validate(plan); !valid) {
        return tl::make_unexpected(valid.error());
    }
    return with_samples(plan).map([](RigidWorldPlan whole) {
        whole.settings.most_pairs = find_most_pairs(whole);
        return std::unique_ptr<RigidWorld>(new RigidWorld(whole));
    });
}

RigidWorld::RigidWorld(const RigidWorldPlan& plan)
    : settings_(plan.settings),
      scene_(make_scene(plan)),
      near_(plan.settings, scene_),
      ahead_(plan.settings, scene_),
      islands_(n_bodies(), plan.settings.most_pairs, static_cast<int>(plan.joints.size())),
      turns_(plan.settings, n_bodies()),
      bounds_(n_bodies()),
      pool_(plan.settings.n_threads),
      solved_(n_bodies()) {
    // One a thread: an island's answer does not depend on which.
    for (int i = 0; i < pool_.n_workers(); ++i) {
        steppers_.emplace_back(plan.settings, find_capacity(plan), ahead_);
    }
}

// Impulses are remembered; velocities and times are what they were.
void RigidWorld::prepare(double dt_s) {
    if (has_stepped_ || !(dt_s > 0.0) || !std::isfinite(dt_s)) {
        return;
    }
    std::vector<Twist> velocities_W;
    for (const RigidWorldBody& body : scene_.bodies) {
        velocities_W.push_back(body.state.velocity_W);
    }
    // What no hand touches is stepped by so much.
    const double longest_s = std::max(dt_s, settings_.slow_period_s);
    find_contacts(longest_s);
    find_islands(longest_s);
    solve_islands();
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
        RigidWorldBody& body = scene_.bodies[i];
        body.state.velocity_W = velocities_W[i];
        body.drift_W = {};
        body.behind_s = 0.0;
    }
}

}  // namespace fulcrum
