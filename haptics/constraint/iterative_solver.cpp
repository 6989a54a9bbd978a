#include "haptics/constraint/iterative_solver.h"

#include "haptics/constraint/complementarity.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double kSettled = 0.1;  // of the tolerance, a round's largest change

// How fast a body turns by a unit impulse along each axis at the arm.
Matrix3 find_turning(const ContactProblem& problem, int body, const Vector3& arm,
                     const Matrix3& axes) noexcept {
    if (body == kGround) {
        return Matrix3::Zero();
    }
    Matrix3 moments;
    for (int i = 0; i < 3; ++i) {
        moments.col(i) = arm.cross(axes.col(i));
    }
    return problem.bodies()[static_cast<std::size_t>(body)].inverse_inertia_W * moments;
}

double find_inverse_mass(const ContactProblem& problem, int body) noexcept {
    return body == kGround ? 0.0 : 1.0 / problem.bodies()[static_cast<std::size_t>(body)].mass_kg;
}

}  // namespace

IterativeSolver::IterativeSolver(const ContactSolverSettings& settings,
                                 const ContactCapacity& capacity)
    : settings_(settings),
      motion_(capacity.bodies),
      contacts_(static_cast<std::size_t>(std::max(capacity.contacts, 0))),
      rows_(static_cast<std::size_t>(std::max(capacity.rows, 0))) {}

void IterativeSolver::prepare(const ContactProblem& problem) noexcept {
    for (std::size_t i = 0; i < problem.contacts().size(); ++i) {
        const ContactConstraint& c = problem.contacts()[i];
        Contact& contact = contacts_[i];
        contact.turning_a = find_turning(problem, c.body_a, c.arm_a, c.axes_W);
        contact.turning_b = find_turning(problem, c.body_b, c.arm_b, c.axes_W);
        contact.inverse_a = find_inverse_mass(problem, c.body_a);
        contact.inverse_b = find_inverse_mass(problem, c.body_b);
        // W = axes^T (...) axes; of the turning part (r x e_i) . I^-1 (r x e_j).
        Matrix3 weight =
            (contact.inverse_a + contact.inverse_b + c.softness_per_kg) * Matrix3::Identity();
        for (int k = 0; k < 3; ++k) {
            weight.col(k) += c.axes_W.transpose() * (contact.turning_a.col(k).cross(c.arm_a) +
                                                     contact.turning_b.col(k).cross(c.arm_b));
        }
        contact.inverse_normal = 1.0 / weight(0, 0);
        // The larger eigenvalue: a step that is a number keeps the drag against the slip.
        const double mean = 0.5 * (weight(1, 1) + weight(2, 2));
        const double apart = 0.5 * (weight(1, 1) - weight(2, 2));
        contact.inverse_tangent =
            1.0 / (mean + std::sqrt(apart * apart + weight(1, 2) * weight(2, 1)));
    }
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

double IterativeSolver::relax(ContactConstraint& constraint, const Contact& contact,
                              double friction) noexcept {
    Vector6& a = motion_.velocity(constraint.body_a);
    Vector6& b = motion_.velocity(constraint.body_b);
    const Matrix3& axes = constraint.axes_W;
    Vector3& p = constraint.impulse_Ns;
    const auto give = [&](const Vector3& change) {
        const Vector3 impulse_W = axes * change;
        a.head<3>() -= contact.inverse_a * impulse_W;
        a.tail<3>() -= contact.turning_a * change;
        b.head<3>() += contact.inverse_b * impulse_W;
        b.tail<3>() += contact.turning_b * change;
    };
    const double omega = settings_.relaxation;
    const Vector3 before = p;
    // The tangents first: the normal that comes after them leaves no approach.
    Vector3 y = compute_relative_velocity(constraint, a, b) - constraint.target_m_per_s +
                constraint.softness_per_kg * p;
    p.tail<2>() -= omega * (contact.inverse_tangent * y.tail<2>());
    clamp_friction(settings_.friction_shape, friction, p);
    give(p - before);
    const double held = p.x();
    y = compute_relative_velocity(constraint, a, b) - constraint.target_m_per_s +
        constraint.softness_per_kg * p;
    p.x() = std::max(held - omega * contact.inverse_normal * y.x(), 0.0);
    give({p.x() - held, 0.0, 0.0});
    return (p - before).cwiseAbs().maxCoeff() / contact.inverse_normal;
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

double IterativeSolver::sweep(ContactProblem& problem, std::span<const double> friction,
                              bool backwards) noexcept {
    double most = 0.0;
    const std::size_t n_rows = problem.rows().size();
    for (std::size_t k = 0; k < n_rows; ++k) {
        const std::size_t i = backwards ? n_rows - 1 - k : k;
        most = std::max(most, relax(problem.rows()[i], rows_[i]));
    }
    const std::size_t n = problem.contacts().size();
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = backwards ? n - 1 - k : k;
        most = std::max(most, relax(problem.contacts()[i], contacts_[i], friction[i]));
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
    prepare(problem);
    apply_impulses(problem, motion_);
    SolveReport report;
    double change = HUGE_VAL;
    while (report.n_iterations < settings_.max_iterations && change > kSettled * tolerance) {
        change = sweep(problem, friction, report.n_iterations % 2 != 0);
        ++report.n_iterations;
    }
    // A contact whose normal came after its tangents, or after another's normal, may hold too much.
    for (std::size_t i = 0; i < friction.size(); ++i) {
        clamp_friction(settings_.friction_shape, friction[i], problem.contacts()[i].impulse_Ns);
    }
    apply_impulses(problem, motion_);
    report.residual_m_per_s = compute_residual(problem, settings_.friction_shape, friction);
    report.converged = report.residual_m_per_s <= tolerance;
    return report;
}

}  // namespace fulcrum
