#include "haptics/constraint/set_solver.h"

#include "haptics/constraint/complementarity.h"
#include "haptics/constraint/pair_blocks.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// eps: with less, rounding of u is felt in sets; with more, what leans far takes more guesses. The least is for what is near.
constexpr double kGuessCompliance = 1.0e-6;
constexpr double kLeastCompliance = 1.0e-7;
constexpr int kMostIdleGuesses = 5;
// Of the tolerance: what neither moves nor is pushed by more is pressed and sticks, for it may be as soon as anything near it is.
constexpr double kTouching = 1.0e-3;
// What is near is solved again while that gains, unless it is this much nearer (newton_solver.cpp says why).
constexpr double kWellWithin = 0.01;
constexpr double kGains = 0.5;

}  // namespace

SetSolver::SetSolver(const ContactSolverSettings& settings, const ContactCapacity& capacity)
    : shape_(settings.friction_shape),
      contact_room_(static_cast<std::size_t>(std::max(capacity.contacts, 0))),
      row_room_(static_cast<std::size_t>(std::max(capacity.rows, 0))),
      slope_(static_cast<std::size_t>(std::max(capacity.bodies, 0)), Vector6::Zero()) {}

void SetSolver::prepare(const ContactProblem& problem, std::span<const double> friction) noexcept {
    contacts_ = {contact_room_.data(), problem.contacts().size()};
    rows_ = {row_room_.data(), problem.rows().size()};
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        contacts_[i].friction = friction[i];
        // So that p = b - S u is the impulse there is.
        contacts_[i].rest = problem.contacts()[i].impulse_Ns;
        contacts_[i].slope.setZero();
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i].rest = problem.rows()[i].impulse;
        rows_[i].free = false;
    }
}

void SetSolver::set_compliance(const ContactProblem& problem, double eps) noexcept {
    eps_ = eps;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        contacts_[i].compliance = eps * c.weight_per_kg;
        contacts_[i].stiffness = 1.0 / (c.softness_per_kg + contacts_[i].compliance);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        rows_[i].compliance = eps * r.weight;
        rows_[i].stiffness = r.weight > 0.0 ? 1.0 / (r.softness + rows_[i].compliance) : 0.0;
    }
}

// Across the slip the impulse turns with it.
void SetSolver::slip_on_cone(double weight, double softness, const Vector3& t,
                             Contact& contact) const noexcept {
    const double along = std::sqrt(t.y() * t.y() + t.z() * t.z());
    const Vector3 d = along > 0.0 ? Vector3(0.0, t.y() / along, t.z() / along) : Vector3::UnitY();
    const Vector3 across(0.0, -d.z(), d.y());
    const double part = along > 0.0 ? contact.friction * t.x() / along : 0.0;
    const double turning =
        part > 0.0 ? 1.0 / ((1.0 - part) * weight / part + softness + contact.compliance) : 0.0;
    const Vector3 edge = Vector3::UnitX() + contact.friction * d;
    contact.rest = edge * contact.rest.x();
    contact.slope = turning * across * across.transpose();
    contact.slope.col(0) += contact.stiffness * edge;
}

void SetSolver::slip_on_pyramid(const Vector3& t, Contact& contact) noexcept {
    contact.slope = contact.stiffness * Matrix3::Identity();
    for (int i = 1; i < 3; ++i) {
        const double bound = std::copysign(contact.friction, t[i]);
        if (!(std::abs(t[i]) < contact.friction * t.x())) {
            contact.state.side[static_cast<std::size_t>(i - 1)] = std::signbit(t[i]) ? -1 : 1;
            contact.slope(i, i) = 0.0;
            contact.slope(i, 0) = bound * contact.stiffness;
            contact.rest[i] = bound * contact.rest.x();
        }
    }
}

void SetSolver::guess_contact(double weight, double softness, const Vector3& t,
                              Contact& contact) const noexcept {
    const double touching = touching_m_per_s_ / weight;
    contact.state = {t.x() >= -touching, false, {}};
    if (!contact.state.pressed) {
        contact.rest.setZero();
        contact.slope.setZero();
        return;
    }
    Vector3 l = contact.p;
    project_impulse(shape_, contact.friction, l);
    contact.rest = contact.stiffness * contact.compliance * l;
    const bool is_cone = shape_ == FrictionShape::cone;
    const double out = is_cone ? std::sqrt(t.y() * t.y() + t.z() * t.z())
                               : std::max(std::abs(t.y()), std::abs(t.z()));
    contact.state.slips =
        !(contact.friction > 0.0 && out <= contact.friction * std::max(t.x(), 0.0) + touching);
    if (!contact.state.slips) {
        contact.slope = contact.stiffness * Matrix3::Identity();
    } else if (is_cone) {
        slip_on_cone(weight, softness, t, contact);
    } else {
        slip_on_pyramid(t, contact);
    }
}

void SetSolver::follow(const ContactProblem& problem, const BodyMotion& motion) noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        Contact& contact = contacts_[i];
        contact.u = compute_miss(c, motion);
        contact.p = contact.rest - contact.slope * contact.u;
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        Row& row = rows_[i];
        row.u = compute_miss(r, motion);
        row.p = row.rest - (row.free ? row.stiffness * row.u : 0.0);
    }
}

