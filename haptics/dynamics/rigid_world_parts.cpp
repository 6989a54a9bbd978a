// How an island of rigid_world.h is solved and moved: in one step, or in parts of it where its joints turn far or something bounces.
//
// What bounces off what it does not touch yet goes there first: a part ends half of `find_bounce_gap` before they meet. The bounce has a
// part of its own, a gap's way, so that what comes after it is looked along as it goes then. What would take more than kMostBounceParts
// loses the rest. A joint's rows hold where its bodies turn little (joint.h). An island of which one turns by more goes in as many parts as keep each
// below, at most kMostParts: solved, moved, placed and touched anew each time. Others see it where it began until all islands are
// solved; then it stands where its parts led, or where it was held back on the straight way there.
#include "haptics/base/flush_to_zero.h"
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/rigid_reach.h"
#include "haptics/dynamics/rigid_world.h"
#include "haptics/math/rotation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

constexpr double kPartTurn = 0.2;  // rad
constexpr int kMostParts = 32;
// To where something bounces, and the bounce itself.
constexpr int kMostBounceParts = 8;
// rad; where joints turn by more, what their pull makes swing is followed too: h^2 K <= I / 2 (island_solver.h).
constexpr double kSwingTurn = 0.05;
constexpr double kMostSwing = 0.5;
// Of the arm: a spin about an axis that is off the anchor by less moves it little.
constexpr double kBesideAxis = 0.05;

std::size_t place_at(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

// By how much a spin turns an arm; 0 of one that lies on its axis.
double find_turn(const Vector3& spin, const Vector3& arm, double dt_s) noexcept {
    const double off_axis = spin.cross(arm).squaredNorm();
    const bool goes_round =
        off_axis > kBesideAxis * kBesideAxis * spin.squaredNorm() * arm.squaredNorm();
    return goes_round ? dt_s * compute_length(spin) : 0.0;
}

// One of a joint's bodies, or the world.
struct TurningEnd {
    Pose pose_W{};
    Vector3 spin{Vector3::Zero()};
    Vector3 velocity{Vector3::Zero()};

    [[nodiscard]] Vector3 velocity_at(const Vector3& place_W) const noexcept {
        return velocity + spin.cross(place_W - pose_W.position);
    }
};

TurningEnd find_turning_end(std::int32_t i, double dt_s, const RigidScene& scene) noexcept {
    if (i < 0) {
        return {};
    }
    const RigidWorldBody& body = scene.bodies[place_at(i)];
    const RigidState& state = body.state;
    const Vector3 gained = body.moves ? compute_spin_W(body.inertia, state.pose_W.orientation,
                                                       Vector3(dt_s * body.load_W.torque))
                                      : Vector3(Vector3::Zero());
    return {state.pose_W, state.velocity_W.angular + gained, state.velocity_W.linear};
}

// Of both bodies' arms to the place where they meet, by their own spins and by that which a motor gives one of them; of a rod its own.
double find_joint_turn(const Joint& joint, double dt_s, const RigidScene& scene) noexcept {
    const TurningEnd a = find_turning_end(joint.body_a, dt_s, scene);
    const TurningEnd b = find_turning_end(joint.body_b, dt_s, scene);
    const Vector3 at_a_W = a.pose_W * joint.frame_a.position;
    const Vector3 at_b_W = b.pose_W * joint.frame_b.position;
    const Vector3 arm_a = at_b_W - a.pose_W.position;
    const Vector3 arm_b = at_b_W - b.pose_W.position;
    double turn = 0.0;
    if (joint.kind == JointKind::distance) {
        const Vector3 rod = at_b_W - at_a_W;
        const Vector3 apart = b.velocity_at(at_b_W) - a.velocity_at(at_a_W);
        turn = dt_s * compute_length(Vector3(rod.cross(apart))) / rod.squaredNorm();
    }
    if (joint.kind == JointKind::hinge && joint.drive.motor_force > 0.0) {
        const Vector3 driven =
            joint.drive.motor_speed * ((a.pose_W * joint.frame_a).orientation * Vector3::UnitX());
        turn = std::max(joint.body_a < 0 ? 0.0 : find_turn(driven, arm_a, dt_s),
                        joint.body_b < 0 ? 0.0 : find_turn(driven, arm_b, dt_s));
    }
    return std::max({turn, find_turn(a.spin, arm_a, dt_s), find_turn(b.spin, arm_b, dt_s)});
}

// h^2 K over I of what swings fastest, about the two axes across the pull.
double find_swing(const RigidWorldBody& body, double dt_s) noexcept {
    const Matrix3 R = body.state.pose_W.orientation.toRotationMatrix();
    const Vector3 stiffness_B = (R.transpose() * body.pull_stiffness_W * R).diagonal();
    return 0.5 * dt_s * dt_s * stiffness_B.cwiseQuotient(body.inertia.moments_kg_m2).sum();
}

// Of the free turn that the momentum makes, and of what pushes.
RigidState find_moved(const RigidWorldBody& body, double dt_s) noexcept {
    const RigidState& state = body.state;
    RigidState next = state;
    const Vector3 momentum = compute_angular_momentum_W(body.inertia, state);
    const Quaternion pushed = compute_exp(dt_s * (body.drift_W.angular - state.velocity_W.angular));
    const Quaternion free =
        compute_free_turn(body.inertia, state.pose_W.orientation, momentum, dt_s);
    next.pose_W.position += dt_s * body.drift_W.linear;
    next.pose_W.orientation = pushed * free;
    // It goes with the body: a slender one that spins would get energy from what pushes it.
    next.velocity_W.angular = pushed * compute_spin_W(body.inertia, free, momentum);
    return next;
}

// Where no numbers come out the body stands still: it is seen, and all others go on.
int take_state(const RigidState& next, RigidWorldBody& body) noexcept {
    if (is_finite(next)) {
        body.state = next;
        return 0;
    }
    body.state.velocity_W = {};
    return 1;
}

void add_report(const IslandReport& part, IslandReport& whole) noexcept {
    const int n_iterations = whole.solve.n_iterations + part.solve.n_iterations;
    const int n_pivoted = whole.solve.n_pivoted + part.solve.n_pivoted;
    const bool converged = whole.solve.converged && part.solve.converged;
    if (!(part.solve.residual_m_per_s <= whole.solve.residual_m_per_s)) {
        whole.solve = part.solve;
    }
    whole.solve.n_iterations = n_iterations;
    whole.solve.n_pivoted = n_pivoted;
    whole.solve.converged = converged;
    whole.deepest_m = std::max(whole.deepest_m, part.deepest_m);
    whole.n_contacts = std::max(whole.n_contacts, part.n_contacts);
    whole.n_dropped = std::max(whole.n_dropped, part.n_dropped);
}

}  // namespace

