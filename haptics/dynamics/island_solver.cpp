#include "haptics/dynamics/island_solver.h"

#include "haptics/math/dense.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fulcrum {
namespace {

// Of the smaller body's size: overlap that is left as it is, so that what rests is not pushed to and fro.
constexpr double kLeftOverlap = 1.0e-5;
// The same: a gap that is left as it is, for one that closes within the step would have to be stopped in the next.
constexpr double kLeftGap = 1.0e-7;
// Of a body's moments: a pull that turns it by no more than this within a step is followed as it is.
constexpr double kSlowTurn = 0.5;
// Of the fastest body: an answer that is off by more is sought once more in rounds.
constexpr double kBadAnswer = 1.0e-4;
constexpr int kRounds = 200;
// Of a hand's bound: what is longer by less is as long.
constexpr double kRoundedHand = 1.0e-9;
// How often joints' rows are told anew how their way bends.
constexpr int kMostBends = 4;

std::size_t index_of(std::int32_t i) noexcept {
    return static_cast<std::size_t>(i);
}

Vector6 join(const Vector3& linear, const Vector3& angular) noexcept {
    Vector6 both;
    both << linear, angular;
    return both;
}

Vector3 find_point_velocity(const RigidWorldBody& body, const Vector3& arm) noexcept {
    return body.state.velocity_W.linear + body.state.velocity_W.angular.cross(arm);
}

// w = I^-1 (L + h torque)
Vector3 find_free_spin(const RigidWorldBody& body, double dt_s) noexcept {
    const RigidState& state = body.state;
    return state.velocity_W.angular + compute_spin_W(body.inertia, state.pose_W.orientation,
                                                     Vector3(dt_s * body.load_W.torque));
}

// From the centres of mass, as they are when the bodies meet, each to its own surface: the point lies half way between.
struct ContactArms {
    Vector3 first;
    Vector3 second;
};

ContactArms find_arms(const ContactPair& pair, const ContactPoint& point,
                      const RigidWorldBody& first, const RigidWorldBody& second) noexcept {
    const auto find_arm = [&](const RigidWorldBody& body) noexcept {
        return Vector3(point.place_W - body.state.pose_W.position -
                       pair.meet_s * body.ahead_W.linear);
    };
    // Ahead, the gap holds what the way takes of it: there they are as good as together.
    const double half_m = pair.meet_s > 0.0 ? 0.0 : 0.5 * std::max(point.gap_m, 0.0);
    const Vector3 half = half_m * pair.manifold.normal_W;
    return {Vector3(find_arm(first) + half), Vector3(find_arm(second) - half)};
}

double find_contact_size(const RigidWorldBody& a, const RigidWorldBody& b) noexcept {
    const double size_a = a.shape.bounding_radius_m;
    const double size_b = b.shape.bounding_radius_m;
    return size_a > 0.0 && size_b > 0.0 ? std::min(size_a, size_b) : std::max(size_a, size_b);
}

// The positive part of h^2 K - I / 2.
Matrix3 find_pull_moment(const RigidWorldBody& body, double dt_s) noexcept {
    const Matrix3 stiff = dt_s * dt_s * body.pull_stiffness_W - kSlowTurn * body.inertia_W;
    Matrix3 moment = Matrix3::Zero();
    if (body.pull_stiffness_W.isZero(0.0)) {
        return moment;
    }
    const SymmetricAxes parts = compute_symmetric_axes_direct(stiff);
    for (int k = 0; k < 3; ++k) {
        const Vector3 axis = parts.axes.col(k);
        moment += std::max(parts.values[k], 0.0) * axis * axis.transpose();
    }
    return moment;
}

// Of the rows' impulses together; the first ones have one axis.
double find_length(std::span<const RowConstraint> rows, std::size_t n_along) noexcept {
    double along = 0.0;
    double squared = 0.0;
    for (const RowConstraint& row : rows.first(n_along)) {
        along += row.impulse;
    }
    for (const RowConstraint& row : rows.subspan(n_along)) {
        squared += row.impulse * row.impulse;
    }
    return std::sqrt(along * along + squared);
}

ContactSolverSettings in_rounds(ContactSolverSettings settings) {
    settings.method = ContactMethod::iterative;
    settings.max_iterations = std::max(settings.max_iterations, kRounds);
    return settings;
}

}  // namespace

