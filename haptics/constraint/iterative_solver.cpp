#include "haptics/constraint/iterative_solver.h"

#include "haptics/constraint/complementarity.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kSettled = 0.1;  // of the tolerance, a round's largest change

// Columns r x e.
Matrix3 find_lever(const Vector3& arm, const Matrix3& axes) noexcept {
    Matrix3 lever;
    for (int i = 0; i < 3; ++i) {
        lever.col(i) = arm.cross(axes.col(i));
    }
    return lever;
}

// How fast a body turns by a unit impulse along each axis.
Matrix3 find_turning(const ContactProblem& problem, int body, const Matrix3& lever) noexcept {
    return body == kGround
               ? Matrix3(Matrix3::Zero())
               : Matrix3(problem.bodies()[static_cast<std::size_t>(body)].inverse_inertia_W *
                         lever);
}

double find_inverse_mass(const ContactProblem& problem, int body) noexcept {
    return body == kGround ? 0.0 : 1.0 / problem.bodies()[static_cast<std::size_t>(body)].mass_kg;
}

}  // namespace

IterativeSolver::IterativeSolver(const ContactSolverSettings& settings,
                                 const ContactCapacity& capacity)
    : settings_(settings),
      motion_(capacity.bodies),
      contact_room_(static_cast<std::size_t>(std::max(capacity.contacts, 0))),
      rows_(static_cast<std::size_t>(std::max(capacity.rows, 0))) {}

void IterativeSolver::prepare(const ContactProblem& problem,
                              std::span<const double> friction) noexcept {
    contacts_ = {contact_room_.data(), problem.contacts().size()};
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        Contact& contact = contacts_[i];
        contact.axes_W = c.axes_W;
        contact.lever_a = find_lever(c.arm_a, c.axes_W);
        contact.lever_b = find_lever(c.arm_b, c.axes_W);
        contact.turning_a = find_turning(problem, c.body_a, contact.lever_a);
        contact.turning_b = find_turning(problem, c.body_b, contact.lever_b);
        contact.target = c.target_m_per_s;
        contact.p = c.impulse_Ns;
        contact.inverse_a = find_inverse_mass(problem, c.body_a);
        contact.inverse_b = find_inverse_mass(problem, c.body_b);
        contact.softness = c.softness_per_kg;
        contact.friction = friction[i];
        contact.body_a = c.body_a;
        contact.body_b = c.body_b;
        // W = axes^T (...) axes; of the turning part (r x e_i) . I^-1 (r x e_j).
        Matrix3 weight =
            (contact.inverse_a + contact.inverse_b + c.softness_per_kg) * Matrix3::Identity();
        weight += contact.lever_a.transpose() * contact.turning_a;
        weight += contact.lever_b.transpose() * contact.turning_b;
        contact.inverse_normal = 1.0 / weight(0, 0);
        // The larger eigenvalue: a step that is a number keeps the drag against the slip.
        const double mean = 0.5 * (weight(1, 1) + weight(2, 2));
        const double apart = 0.5 * (weight(1, 1) - weight(2, 2));
        contact.inverse_tangent =
            1.0 / (mean + std::sqrt(apart * apart + weight(1, 2) * weight(2, 1)));
    }
    prepare_rows(problem);
}

void IterativeSolver::prepare_rows(const ContactProblem& problem) noexcept {
    const std::span<const ConstrainedBody> bodies = problem.bodies();
    const auto change = [&](int body, const Vector6& jacobian) {
        return body == kGround
                   ? Vector6(Vector6::Zero())
                   : compute_velocity_change(bodies[static_cast<std::size_t>(body)], jacobian);
    };
    for (std::size_t i = 0; i < problem.rows().size(); ++i) {
        const RowConstraint& r = problem.rows()[i];
        Row& row = rows_[i];
        row.change_a = change(r.body_a, r.jacobian_a);
        row.change_b = change(r.body_b, r.jacobian_b);
        const double weight = row.change_a.dot(r.jacobian_a) + row.change_b.dot(r.jacobian_b);
        row.inverse = weight > 0.0 ? 1.0 / (weight + r.softness) : 0.0;
    }
}