IslandParts RigidWorld::parts_of(std::int32_t island) const noexcept {
    return {islands_.bodies(island), pairs_.group(island), joints_.group(island)};
}

// Turns that are no numbers are for the step to find.
int RigidWorld::count_parts(const DueIsland& due) const noexcept {
    double turn = 0.0;
    for (const std::int32_t i : joints_.group(due.island)) {
        turn = std::max(turn, find_joint_turn(scene_.joints[place_at(i)], due.dt_s, scene_));
    }
    double swing = 0.0;
    for (const std::int32_t i : islands_.bodies(due.island)) {
        swing = turn > kSwingTurn
                    ? std::max(swing, find_swing(scene_.bodies[place_at(i)], due.dt_s))
                    : 0.0;
    }
    // Doubled, so that the steps of what goes round evenly are even.
    int n_parts = 1;
    while ((turn > n_parts * kPartTurn || swing > n_parts * n_parts * kMostSwing) &&
           n_parts < kMostParts) {
        n_parts *= 2;
    }
    return n_parts;
}

RigidWorld::SolvedIsland RigidWorld::solve_island(const DueIsland& due,
                                                  IslandSolver& solver) noexcept {
    // On each thread alike, whatever that of the caller does.
    const ScopedFlushToZero flush_to_zero;
    const IslandParts parts = parts_of(due.island);
    const int n_parts = count_parts(due);
    if (n_parts > 1 || find_bounce_s(parts, due.dt_s) < due.dt_s) {
        return solve_in_parts(due, n_parts, solver);
    }
    return {.report = solver.solve(parts, due.dt_s, scene_)};
}

// When something is as good as where it will bounce within the time, or from there when it has bounced; the time where nothing will.
double RigidWorld::find_bounce_s(const IslandParts& parts, double time_s) const noexcept {
    double bounce_s = time_s;
    for (const std::int32_t i : parts.pairs) {
        const ContactPair& pair = scene_.pairs.at(i);
        const RigidWorldBody& first = scene_.bodies[place_at(pair.bodies.first)];
        const RigidWorldBody& second = scene_.bodies[place_at(pair.bodies.second)];
        if (!pair.is_first || !(std::max(first.restitution, second.restitution) > 0.0)) {
            continue;
        }
        const double near_m = find_bounce_gap(first, second);
        for (const ContactPoint& point : pair.manifold.points()) {
            const double speed =
                -find_apart(pair.manifold.normal_W, point.place_W, pair.meet_s, first, second);
            if (!(speed > settings_.least_bounce_m_per_s && point.gap_m <= speed * time_s)) {
                continue;
            }
            const double way_m = point.gap_m > near_m ? point.gap_m - 0.5 * near_m
                                                      : std::max(point.gap_m, 0.0) + near_m;
            bounce_s = std::min(bounce_s, way_m / speed);
        }
    }
    return bounce_s;
}