IslandSolver::IslandSolver(const RigidWorldSettings& settings, const ContactCapacity& capacity)
    : settings_(settings),
      problem_(capacity),
      solver_(settings.solver, capacity),
      rounds_(in_rounds(settings.solver), capacity),
      impacts_(capacity),
      met_(static_cast<std::size_t>(std::max(capacity.bodies, 0)), Vector6::Zero()),
      contact_pushes_(capacity.contacts),
      row_pushes_(capacity.rows),
      contact_places_(capacity.contacts),
      row_places_(capacity.rows),
      hand_balls_(capacity.rows) {}

void IslandSolver::add_bodies(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept {
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        const Twist& velocity = body.state.velocity_W;
        const double mass_kg = body.inertia.mass_kg;
        const Vector3 load_N = mass_kg * settings_.gravity_W + body.load_W.force;
        const Vector3 linear = velocity.linear + dt_s / mass_kg * load_N;
        body.in_problem = problem_.add_body(mass_kg, body.inertia_W + find_pull_moment(body, dt_s),
                                            join(linear, find_free_spin(body, dt_s)));
    }
}

// The pair's normal goes from its second body to its first: the problem's a is the second, b the first.
void IslandSolver::add_pair(const ContactPair& pair, double dt_s,
                            const RigidScene& scene) noexcept {
    const RigidWorldBody& first = scene.body(pair.bodies.first);
    const RigidWorldBody& second = scene.body(pair.bodies.second);
    ContactConstraint contact{
        .body_a = second.moves ? second.in_problem : kGround,
        .body_b = first.moves ? first.in_problem : kGround,
        .axes_W = make_contact_axes(pair.manifold.normal_W),
        .static_friction = std::sqrt(first.static_friction * second.static_friction),
        .dynamic_friction = std::sqrt(first.dynamic_friction * second.dynamic_friction),
        .restitution = std::max(first.restitution, second.restitution)};
    const double size_m = find_contact_size(first, second);
    const double left_m = kLeftOverlap * size_m;
    const double left_gap_m = kLeftGap * size_m;
    // What does not meet first has lost its way when it comes to it: it is stopped, and bounces in a later step.
    if (!pair.is_first) {
        contact.restitution = 0.0;
    }
    for (const ContactPoint& point : pair.manifold.points()) {
        const ContactArms arms = find_arms(pair, point, first, second);
        contact.arm_a = arms.second;
        contact.arm_b = arms.first;
        const Vector3 relative =
            find_point_velocity(first, contact.arm_b) - find_point_velocity(second, contact.arm_a);
        const double arrival_m_per_s = -relative.dot(pair.manifold.normal_W);
        bounces_ = bounces_ ||
                   (contact.restitution > 0.0 && arrival_m_per_s > settings_.least_bounce_m_per_s &&
                    arrival_m_per_s * dt_s >= point.gap_m);
        contact.target_m_per_s.x() = point.gap_m > left_gap_m ? -point.gap_m / dt_s : 0.0;
        const ContactMemory* memory = pair.recall(point.id);
        contact.impulse_Ns.setZero();
        contact.slides = memory != nullptr && memory->slides;
        if (memory != nullptr) {
            contact.impulse_Ns = contact.axes_W.transpose() * memory->impulse_W;
        }
        const auto place = static_cast<std::int32_t>(problem_.contacts().size());
        const bool is_taken = problem_.add_contact(contact);
        contact_places_.add(is_taken ? place : -1);
        if (!is_taken) {
            continue;
        }
        const double depth_m = -point.gap_m - left_m;
        // What is apart is not pushed: it may go on closing.
        contact_pushes_.add(
            depth_m > 0.0 ? std::min(find_push_rate(dt_s) * depth_m, settings_.most_push_m_per_s)
                          : std::numeric_limits<double>::lowest());
        is_off_ = is_off_ || depth_m > 0.0;
        report_.deepest_m = std::max(report_.deepest_m, -point.gap_m);
        ++report_.n_contacts;
    }
}

