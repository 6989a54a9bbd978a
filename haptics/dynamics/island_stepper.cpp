#include "haptics/dynamics/island_stepper.h"

#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/rigid_reach.h"
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
    const RigidWorldBody& body = scene.body(i);
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

// Turns that are no numbers are for the step to find.
int count_parts(const IslandParts& parts, double dt_s, const RigidScene& scene) noexcept {
    double turn = 0.0;
    for (const std::int32_t i : parts.joints) {
        turn = std::max(turn, find_joint_turn(scene.joint(i), dt_s, scene));
    }
    double swing = 0.0;
    for (const std::int32_t i : parts.bodies) {
        swing = turn > kSwingTurn ? std::max(swing, find_swing(scene.body(i), dt_s)) : 0.0;
    }
    // Doubled, so that the steps of what goes round evenly are even.
    int n_parts = 1;
    while ((turn > n_parts * kPartTurn || swing > n_parts * n_parts * kMostSwing) &&
           n_parts < kMostParts) {
        n_parts *= 2;
    }
    return n_parts;
}

// Back to where it began, with the way from there as its drift. Its pairs have been looked at on the true way.
void end_parts(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept {
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        std::swap(body.ends_W, body.state.pose_W);
        const Quaternion turned =
            body.ends_W.orientation * body.state.pose_W.orientation.conjugate();
        body.drift_W = {(body.ends_W.position - body.state.pose_W.position) / dt_s,
                        compute_log(turned) / dt_s};
        place_body(body);
    }
    for (const std::int32_t i : parts.pairs) {
        scene.pairs.at(i).passes = false;
    }
}

}  // namespace

SolvedIsland IslandStepper::solve(const IslandParts& parts, double dt_s,
                                  RigidScene& scene) noexcept {
    const int n_parts = count_parts(parts, dt_s, scene);
    if (n_parts > 1 || find_bounce_s(parts, dt_s, scene) < dt_s) {
        return solve_in_parts(parts, dt_s, n_parts, scene);
    }
    return {.report = solver_.solve(parts, dt_s, scene)};
}

// When something is as good as where it will bounce within the time, or from there when it has bounced; the time where nothing will.
double IslandStepper::find_bounce_s(const IslandParts& parts, double time_s,
                                    const RigidScene& scene) const noexcept {
    double bounce_s = time_s;
    for (const std::int32_t i : parts.pairs) {
        const ContactPair& pair = scene.pairs.at(i);
        const RigidWorldBody& first = scene.body(pair.bodies.first);
        const RigidWorldBody& second = scene.body(pair.bodies.second);
        if (!pair.is_first || !(std::max(first.restitution, second.restitution) > 0.0)) {
            continue;
        }
        const double near_m = find_bounce_gap(first, second);
        for (const ContactPoint& point : pair.manifold.points()) {
            const double speed =
                -find_apart(pair.manifold.normal_W, point.place_W, pair.meet_s, first, second);
            if (!(speed > least_bounce_m_per_s_ && point.gap_m <= speed * time_s)) {
                continue;
            }
            const double way_m = point.gap_m > near_m ? point.gap_m - 0.5 * near_m
                                                      : std::max(point.gap_m, 0.0) + near_m;
            bounce_s = std::min(bounce_s, way_m / speed);
        }
    }
    return bounce_s;
}

void IslandStepper::solve_part(const IslandParts& parts, double part_s, RigidScene& scene,
                               SolvedIsland& solved) noexcept {
    double left_s = part_s;
    for (int bounce = 0; bounce < kMostBounceParts; ++bounce) {
        const double to_s = find_bounce_s(parts, left_s, scene);
        if (!(to_s < left_s)) {
            break;
        }
        left_s -= to_s;
        go(parts, to_s, left_s, scene, solved);
    }
    // What would bounce once more goes there, and loses the rest.
    const double last_s = find_bounce_s(parts, left_s, scene);
    solved.is_cut = solved.is_cut || last_s < left_s;
    go(parts, last_s, part_s, scene, solved);
}

// What begins to turn faster on the way goes on in smaller parts.
SolvedIsland IslandStepper::solve_in_parts(const IslandParts& parts, double dt_s, int n_parts,
                                           RigidScene& scene) noexcept {
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        body.ends_W = body.state.pose_W;
    }
    SolvedIsland solved{.n_parts = 0};
    for (int n_left = n_parts; n_left > 0;) {
        solve_part(parts, dt_s / n_parts, scene, solved);
        --n_left;
        for (const int n_asked = count_parts(parts, dt_s, scene); n_parts < n_asked; n_parts *= 2) {
            n_left *= 2;
        }
    }
    end_parts(parts, dt_s, scene);
    return solved;
}

// A part, and sees where it touches there, and in the next one.
void IslandStepper::go(const IslandParts& parts, double part_s, double next_s, RigidScene& scene,
                       SolvedIsland& solved) noexcept {
    add_report(solver_.solve(parts, part_s, scene), solved.report);
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        const RigidState before = body.state;
        solved.n_dropped += take_state(find_moved(body, part_s), body);
        scene.loads.carry(before, body);
        place_body(body);
        find_ahead(body, gravity_W_, next_s);
    }
    ahead_->find_of(parts, 2.0 * next_s, scene);
    ++solved.n_parts;
}

void IslandStepper::move(const IslandParts& parts, double dt_s, double goes, SolvedIsland& solved,
                         RigidScene& scene) noexcept {
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        if (solved.n_parts == 1) {
            solved.n_dropped += take_state(find_moved(body, dt_s * goes), body);
        } else {
            const Pose began_W = body.state.pose_W;
            body.state.pose_W = body.ends_W;
            if (goes < 1.0) {
                body.state.pose_W.position = began_W.position + goes * dt_s * body.drift_W.linear;
                body.state.pose_W.orientation =
                    compute_exp(goes * dt_s * body.drift_W.angular) * began_W.orientation;
            }
        }
        body.forget_loads();
    }
}

}  // namespace fulcrum
