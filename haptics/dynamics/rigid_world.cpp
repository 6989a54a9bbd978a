#include "haptics/dynamics/rigid_world.h"

#include "haptics/base/flush_to_zero.h"
#include "haptics/collision/sampled_contacts.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/rigid_reach.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fulcrum {
namespace {

std::size_t to_place_in(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

double find_speed(const RigidWorldBody& body, const Twist& velocity) noexcept {
    return velocity.linear.norm() + velocity.angular.norm() * body.shape.bounding_radius_m;
}
double find_speed(const RigidWorldBody& body) noexcept {
    return find_speed(body, body.state.velocity_W);
}

// Half the extent of a shape along the world's axes, about its own origin.
Vector3 find_extent(const RigidWorldBody& body) noexcept {
    const ConvexCore& core = body.shape.core;
    const Matrix3& turn = body.place.turn_WB;
    const Vector3 round = Vector3::Constant(core.radius_m);
    switch (core.kind) {
        case ConvexCore::Kind::box:
            return turn.cwiseAbs() * core.half_m;
        case ConvexCore::Kind::segment:
            return core.half_m.y() * turn.col(1).cwiseAbs() + round;
        case ConvexCore::Kind::cylinder: {
            const Vector3 across =
                (Vector3::Ones() - turn.col(1).cwiseAbs2()).cwiseMax(0.0).cwiseSqrt();
            return core.half_m.y() * turn.col(1).cwiseAbs() + core.half_m.x() * across;
        }
        case ConvexCore::Kind::cloud:
            return Vector3::Constant(body.shape.bounding_radius_m);
        default:
            return round;
    }
}

Box find_box(const RigidWorldBody& body) noexcept {
    if (!body.is_present) {
        constexpr double kNowhere = std::numeric_limits<double>::max();
        return {Vector3::Constant(kNowhere), Vector3::Constant(kNowhere)};
    }
    if (body.shape.kind == ContactShape::Kind::half_space) {
        constexpr double kNoEnd = std::numeric_limits<double>::infinity();
        Box box{Vector3::Constant(-kNoEnd), Vector3::Constant(kNoEnd)};
        // Level ground ends at its plane: what is high above is not near it.
        if (body.place.turn_WB(1, 1) >= 1.0) {
            box.upper.y() = body.place.position_W.y() + body.reach_m;
        }
        return box;
    }
    const Vector3 half = find_extent(body) + Vector3::Constant(body.reach_m);
    return {body.place.position_W - half, body.place.position_W + half};
}

bool is_still(const RigidWorldBody& body) noexcept {
    return (body.asleep || !body.moves) && !body.touched;
}

}  // namespace

void RigidWorld::place_bodies(double reach_s) noexcept {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
        RigidWorldBody& body = scene_.bodies[i];
        if (is_still(body) && n_steps_ > 0) {
            continue;
        }
        place_body(body);
        find_reach(body, settings_.gravity_W, reach_s);
        boxes_[i] = find_box(body);
        reaches_m_[i] = body.reach_m;
    }
}

bool RigidWorld::is_joined(const BodyPair& pair) const noexcept {
    return !joined_.empty() && std::binary_search(joined_.begin(), joined_.end(), pair);
}

bool RigidWorld::meets_in_patches(const BodyPair& pair) const noexcept {
    const ContactShape& first = scene_.bodies[to_place_in(pair.first)].shape;
    const ContactShape& second = scene_.bodies[to_place_in(pair.second)].shape;
    constexpr auto kMesh = ContactShape::Kind::mesh;
    return (first.kind == kMesh || second.kind == kMesh) && first.sampled && second.sampled;
}

void RigidWorld::add_near(BodyPair pair) noexcept {
    const int n = meets_in_patches(pair) ? kMostPatches : 1;
    for (pair.patch = 0; pair.patch < n; ++pair.patch) {
        report_.n_dropped += near_.add(pair) ? 0 : 1;
    }
}

// Where the pair touches, and of one with patches in those that follow as well.
void RigidWorld::find_contacts_of(int i, double reach_s) noexcept {
    ContactPair& pair = scene_.pairs.at(i);
    if (meets_in_patches(pair.bodies)) {
        look_ahead_in_patches(i, reach_s);
    } else {
        look_ahead(pair, reach_s);
    }
}

