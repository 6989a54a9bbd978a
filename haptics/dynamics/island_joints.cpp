// Joints in the problem of island_solver.h.
#include "haptics/dynamics/integrator.h"
#include "haptics/dynamics/island_solver.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// What a joint may be off its place, m or rad.
constexpr double kLeftError = 1.0e-7;
constexpr double kLeastLeft_s = 1.0e-4;  // in no less time: a short step would make speed of it
// rad, and a part of the anchor's arm: what turns by more within a step, about an axis that is off the anchor by more, goes no straight way.
constexpr double kFarTurn = 0.6;
constexpr double kOffAxis = 0.05;

std::size_t to_place_at(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

// One of a joint's bodies: where it is, and where a velocity leads it in the step.
struct JointEnd {
    Pose now_W{};
    Pose ahead_W{};
    Vector6 velocity = Vector6::Zero();
    int in_problem = kGround;
};

// By the problem's `velocity`: that without the joint, or the answer.
JointEnd find_joint_end(std::int32_t i, double dt_s, const RigidScene& scene,
                        std::span<const ConstrainedBody> solved,
                        Vector6 ConstrainedBody::*velocity) noexcept {
    JointEnd end;
    if (i < 0) {
        return end;
    }
    const RigidWorldBody& body = scene.body(i);
    end.now_W = end.ahead_W = body.state.pose_W;
    if (body.moves && body.in_problem != kGround) {
        end.in_problem = body.in_problem;
        end.velocity = solved[to_place_at(body.in_problem)].*velocity;
        RigidState moving = body.state;
        moving.velocity_W.angular = end.velocity.tail<3>();
        end.ahead_W.position += dt_s * end.velocity.head<3>();
        // As it will be turned: by its momentum.
        end.ahead_W.orientation =
            compute_free_turn(body.inertia, end.now_W.orientation,
                              compute_angular_momentum_W(body.inertia, moving), dt_s);
    }
    return end;
}

// Whether the anchor goes round a good part of a circle: then its way says nothing of where impulses would bring it.
bool turns_far(const JointEnd& end, const Vector3& anchor_P, double dt_s) noexcept {
    const Vector3 spin = end.velocity.tail<3>();
    const Vector3 arm = end.now_W.orientation * anchor_P;
    return dt_s * dt_s * spin.squaredNorm() > kFarTurn * kFarTurn &&
           spin.cross(arm).squaredNorm() >
               kOffAxis * kOffAxis * spin.squaredNorm() * arm.squaredNorm();
}

bool holds_both_ways(const RowConstraint& row) noexcept {
    return std::isinf(row.least) && std::isinf(row.most);
}

// At which the little that is left of error goes.
double find_left_rate(double error, double dt_s) noexcept {
    return std::clamp(error, -kLeftError, kLeftError) / std::max(dt_s, kLeastLeft_s);
}

// What does not move is shared by islands, and asks for nothing.
void add_pull(std::int32_t i, const Vector3& anchor_P, const Vector3& pull_N,
              RigidScene& scene) noexcept {
    if (i >= 0 && scene.body(i).moves) {
        RigidWorldBody& body = scene.body(i);
        const Vector3 arm = body.state.pose_W.orientation * anchor_P;
        const Matrix3 across = arm * pull_N.transpose();
        body.pull_stiffness_W +=
            arm.dot(pull_N) * Matrix3::Identity() - 0.5 * (across + across.transpose());
    }
}

}  // namespace

void IslandSolver::add_joint(const Joint& joint, double dt_s, const RigidScene& scene) noexcept {
    const auto end_of = [&](std::int32_t i) noexcept {
        return find_joint_end(i, dt_s, scene, problem_.bodies(), &ConstrainedBody::free_velocity_W);
    };
    const JointEnd a = end_of(joint.body_a);
    const JointEnd b = end_of(joint.body_b);
    JointRows rows;
    JointRows ahead;
    make_joint_rows(joint, a.now_W, b.now_W, dt_s, rows);
    make_joint_rows(joint, a.ahead_W, b.ahead_W, dt_s, ahead);
    const bool is_far =
        turns_far(a, joint.frame_a.position, dt_s) || turns_far(b, joint.frame_b.position, dt_s);
    for (int i = 0; i < rows.count; ++i) {
        RowConstraint& row = rows.rows[to_place_at(i)];
        const double error = rows.errors[to_place_at(i)];
        double push = std::abs(error) > kLeftError ? -error / dt_s : 0.0;
        if (holds_both_ways(row)) {
            // What the way bends by within the step, and the little that is left of it.
            const double straight = row.jacobian_a.dot(a.velocity) + row.jacobian_b.dot(b.velocity);
            const double bent =
                is_far ? 0.0 : (ahead.errors[to_place_at(i)] - error) / dt_s - straight;
            row.target = -bent - find_left_rate(error, dt_s);
        } else if (row.least == 0.0 || row.most == 0.0) {
            push = -error * find_push_rate(dt_s);
        }
        row.body_a = a.in_problem;
        row.body_b = b.in_problem;
        const auto place = static_cast<std::int32_t>(problem_.rows().size());
        const bool is_taken = problem_.add_row(row);
        row_places_.add(is_taken ? place : -1);
        if (!is_taken) {
            continue;
        }
        row_pushes_.add(
            std::clamp(push, -settings_.most_push_m_per_s, settings_.most_push_m_per_s));
        is_off_ = is_off_ || push != 0.0;
    }
}

// True where the answer leads the joint elsewhere than its rows were told.
bool IslandSolver::bend_joint(std::size_t first, const Joint& joint, double dt_s,
                              const RigidScene& scene) noexcept {
    const auto end_of = [&](std::int32_t i) noexcept {
        return find_joint_end(i, dt_s, scene, problem_.bodies(), &ConstrainedBody::velocity_W);
    };
    const JointEnd a = end_of(joint.body_a);
    const JointEnd b = end_of(joint.body_b);
    if (turns_far(a, joint.frame_a.position, dt_s) || turns_far(b, joint.frame_b.position, dt_s)) {
        return false;
    }
    JointRows now;
    JointRows ahead;
    make_joint_rows(joint, a.now_W, b.now_W, dt_s, now);
    make_joint_rows(joint, a.ahead_W, b.ahead_W, dt_s, ahead);
    bool bends = false;
    for (std::size_t k = 0; k < to_place_at(joint.n_rows); ++k) {
        const std::int32_t place = row_places_[first + k];
        if (place < 0 || !holds_both_ways(now.rows[k])) {
            continue;
        }
        const double beside =
            (ahead.errors[k] - now.errors[k]) / dt_s + find_left_rate(now.errors[k], dt_s);
        if (std::abs(beside) * dt_s > kLeftError) {
            problem_.rows()[to_place_at(place)].target -= beside;
            bends = true;
        }
    }
    return bends;
}

void IslandSolver::remember_joint(std::size_t first, double dt_s, Joint& joint,
                                  RigidScene& scene) noexcept {
    const auto rows = problem_.rows();
    Vector3 pull_N = Vector3::Zero();
    joint.impulses.fill(0.0);
    for (std::size_t k = 0; k < to_place_at(joint.n_rows); ++k) {
        const std::int32_t place = row_places_[first + k];
        if (place >= 0) {
            const RowConstraint& row = rows[to_place_at(place)];
            joint.impulses[k] = row.impulse;
            pull_N += row.impulse / dt_s * row.jacobian_b.head<3>();
        }
    }
    add_pull(joint.body_a, joint.frame_a.position, -pull_N, scene);
    add_pull(joint.body_b, joint.frame_b.position, pull_N, scene);
}

}  // namespace fulcrum
