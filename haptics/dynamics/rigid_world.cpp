#include "haptics/dynamics/rigid_world.h"

#include "haptics/base/flush_to_zero.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/unit_pose.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

std::size_t to_index(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

}  // namespace

void RigidWorld::step(double dt_s) noexcept {
    if (!(dt_s > 0.0) || !std::isfinite(dt_s)) {
        return;
    }
    find_contacts(dt_s);
    find_islands(dt_s);
    solve_islands();
    bound_ways();
    move_islands();
    tell();
    scene_.loads.clear();
    has_stepped_ = true;
}

void RigidWorld::find_contacts(double dt_s) noexcept {
    // Within this time from now an island that waits for its turn is stepped.
    const double reach_s = std::max(settings_.slow_period_s, dt_s) + dt_s;
    near_.place(reach_s, scene_);
    near_.find(scene_);
    ahead_.find(reach_s, scene_);
}

void RigidWorld::find_islands(double dt_s) noexcept {
    islands_.find(near_.moves(), scene_);
    turns_.find(dt_s, islands_, scene_);
}

void RigidWorld::solve_islands() noexcept {
    const auto due = turns_.due();
    solved_.set_count(due.size());
    pool_.run(static_cast<int>(due.size()), [&](int i, int worker) noexcept {
        // On each thread alike, whatever that of the caller does.
        const ScopedFlushToZero flush_to_zero;
        const DueIsland& one = due[to_index(i)];
        solved_[to_index(i)] =
            steppers_[to_index(worker)].solve(islands_.parts_of(one.island), one.dt_s, scene_);
    });
}

void RigidWorld::bound_ways() noexcept {
    bounds_.find(turns_.due(), islands_, scene_, near_);
}

void RigidWorld::move_islands() noexcept {
    const auto due = turns_.due();
    pool_.run(static_cast<int>(due.size()), [&](int i, int) noexcept {
        const ScopedFlushToZero flush_to_zero;
        const DueIsland& one = due[to_index(i)];
        const IslandParts parts = islands_.parts_of(one.island);
        IslandStepper::move(parts, one.dt_s, bounds_.part_of(one.island), solved_[to_index(i)],
                            scene_);
        turns_.rest(parts, one.dt_s, scene_);
    });
}

void RigidWorld::tell() noexcept {
    report_ = {.n_islands = islands_.count(),
               .n_solved = static_cast<int>(solved_.count()),
               .n_asleep = turns_.n_asleep(),
               .n_dropped = scene_.loads.take_refused() + near_.n_dropped(),
               .n_held = bounds_.n_held()};
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
}

bool RigidWorld::may_load(std::int32_t body) const noexcept {
    return body >= 0 && body < n_bodies() && scene_.body(body).moves &&
           scene_.body(body).is_present;
}

void RigidWorld::push(std::int32_t body, const Wrench& wrench_W) noexcept {
    if (may_load(body)) {
        BodyLoads::push(wrench_W, scene_.body(body));
    }
}

void RigidWorld::hold(std::int32_t body, const BodyHold& hold) noexcept {
    if (may_load(body)) {
        scene_.loads.hold(hold, scene_.body(body));
    }
}

// What lay on it or hung from it falls.
void RigidWorld::wake_neighbours(std::int32_t body) noexcept {
    for (const Joint& joint : scene_.joints) {
        const std::int32_t other = joint.body_a == body   ? joint.body_b
                                   : joint.body_b == body ? joint.body_a
                                                          : -1;
        if (other >= 0) {
            scene_.body(other).wake();
        }
    }
    for (int i = 0; i < scene_.pairs.count(); ++i) {
        const ContactPair& pair = scene_.pairs.at(i);
        if (pair.manifold.count > 0 && (pair.bodies.first == body || pair.bodies.second == body)) {
            scene_.body(pair.bodies.first).wake();
            scene_.body(pair.bodies.second).wake();
        }
    }
}

void RigidWorld::set_present(std::int32_t body, bool is_present) noexcept {
    if (body < 0 || body >= n_bodies()) {
        return;
    }
    wake_neighbours(body);
    RigidWorldBody& one = scene_.body(body);
    one.is_present = is_present;
    one.forget_loads();
    one.touch();  // its box is made anew, and what it comes to touch wakes
}

void RigidWorld::place(std::int32_t body, const Pose& shape_W, const Twist& velocity_W) noexcept {
    const bool is_number = is_finite(shape_W) && has_turn(shape_W) &&
                           velocity_W.linear.allFinite() && velocity_W.angular.allFinite();
    if (body < 0 || body >= n_bodies() || !is_number) {
        return;
    }
    wake_neighbours(body);
    RigidWorldBody& one = scene_.body(body);
    one.state.pose_W = with_unit_turn(shape_W) * one.X_PB.inverse();
    one.state.velocity_W = one.moves ? velocity_W : Twist{};
    one.forget_loads();
    one.touch();
}

double RigidWorld::joint_travel(std::int32_t index) const noexcept {
    const Joint& joint = scene_.joint(index);
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