void RigidWorld::find_touching(double reach_s) noexcept {
    near_.clear();
    for (const BodyPair& pair :
         broad_phase_.find_pairs(boxes_.all(), moves_.all(), reaches_m_.all())) {
        if (!is_joined(pair)) {
            add_near(pair);
        }
    }
    report_.n_dropped += broad_phase_.n_dropped();
    scene_.pairs.update(near_.all());
    for (int i = 0; i < scene_.pairs.count(); ++i) {
        ContactPair& pair = scene_.pairs.at(i);
        RigidWorldBody& first = scene_.bodies[to_place_in(pair.bodies.first)];
        RigidWorldBody& second = scene_.bodies[to_place_in(pair.bodies.second)];
        // Those that sleep touch where they did.
        if (pair.bodies.patch == 0 && (!is_still(first) || !is_still(second))) {
            find_contacts_of(i, reach_s);
        }
        // What was moved by a command wakes what it touches, though it makes no island with it.
        if (pair.manifold.count > 0 && (first.touched || second.touched)) {
            first.wake();
            second.wake();
        }
    }
    find_first_met();
    for (RigidWorldBody& body : scene_.bodies) {
        body.touched = body.touched && body.moves;
    }
}

void RigidWorld::find_islands() noexcept {
    islands_.begin(moves_.all());
    for (int i = 0; i < scene_.pairs.count(); ++i) {
        const ContactPair& pair = scene_.pairs.at(i);
        if (pair.manifold.count > 0) {
            islands_.link(pair.bodies.first, pair.bodies.second);
        }
    }
    const auto holds = [&](const Joint& joint) noexcept {
        const auto is_there = [&](std::int32_t i) noexcept {
            return i < 0 || scene_.bodies[to_place_in(i)].is_present;
        };
        return is_there(joint.body_a) && is_there(joint.body_b);
    };
    for (const Joint& joint : scene_.joints) {
        if (holds(joint)) {
            islands_.link(joint.body_a, joint.body_b);
        }
    }
    islands_.finish();
    const auto island_of = [&](std::int32_t a, std::int32_t b) noexcept {
        return std::max(islands_.island_of(a), islands_.island_of(b));
    };
    // Those that pass each other are looked at again where their island goes in parts, unless each is in one of its own.
    const auto may_meet = [&](const ContactPair& pair, int i) noexcept {
        const std::int32_t first = islands_.island_of(pair.bodies.first);
        const std::int32_t second = islands_.island_of(pair.bodies.second);
        return scene_.pairs.at(i - pair.bodies.patch).passes &&
               (first == second || first < 0 || second < 0);
    };
    island_of_pair_.clear();
    for (int i = 0; i < scene_.pairs.count(); ++i) {
        const ContactPair& pair = scene_.pairs.at(i);
        const bool is_part = pair.manifold.count > 0 || may_meet(pair, i);
        island_of_pair_.add(is_part ? island_of(pair.bodies.first, pair.bodies.second) : -1);
    }
    pairs_.sort(island_of_pair_.all(), islands_.count());
    island_of_joint_.clear();
    for (const Joint& joint : scene_.joints) {
        island_of_joint_.add(holds(joint) ? island_of(joint.body_a, joint.body_b) : -1);
    }
    joints_.sort(island_of_joint_.all(), islands_.count());
    report_.n_islands = islands_.count();
}

// One that is awake wakes all.
bool RigidWorld::wake_island(std::span<const std::int32_t> bodies) noexcept {
    const bool is_awake = std::ranges::any_of(
        bodies, [&](std::int32_t i) { return !scene_.bodies[to_place_in(i)].asleep; });
    for (const std::int32_t i : bodies) {
        RigidWorldBody& body = scene_.bodies[to_place_in(i)];
        if (is_awake && body.asleep) {
            body.wake();
        }
    }
    return is_awake;
}

bool RigidWorld::may_rest(const IslandParts& parts) const noexcept {
    const auto is_driven = [&](std::int32_t i) {
        const JointDrive& drive = scene_.joints[to_place_in(i)].drive;
        return drive.motor_force > 0.0 && drive.motor_speed != 0.0;
    };
    const bool touches = std::ranges::any_of(
        parts.pairs, [&](std::int32_t i) { return scene_.pairs.at(i).manifold.count > 0; });
    return settings_.sleep_after_s > 0.0 && (touches || !parts.joints.empty()) &&
           std::ranges::none_of(parts.joints, is_driven);
}

void RigidWorld::rest_bodies(const IslandParts& parts, double dt_s) noexcept {
    double least_s = std::numeric_limits<double>::infinity();
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene_.bodies[to_place_in(i)];
        const double speed = std::max(find_speed(body), find_speed(body, body.drift_W));
        const bool is_slow = !body.touched && speed <= settings_.sleep_speed_m_per_s;
        body.still_s = is_slow ? body.still_s + dt_s : 0.0;
        body.touched = false;
        least_s = std::min(least_s, body.still_s);
    }
    if (may_rest(parts) && least_s >= settings_.sleep_after_s) {
        for (const std::int32_t i : parts.bodies) {
            scene_.bodies[to_place_in(i)].asleep = true;
            scene_.bodies[to_place_in(i)].state.velocity_W = {};
        }
    }
}

