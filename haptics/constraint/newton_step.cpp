// One step of Newton's method, and the rounds in which impulses become multipliers and the shifts follow the slip. See newton_solver.h.
#include "haptics/constraint/newton_solver.h"
#include "haptics/constraint/pair_blocks.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr int kMaxProbes = 30;  // of the line search
constexpr double kRoot = 0.1;   // slope along the step that counts as none, of the first

}  // namespace

Matrix3 NewtonSolver::compute_slope_of(const Contact& contact) const noexcept {
    const FrictionShape shape = settings_.friction_shape;
    Matrix3 slope =
        compute_projection_slope(shape, contact.friction, contact.state, contact.q, contact.p);
    if (follows(contact)) {
        // The shift turns with the slip: u + s n has the slope 1 + n s'.
        const double given = contact.softness * contact.stiffness;
        const Vector3 g = compute_lift_slope(shape, contact.friction, contact.state,
                                             contact.u + contact.softness * contact.p);
        const Vector3 turns = (g - given * slope * g) / (1.0 + given * g.dot(slope.col(0)));
        slope += Matrix3(slope.col(0) * turns.transpose());
    }
    return contact.stiffness * slope;
}

void NewtonSolver::add_contacts(const ContactProblem& problem) noexcept {
    const std::span<const ContactConstraint> all = problem.contacts();
    add_contact_blocks(
        all, matrix_, [&](std::size_t i, const Vector3& arm, PairStiffness& pair) noexcept {
            Contact& contact = contacts_[i];
            contact.built = contact.state;
            if (contact.state.pressed && !contact.state.slips) {
                pair.add(contact.stiffness, arm);
            } else if (contact.state.pressed) {
                const Matrix3& axes_W = all[i].axes_W;
                pair.add(axes_W * compute_slope_of(contact) * axes_W.transpose(), arm);
            }
        });
}

void NewtonSolver::add_rows(const ContactProblem& problem) noexcept {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        Row& row = rows_[i];
        row.built = row.side;
        if (row.free) {
            add_row_blocks(problem.rows()[i], row.stiffness, matrix_);
        }
    }
}

void NewtonSolver::build(const ContactProblem& problem) noexcept {
    const bool symmetric = std::none_of(contacts_.begin(), contacts_.end(),
                                        [&](const Contact& contact) { return follows(contact); });
    matrix_.clear(symmetric);
    add_body_blocks(problem.bodies(), matrix_);
    add_contacts(problem);
    add_rows(problem);
    built_ = true;
}

bool NewtonSolver::has_built_sets() const noexcept {
    const bool is_cone = settings_.friction_shape == FrictionShape::cone;
    return std::all_of(contacts_.begin(), contacts_.end(),
                       [&](const Contact& contact) {
                           const bool turns =
                               is_cone && contact.state.slips && contact.friction > 0.0;
                           return contact.state == contact.built && !turns;
                       }) &&
           std::all_of(rows_.begin(), rows_.end(),
                       [](const Row& row) { return row.side == row.built; });
}

void NewtonSolver::find_changes(const ContactProblem& problem) noexcept {
    pull_ = inertia_ = first_slope_ = 0.0;
    int i = 0;
    for (const ConstrainedBody& body : problem.bodies()) {
        Vector6& d = step_.velocity(i);
        d = -slope_[static_cast<std::size_t>(i)];
        const Vector6 momentum = compute_momentum(body, d);
        pull_ += momentum.dot(motion_.velocity(i) - body.free_velocity_W);
        inertia_ += momentum.dot(d);
        first_slope_ += step_.momentum(i).dot(d);
        ++i;
    }
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
        const ContactConstraint& c = problem.contacts()[k];
        contacts_[k].du =
            compute_relative_velocity(c, step_.velocity(c.body_a), step_.velocity(c.body_b));
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        const RowConstraint& r = problem.rows()[k];
        rows_[k].du =
            compute_relative_velocity(r, step_.velocity(r.body_a), step_.velocity(r.body_b));
    }
}

double NewtonSolver::compute_slope(const ContactProblem& problem, double along) noexcept {
    double slope = pull_ + along * inertia_;
    for (Contact& contact : contacts_) {
        project(contact, along);
        slope -= contact.p.dot(contact.du);
    }
    for (std::size_t k = 0; k < rows_.size(); ++k) {
        project(problem.rows()[k], rows_[k], along);
        slope -= rows_[k].p * rows_[k].du;
    }
    return slope;
}

// Where the slope was computed last.
double NewtonSolver::compute_curvature() const noexcept {
    double curvature = inertia_;
    for (const Contact& contact : contacts_) {
        if (contact.state.pressed) {
            const Matrix3 turned = compute_projection_slope(
                settings_.friction_shape, contact.friction, contact.state, contact.q, contact.p);
            curvature += contact.stiffness * contact.du.dot(turned * contact.du);
        }
    }
    for (const Row& row : rows_) {
        curvature += row.free ? row.stiffness * row.du * row.du : 0.0;
    }
    return curvature;
}