void IslandSolver::add_hand(const BodyHold& hold, const RigidWorldBody& body,
                            double dt_s) noexcept {
    const HandRows rows = make_hand_rows(hold, body.inertia, body.state, dt_s);
    const auto first = static_cast<int>(problem_.rows().size());
    for (int row = 0; row < rows.count; ++row) {
        RowConstraint held = rows.rows[index_of(row)];
        held.body_b = body.in_problem;
        if (problem_.add_row(held)) {
            row_pushes_.add(0.0);
        }
    }
    // Where one was refused the others have bounds of their own.
    const bool is_whole = static_cast<int>(problem_.rows().size()) == first + rows.count;
    for (HandBall ball : rows.balls) {
        ball.first += first;
        if (is_whole && ball.count > 1) {
            hand_balls_.add(ball);
        }
    }
}

// True where a hand gave more than it may.
bool IslandSolver::shorten_hands() noexcept {
    bool is_shorter = false;
    for (const HandBall& ball : hand_balls_.all()) {
        const auto rows = problem_.rows().subspan(index_of(ball.first), index_of(ball.count));
        const double length = find_length(rows, index_of(ball.n_along));
        if (!(length > (1.0 + kRoundedHand) * ball.most)) {
            continue;
        }
        is_shorter = true;
        for (RowConstraint& row : rows) {
            const double most = ball.most / length * std::abs(row.impulse);
            row.least = std::max(row.least, -most);
            row.most = std::max(std::min(row.most, most), row.least);
            row.impulse = std::clamp(row.impulse, row.least, row.most);
        }
    }
    return is_shorter;
}

void IslandSolver::take_velocities(const IslandParts& parts, RigidScene& scene) noexcept {
    const auto solved = problem_.bodies();
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        if (body.in_problem != kGround) {
            const Vector6& velocity = solved[index_of(body.in_problem)].velocity_W;
            body.drift_W = {velocity.head<3>(), velocity.tail<3>()};
        }
    }
}

// Contacts and rows that were refused have no place in the problem.
void IslandSolver::remember(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept {
    const auto contacts = problem_.contacts();
    std::size_t next = 0;
    for (const std::int32_t i : parts.pairs) {
        ContactPair& pair = scene.pairs.at(i);
        pair.forget();
        for (const ContactPoint& point : pair.manifold.points()) {
            const std::int32_t place = contact_places_[next++];
            if (place >= 0) {
                const ContactConstraint& contact = contacts[index_of(place)];
                pair.remember({point.id, contact.axes_W * contact.impulse_Ns, contact.slides});
            }
        }
    }
    for (const std::int32_t i : parts.bodies) {
        scene.body(i).pull_stiffness_W.setZero();
    }
    next = 0;
    for (const std::int32_t i : parts.joints) {
        Joint& joint = scene.joint(i);
        joint.travel =
            compute_joint_travel(joint, scene.pose_of(joint.body_a), scene.pose_of(joint.body_b));
        remember_joint(next, dt_s, joint, scene);
        next += index_of(joint.n_rows);
    }
}

void IslandSolver::push(const IslandParts& parts, RigidScene& scene) noexcept {
    const auto contacts = problem_.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        double& target = contacts[i].target_m_per_s.x();
        target = std::max(target, contact_pushes_[i]);
    }
    const auto rows = problem_.rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].target += row_pushes_[i];
    }
    solve_problem();
    take_velocities(parts, scene);
}

// An answer that is off can give bodies energy. Rounds from nothing, each contact to its own answer, cannot give much.
SolveReport IslandSolver::solve_problem() noexcept {
    SolveReport report = solver_.solve(problem_);
    double fastest = 1.0;
    for (const ConstrainedBody& body : problem_.bodies()) {
        fastest = std::max(fastest, body.free_velocity_W.head<3>().norm());
    }
    // Bounded work gives none, and has no time for more.
    if (!report.converged && report.n_bounded == 0 &&
        !(report.residual_m_per_s <= kBadAnswer * fastest)) {
        for (ContactConstraint& contact : problem_.contacts()) {
            contact.impulse_Ns.setZero();
        }
        for (RowConstraint& row : problem_.rows()) {
            row.impulse = 0.0;
        }
        report = rounds_.solve(problem_);
    }
    return report;
}