// What moves all, without moving it.
void RigidWorld::solve_all(double dt_s) noexcept {
    const double slow_s = std::max(settings_.slow_period_s, dt_s) + dt_s;
    place_bodies(slow_s);
    find_touching(slow_s);
    find_islands();
    find_due(dt_s);
    solved_.set_count(due_.count());
    pool_.run(static_cast<int>(due_.count()), [this](int i, int worker) noexcept {
        solved_[to_place_in(i)] = solve_island(due_[to_place_in(i)], solvers_[to_place_in(worker)]);
    });
}

// Impulses are remembered; velocities and times are what they were.
void RigidWorld::prepare(double dt_s) noexcept {
    if (n_steps_ > 0 || !(dt_s > 0.0) || !std::isfinite(dt_s)) {
        return;
    }
    for (RigidWorldBody& body : scene_.bodies) {
        body.way_W = body.state.velocity_W;
    }
    // What no hand touches is stepped by so much.
    solve_all(std::max(dt_s, settings_.slow_period_s));
    for (RigidWorldBody& body : scene_.bodies) {
        body.state.velocity_W = body.way_W;
        body.drift_W = body.way_W = {};
        body.behind_s = 0.0;
    }
    report_ = {};
}

void RigidWorld::step(double dt_s) noexcept {
    if (!(dt_s > 0.0) || !std::isfinite(dt_s)) {
        return;
    }
    report_ = {.n_dropped = scene_.loads.take_refused()};
    solve_all(dt_s);
    hold_back();
    pool_.run(static_cast<int>(due_.count()), [this](int i, int) noexcept {
        SolvedIsland& solved = solved_[to_place_in(i)];
        solved.n_dropped = move_island(due_[to_place_in(i)], solved);
    });
    report_.n_solved = static_cast<int>(due_.count());
    for (const SolvedIsland& one : solved_.all()) {
        report_.n_contacts += one.report.n_contacts;
        report_.n_held += one.is_cut ? 1 : 0;
        report_.n_in_parts += one.n_parts > 1 ? 1 : 0;
        report_.n_dropped += one.report.n_dropped + one.n_dropped;
        report_.n_iterations += one.report.solve.n_iterations;
        report_.n_pivoted += one.report.solve.n_pivoted;
        report_.n_unconverged += one.report.solve.converged ? 0 : 1;
        report_.deepest_m = std::max(report_.deepest_m, one.report.deepest_m);
        report_.residual_m_per_s =
            std::max(report_.residual_m_per_s, one.report.solve.residual_m_per_s);
    }
    scene_.loads.clear();
    ++n_steps_;
}

// Which islands are stepped now, and by how much: what a hand touches at once, the others when enough time has come together. Those that
// have just met have not waited equally long: the least counts, and the rest is dropped.
void RigidWorld::find_due(double dt_s) noexcept {
    due_.clear();
    for (std::int32_t island = 0; island < islands_.count(); ++island) {
        const auto bodies = islands_.bodies(island);
        if (!wake_island(bodies)) {
            report_.n_asleep += static_cast<int>(bodies.size());
            continue;
        }
        bool is_touched = false;
        double behind_s = std::numeric_limits<double>::infinity();
        for (const std::int32_t i : bodies) {
            RigidWorldBody& body = scene_.bodies[to_place_in(i)];
            body.behind_s += dt_s;
            behind_s = std::min(behind_s, body.behind_s);
            is_touched = is_touched || body.touched;
        }
        // Half a step for rounding.
        if (is_touched || behind_s + 0.5 * dt_s >= settings_.slow_period_s) {
            due_.add({island, behind_s});
        }
    }
}

double RigidWorld::joint_travel(std::int32_t index) const noexcept {
    const Joint& joint = scene_.joints[to_place_in(index)];
    return compute_joint_travel(joint, scene_.pose_of(joint.body_a), scene_.pose_of(joint.body_b));
}

double RigidWorld::compute_energy_J() const noexcept {
    double energy_J = 0.0;
    for (const RigidWorldBody& body : scene_.bodies) {
        if (body.moves) {
            energy_J += compute_kinetic_energy_J(body.inertia, body.state) -
                        body.inertia.mass_kg * settings_.gravity_W.dot(body.state.pose_W.position);
        }
    }
    return energy_J;
}

}  // namespace fulcrum