double NewtonSolver::search(const ContactProblem& problem) noexcept {
    double low = 0.0;
    double high = HUGE_VAL;
    double along = 1.0;
    for (int probe = 0; probe < kMaxProbes; ++probe) {
        const double slope = compute_slope(problem, along);
        // The whole step that changes no set is the answer of a quadratic; elsewhere the root is looked for.
        if ((probe == 0 && has_built_sets()) || std::abs(slope) <= kRoot * std::abs(first_slope_)) {
            break;
        }
        (slope < 0.0 ? low : high) = along;
        along -= slope / compute_curvature();
        if (!(along > low && along < high)) {
            along = high < HUGE_VAL ? 0.5 * (low + high) : 2.0 * low;
        }
    }
    return along;
}

double NewtonSolver::step(const ContactProblem& problem, SolveReport& report) noexcept {
    ++report.n_iterations;
    if (!built_ || !has_built_sets()) {
        build(problem);
        report.n_regularised += matrix_.factor();
    }
    const std::size_t n = problem.bodies().size();
    for (std::size_t i = 0; i < n; ++i) {
        step_.momentum(static_cast<int>(i)) = slope_[i];
    }
    matrix_.solve({slope_.data(), n});
    find_changes(problem);
    const double along = coulomb_ ? 1.0 : search(problem);
    for (int i = 0; i < static_cast<int>(n); ++i) {
        motion_.velocity(i) += along * step_.velocity(i);
    }
    return along;
}

namespace {

constexpr double kLeastStiffening = 1.0e-9;  // below it rounding of u is felt in p
constexpr double kSlowRound = 0.1;           // a round that leaves more of the residual is slow
constexpr int kMostIdle = 3;      // steps with s following that gain nothing, before it is held
constexpr int kMostAttempts = 3;  // to let s follow
constexpr double kGain = 0.5;
constexpr double kNearlySmallest = 0.1;  // E's slope against the residual when l is corrected

}  // namespace

// Something was pressed and nothing slid: what did not slip will hardly begin to, and E with its shifts held is the law itself.
bool NewtonSolver::sticks(const ContactProblem& problem) const noexcept {
    const auto contacts = problem.contacts();
    return std::any_of(contacts_.begin(), contacts_.end(),
                       [](const Contact& contact) { return contact.state.pressed; }) &&
           std::none_of(contacts.begin(), contacts.end(),
                        [](const ContactConstraint& c) { return c.slides; });
}

void NewtonSolver::start_multipliers(const ContactProblem& problem) noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        Contact& contact = contacts_[i];
        contact.now = {contact.p, problem.contacts()[i].slides ? find_lift(contact) : 0.0};
    }
    for (Row& row : rows_) {
        row.l = row.p;
    }
}

void NewtonSolver::update_multipliers() noexcept {
    for (Contact& contact : contacts_) {
        contact.now = {contact.p, find_lift(contact)};
    }
    for (Row& row : rows_) {
        row.l = row.p;
    }
}

void NewtonSolver::begin_attempt() noexcept {
    coulomb_ = true;
    n_idle_ = 0;
    ++n_attempts_;
    attempt_fits_ = HUGE_VAL;
    before_.copy_velocities(motion_, n_bodies_);
    for (Contact& contact : contacts_) {
        contact.before = contact.now;
    }
    for (Row& row : rows_) {
        row.l_before = row.l;
    }
}

void NewtonSolver::end_attempt() noexcept {
    coulomb_ = false;
    built_ = false;
    motion_.copy_velocities(before_, n_bodies_);
    for (Contact& contact : contacts_) {
        contact.now = contact.before;
    }
    for (Row& row : rows_) {
        row.l = row.l_before;
    }
}

bool NewtonSolver::correct(const ContactProblem& problem, const Fit& fit,
                           double tolerance) noexcept {
    if (coulomb_) {
        // It goes on while each few steps gain.
        const double fits = std::max(fit.residual, fit.defect);
        n_idle_ = fits < kGain * attempt_fits_ ? 0 : n_idle_ + 1;
        attempt_fits_ = std::min(attempt_fits_, fits);
        if (n_idle_ > kMostIdle) {
            end_attempt();
            return true;
        }
    }
    if (fit.defect > kNearlySmallest * std::max(fit.residual, tolerance)) {
        return false;
    }
    const bool lifts = !coulomb_ && fit.shift > kNearlySmallest * fit.residual;
    if (lifts && n_attempts_ == kMostAttempts) {
        // Impulses that fit the shift as it is are the answer when E is at its smallest.
        given_up_ = fit.defect <= kNearlySmallest * tolerance;
        return false;
    }
    update_multipliers();
    if (lifts) {
        begin_attempt();
    } else if (fit.residual > kSlowRound * residual_before_ && eps_ > kLeastStiffening) {
        set_stiffness(problem, std::max(kSlowRound * eps_, kLeastStiffening));
    }
    residual_before_ = fit.residual;
    return true;
}

}  // namespace fulcrum