void RigidWorld::solve_part(const IslandParts& parts, double part_s, IslandSolver& solver,
                            SolvedIsland& solved) noexcept {
    double left_s = part_s;
    for (int bounce = 0; bounce < kMostBounceParts; ++bounce) {
        const double to_s = find_bounce_s(parts, left_s);
        if (!(to_s < left_s)) {
            break;
        }
        left_s -= to_s;
        add_report(solver.solve(parts, to_s, scene_), solved.report);
        solved.n_dropped += move_part(parts, to_s, left_s);
        find_first_met(parts);
        ++solved.n_parts;
    }
    // What would bounce once more goes there, and loses the rest.
    const double last_s = find_bounce_s(parts, left_s);
    solved.is_cut = solved.is_cut || last_s < left_s;
    add_report(solver.solve(parts, last_s, scene_), solved.report);
    solved.n_dropped += move_part(parts, last_s, part_s);
    find_first_met(parts);
    ++solved.n_parts;
}

// What begins to turn faster on the way goes on in smaller parts.
RigidWorld::SolvedIsland RigidWorld::solve_in_parts(const DueIsland& due, int n_parts,
                                                    IslandSolver& solver) noexcept {
    const IslandParts parts = parts_of(due.island);
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene_.bodies[place_at(i)];
        body.ends_W = body.state.pose_W;
    }
    SolvedIsland solved{.n_parts = 0};
    for (int n_left = n_parts; n_left > 0;) {
        solve_part(parts, due.dt_s / n_parts, solver, solved);
        --n_left;
        for (const int n_asked = count_parts(due); n_parts < n_asked; n_parts *= 2) {
            n_left *= 2;
        }
    }
    end_parts(parts, due.dt_s);
    return solved;
}

// And sees where it touches there, and in the next part.
int RigidWorld::move_part(const IslandParts& parts, double part_s, double next_s) noexcept {
    int n_dropped = 0;
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene_.bodies[place_at(i)];
        const RigidState before = body.state;
        n_dropped += take_state(find_moved(body, part_s), body);
        scene_.loads.carry(before, body);
        place_body(body);
        find_ahead(body, settings_.gravity_W, next_s);
    }
    std::int32_t last = -1;
    for (const std::int32_t i : parts.pairs) {
        // Of one with patches the first, which finds them all.
        const std::int32_t first = i - scene_.pairs.at(i).bodies.patch;
        if (first != last) {
            find_contacts_of(first, 2.0 * next_s);
            last = first;
        }
    }
    return n_dropped;
}

// Back to where it began, with the way from there as its drift. Its pairs have been looked at on the true way.
void RigidWorld::end_parts(const IslandParts& parts, double dt_s) noexcept {
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene_.bodies[place_at(i)];
        std::swap(body.ends_W, body.state.pose_W);
        const Quaternion turned =
            body.ends_W.orientation * body.state.pose_W.orientation.conjugate();
        body.drift_W = {(body.ends_W.position - body.state.pose_W.position) / dt_s,
                        compute_log(turned) / dt_s};
        place_body(body);
    }
    for (const std::int32_t i : parts.pairs) {
        scene_.pairs.at(i).passes = false;
    }
}

int RigidWorld::move_island(const DueIsland& due, const SolvedIsland& solved) noexcept {
    const ScopedFlushToZero flush_to_zero;
    const IslandParts parts = parts_of(due.island);
    const double goes = parts_[place_at(due.island)];
    int n_dropped = solved.n_dropped;
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene_.bodies[place_at(i)];
        if (solved.n_parts == 1) {
            n_dropped += take_state(find_moved(body, due.dt_s * goes), body);
        } else {
            const Pose began_W = body.state.pose_W;
            body.state.pose_W = body.ends_W;
            if (goes < 1.0) {
                body.state.pose_W.position =
                    began_W.position + goes * due.dt_s * body.drift_W.linear;
                body.state.pose_W.orientation =
                    compute_exp(goes * due.dt_s * body.drift_W.angular) * began_W.orientation;
            }
        }
        body.forget_loads();
    }
    rest_bodies(parts, due.dt_s);
    return n_dropped;
}

}  // namespace fulcrum