double IterativeSolver::relax(Contact& contact) noexcept {
    Vector6& a = motion_.velocity(contact.body_a);
    Vector6& b = motion_.velocity(contact.body_b);
    Vector3 apart = b.head<3>() - a.head<3>();
    Vector3 spin_a = a.tail<3>();
    Vector3 spin_b = b.tail<3>();
    const auto find_slip = [&](int axis) noexcept {
        return contact.axes_W.col(axis).dot(apart) + contact.lever_b.col(axis).dot(spin_b) -
               contact.lever_a.col(axis).dot(spin_a) - contact.target[axis] +
               contact.softness * contact.p[axis];
    };
    Vector3 impulse_W = Vector3::Zero();
    const auto give = [&](int axis, double change) noexcept {
        impulse_W += change * contact.axes_W.col(axis);
        spin_a -= change * contact.turning_a.col(axis);
        spin_b += change * contact.turning_b.col(axis);
    };
    const double omega = settings_.relaxation;
    const Vector3 before = contact.p;
    // The tangents first: the normal that comes after them leaves no approach. What does not push holds nothing by friction.
    if (before.x() > 0.0 && contact.friction > 0.0) {
        const double step = omega * contact.inverse_tangent;
        const Vector3 wanted(before.x(), before.y() - step * find_slip(1),
                             before.z() - step * find_slip(2));
        contact.p = wanted;
        clamp_friction(settings_.friction_shape, contact.friction, contact.p);
        give(1, contact.p.y() - before.y());
        give(2, contact.p.z() - before.z());
        apart += (contact.inverse_a + contact.inverse_b) * impulse_W;
    }
    contact.p.x() = std::max(before.x() - omega * contact.inverse_normal * find_slip(0), 0.0);
    const Vector3 change = contact.p - before;
    if (change.isZero(0.0)) {
        return 0.0;
    }
    give(0, change.x());
    a.head<3>() -= contact.inverse_a * impulse_W;
    a.tail<3>() = spin_a;
    b.head<3>() += contact.inverse_b * impulse_W;
    b.tail<3>() = spin_b;
    return change.cwiseAbs().maxCoeff() / contact.inverse_normal;
}

double IterativeSolver::relax(RowConstraint& constraint, const Row& row) noexcept {
    if (row.inverse == 0.0) {
        return 0.0;
    }
    Vector6& a = motion_.velocity(constraint.body_a);
    Vector6& b = motion_.velocity(constraint.body_b);
    const double before = constraint.impulse;
    const double y = compute_relative_velocity(constraint, a, b) - constraint.target +
                     constraint.softness * before;
    constraint.impulse = std::clamp(before - settings_.relaxation * row.inverse * y,
                                    constraint.least, constraint.most);
    const double change = constraint.impulse - before;
    a += change * row.change_a;
    b += change * row.change_b;
    return std::abs(change) / row.inverse;
}

double IterativeSolver::sweep(ContactProblem& problem, bool backwards) noexcept {
    double most = 0.0;
    const std::size_t n_rows = problem.rows().size();
    for (std::size_t k = 0; k < n_rows; ++k) {
        const std::size_t i = backwards ? n_rows - 1 - k : k;
        most = std::max(most, relax(problem.rows()[i], rows_[i]));
    }
    const std::size_t n = contacts_.size();
    for (std::size_t k = 0; k < n; ++k) {
        most = std::max(most, relax(contacts_[backwards ? n - 1 - k : k]));
    }
    return most;
}

SolveReport IterativeSolver::solve(ContactProblem& problem, std::span<const double> friction,
                                   double tolerance) noexcept {
    for (std::size_t i = 0; i < friction.size(); ++i) {
        project_impulse(settings_.friction_shape, friction[i], problem.contacts()[i].impulse_Ns);
    }
    for (RowConstraint& row : problem.rows()) {
        row.impulse = std::clamp(row.impulse, row.least, row.most);
    }
    prepare(problem, friction);
    apply_impulses(problem, motion_);
    SolveReport report;
    double change = HUGE_VAL;
    while (report.n_iterations < settings_.max_iterations && change > kSettled * tolerance) {
        change = sweep(problem, report.n_iterations % 2 != 0);
        ++report.n_iterations;
    }
    // A contact whose normal came after its tangents, or after another's normal, may hold too much.
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
        clamp_friction(settings_.friction_shape, contacts_[i].friction, contacts_[i].p);
        problem.contacts()[i].impulse_Ns = contacts_[i].p;
    }
    apply_impulses(problem, motion_);
    report.residual_m_per_s = compute_residual(problem, settings_.friction_shape, friction);
    report.converged = report.residual_m_per_s <= tolerance;
    return report;
}

}  // namespace fulcrum