double SetSolver::guess(const ContactProblem& problem) noexcept {
    double worst = 0.0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        Contact& contact = contacts_[i];
        const Vector3 y = contact.u + c.softness_per_kg * contact.p;
        worst = take_worse(
            worst, compute_residual(shape_, contact.friction, c.weight_per_kg, y, contact.p));
        guess_contact(c.weight_per_kg, c.softness_per_kg, contact.p - y / c.weight_per_kg, contact);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        Row& row = rows_[i];
        double t = row.p;
        if (r.weight > 0.0) {
            const double y = row.u + r.softness * row.p;
            worst = take_worse(worst, compute_residual(r, r.weight, y, row.p));
            t -= y / r.weight;
        }
        const double held = std::clamp(row.p, r.least, r.most);
        row.side = t > r.most ? 1 : (t < r.least ? -1 : 0);
        row.free = row.side == 0 && row.stiffness > 0.0;
        row.rest = row.free ? row.stiffness * row.compliance * held
                            : (row.side == 0 ? held : (row.side > 0 ? r.most : r.least));
    }
    return worst;
}

bool SetSolver::has_built_sets() const noexcept {
    return std::all_of(contacts_.begin(), contacts_.end(),
                       [&](const Contact& contact) {
                           const bool turns = shape_ == FrictionShape::cone &&
                                              contact.state.slips && contact.friction > 0.0;
                           return contact.state == contact.built && !turns;
                       }) &&
           std::all_of(rows_.begin(), rows_.end(),
                       [](const Row& row) { return row.side == row.built; });
}

bool SetSolver::build(const ContactProblem& problem, BlockSystem& matrix) noexcept {
    const std::span<const ContactConstraint> all = problem.contacts();
    const bool symmetric = std::none_of(
        contacts_.begin(), contacts_.end(),
        [](const Contact& contact) { return contact.state.slips && contact.friction > 0.0; });
    matrix.clear(symmetric);
    add_body_blocks(problem.bodies(), matrix);
    add_contact_blocks(all, matrix,
                       [&](std::size_t i, const Vector3& arm, PairStiffness& pair) noexcept {
                           Contact& contact = contacts_[i];
                           contact.built = contact.state;
                           if (contact.state.slips) {
                               const Matrix3& axes_W = all[i].axes_W;
                               pair.add(axes_W * contact.slope * axes_W.transpose(), arm);
                           } else if (contact.state.pressed) {
                               pair.add(contact.stiffness, arm);
                           }
                       });
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        rows_[i].built = rows_[i].side;
        if (rows_[i].free) {
            add_row_blocks(problem.rows()[i], rows_[i].stiffness, matrix);
        }
    }
    return matrix.factor() == 0;
}

// M (v - v_free) = J^T (b - S u) to the velocities where both sides are linear.
void SetSolver::move(const ContactProblem& problem, const BlockSystem& matrix,
                     BodyMotion& motion) noexcept {
    const std::size_t n = problem.bodies().size();
    motion.clear_momenta(n);
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        const Contact& contact = contacts_[i];
        if (contact.state.pressed) {
            add_impulse(c, contact.rest - contact.slope * contact.u, motion.momentum(c.body_a),
                        motion.momentum(c.body_b));
        }
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        const Row& row = rows_[i];
        add_impulse(r, row.rest - (row.free ? row.stiffness * row.u : 0.0),
                    motion.momentum(r.body_a), motion.momentum(r.body_b));
    }
    for (std::size_t i = 0; i < n; ++i) {
        const ConstrainedBody& body = problem.bodies()[i];
        const auto number = static_cast<int>(i);
        slope_[i] = compute_momentum(body, motion.velocity(number) - body.free_velocity_W) -
                    motion.momentum(number);
    }
    matrix.solve({slope_.data(), n});
    for (std::size_t i = 0; i < n; ++i) {
        motion.velocity(static_cast<int>(i)) -= slope_[i];
    }
}

void SetSolver::keep(ContactProblem& problem) const noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Vector3& p = problem.contacts()[i].impulse_Ns;
        p = contacts_[i].p;
        project_impulse(shape_, contacts_[i].friction, p);
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        RowConstraint& r = problem.rows()[i];
        r.impulse = std::clamp(rows_[i].p, r.least, r.most);
    }
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one round of guesses after the other
SetSolver::Answer SetSolver::solve(ContactProblem& problem, std::span<const double> friction,
                                   double tolerance, int most_guesses, BlockSystem& matrix,
                                   BodyMotion& motion) noexcept {
    prepare(problem, friction);
    set_compliance(problem, kGuessCompliance);
    touching_m_per_s_ = kTouching * tolerance;
    Answer answer;
    double best = HUGE_VAL;
    double before = HUGE_VAL;
    int n_idle = 0;
    bool built = false;
    while (true) {
        follow(problem, motion);
        const double residual = guess(problem);
        // Where little is left and goes slowly, what leans far is in the way.
        const bool slow = residual > kGains * before && residual <= tolerance;
        answer.found = residual <= tolerance &&
                       (residual <= kWellWithin * tolerance || (slow && eps_ == kLeastCompliance));
        // What was there before the first guess may be near, and of other sets.
        if (answer.n_guesses > 0) {
            n_idle = residual < best ? 0 : n_idle + 1;
            best = std::min(best, residual);
        }
        if (answer.found || answer.n_guesses == most_guesses || n_idle > kMostIdleGuesses ||
            !std::isfinite(residual)) {
            break;
        }
        if (slow && eps_ > kLeastCompliance) {
            set_compliance(problem, kLeastCompliance);
            (void)guess(problem);
            built = false;
        }
        built = built && has_built_sets();
        if (!built && !build(problem, matrix)) {
            break;
        }
        built = true;
        before = residual;
        ++answer.n_guesses;
        move(problem, matrix, motion);
    }
    if (answer.found) {
        keep(problem);
    }
    return answer;
}

}  // namespace fulcrum