void IslandSolver::solve_again() noexcept {
    const int n_before = std::exchange(report_.solve, solve_problem()).n_iterations;
    report_.solve.n_iterations += n_before;
}

bool IslandSolver::bounce(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept {
    for (const std::int32_t i : parts.bodies) {
        const RigidWorldBody& body = scene.body(i);
        if (body.in_problem != kGround) {
            met_[index_of(body.in_problem)] =
                join(body.state.velocity_W.linear, body.state.velocity_W.angular);
        }
    }
    const bool done = impacts_.solve(problem_, settings_.least_bounce_m_per_s, solver_, met_).done;
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        if (body.in_problem != kGround) {
            const Vector6& velocity = met_[index_of(body.in_problem)];
            body.state.velocity_W = {velocity.head<3>(), velocity.tail<3>()};
        }
    }
    build(parts, dt_s, scene);
    return done;
}

void IslandSolver::build(const IslandParts& parts, double dt_s, RigidScene& scene) noexcept {
    problem_.clear();
    contact_pushes_.clear();
    row_pushes_.clear();
    contact_places_.clear();
    row_places_.clear();
    hand_balls_.clear();
    report_ = {};
    is_off_ = bounces_ = false;
    add_bodies(parts, dt_s, scene);
    for (const std::int32_t i : parts.pairs) {
        add_pair(scene.pairs.at(i), dt_s, scene);
    }
    for (const std::int32_t i : parts.joints) {
        add_joint(scene.joint(i), dt_s, scene);
    }
    for (const std::int32_t i : parts.bodies) {
        const RigidWorldBody& body = scene.body(i);
        if (body.in_problem != kGround) {
            scene.loads.visit(body, [&](const BodyHold& hold) { add_hand(hold, body, dt_s); });
        }
    }
}

// The rows of all joints in turn.
bool IslandSolver::bend_joints(const IslandParts& parts, double dt_s,
                               const RigidScene& scene) noexcept {
    bool bends = false;
    std::size_t first = 0;
    for (const std::int32_t i : parts.joints) {
        const Joint& joint = scene.joint(i);
        bends = bend_joint(first, joint, dt_s, scene) || bends;
        first += index_of(joint.n_rows);
    }
    return bends;
}

IslandReport IslandSolver::solve(const IslandParts& parts, double dt_s,
                                 RigidScene& scene) noexcept {
    build(parts, dt_s, scene);
    const bool bounced = !bounces_ || bounce(parts, dt_s, scene);
    problem_.set_settled(
        std::ranges::all_of(parts.bodies, [&](std::int32_t i) { return scene.body(i).settled; }));
    // A great heap in motion is answered in bounded time; what is as slow as what sleeps rests, and that exactly.
    problem_.set_bounded(std::ranges::any_of(parts.bodies, [&](std::int32_t i) {
        return scene.body(i).state.velocity_W.linear.norm() > settings_.sleep_speed_m_per_s;
    }));
    report_.solve = solve_problem();
    if (shorten_hands()) {
        solve_again();
    }
    for (int look = 0; look < kMostBends && bend_joints(parts, dt_s, scene); ++look) {
        solve_again();
    }
    take_velocities(parts, scene);
    remember(parts, dt_s, scene);
    for (const std::int32_t i : parts.bodies) {
        RigidWorldBody& body = scene.body(i);
        body.state.velocity_W = body.drift_W;
        body.settled = report_.solve.n_iterations == 0;
    }
    if (is_off_) {
        push(parts, scene);
    }
    report_.solve.converged &= bounced;
    report_.n_dropped = problem_.n_dropped();
    return report_;
}

}  // namespace fulcrum
