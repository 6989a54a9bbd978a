#include "haptics/constraint/contact_problem.h"

#include "haptics/constraint/contact_motion.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// A coefficient beyond this holds as any does: nothing slips that is pressed.
constexpr double kMostFriction = 1.0e6;

std::size_t to_size(int n) {
    return static_cast<std::size_t>(std::max(n, 0));
}

bool is_finite_contact(const ContactConstraint& c) noexcept {
    return c.arm_a.allFinite() && c.arm_b.allFinite() && c.axes_W.allFinite() &&
           c.target_m_per_s.allFinite() && c.static_friction >= 0.0 && c.dynamic_friction >= 0.0 &&
           std::isfinite(c.softness_per_kg) && c.softness_per_kg >= 0.0;
}

// Of the trace: how far from symmetric rounding may leave an inertia.
constexpr double kSymmetric = 1.0e-9;

bool is_inertia(const Matrix3& I) noexcept {
    // Sylvester: positive definite where all leading minors are positive.
    const double second = I(0, 0) * I(1, 1) - I(0, 1) * I(1, 0);
    return I.allFinite() && I(0, 0) > 0.0 && second > 0.0 && I.determinant() > 0.0 &&
           (I - I.transpose()).cwiseAbs().maxCoeff() <= kSymmetric * I.trace();
}

bool is_finite_row(const RowConstraint& row) noexcept {
    return row.jacobian_a.allFinite() && row.jacobian_b.allFinite() && std::isfinite(row.target) &&
           row.least <= row.most && row.least < HUGE_VAL && row.most > -HUGE_VAL &&
           std::isfinite(row.softness) && row.softness >= 0.0;
}

}  // namespace

ContactProblem::ContactProblem(const ContactCapacity& capacity)
    : capacity_(capacity),
      bodies_(to_size(capacity.bodies)),
      contacts_(to_size(capacity.contacts)),
      rows_(to_size(capacity.rows)) {}

void ContactProblem::clear() noexcept {
    n_bodies_ = n_contacts_ = n_rows_ = 0;
    n_dropped_ = 0;
    settled_ = bounded_ = false;
}

bool ContactProblem::refuse() noexcept {
    ++n_dropped_;
    return false;
}

bool ContactProblem::is_pair(int body_a, int body_b) const noexcept {
    const int n = static_cast<int>(n_bodies_);
    return body_a != body_b && body_a >= kGround && body_b >= kGround && body_a < n && body_b < n;
}

int ContactProblem::add_body(double mass_kg, const Matrix3& inertia_W,
                             const Vector6& free_velocity_W) noexcept {
    const Matrix3 inverse = inertia_W.inverse();
    const bool is_body = mass_kg > 0.0 && std::isnormal(mass_kg) && std::isnormal(1.0 / mass_kg) &&
                         is_inertia(inertia_W) && inverse.allFinite() &&
                         free_velocity_W.allFinite();
    if (n_bodies_ == bodies_.size() || !is_body) {
        refuse();
        return kGround;
    }
    bodies_[n_bodies_] = {mass_kg, inertia_W, 0.5 * (inverse + inverse.transpose()),
                          free_velocity_W, free_velocity_W};
    return static_cast<int>(n_bodies_++);
}

bool ContactProblem::add_contact(const ContactConstraint& contact) noexcept {
    if (n_contacts_ == contacts_.size() || !is_pair(contact.body_a, contact.body_b) ||
        !is_finite_contact(contact)) {
        return refuse();
    }
    const double weight_per_kg = compute_weight(bodies(), contact);
    if (!std::isnormal(weight_per_kg)) {
        return refuse();
    }
    ContactConstraint& added = contacts_[n_contacts_++] = contact;
    added.weight_per_kg = weight_per_kg;
    added.static_friction = std::min(contact.static_friction, kMostFriction);
    added.dynamic_friction = std::min(contact.dynamic_friction, added.static_friction);
    // What is remembered is a guess: a wrong one costs time alone.
    if (!added.impulse_Ns.allFinite()) {
        added.impulse_Ns.setZero();
    }
    return true;
}

bool ContactProblem::add_row(const RowConstraint& row) noexcept {
    if (n_rows_ == rows_.size() || !is_pair(row.body_a, row.body_b) || !is_finite_row(row)) {
        return refuse();
    }
    const double weight = compute_weight(bodies(), row);
    if (weight != 0.0 && !std::isnormal(weight)) {
        return refuse();
    }
    RowConstraint& added = rows_[n_rows_++] = row;
    added.weight = weight;
    added.impulse = std::isfinite(row.impulse) ? row.impulse : 0.0;
    return true;
}

Matrix3 make_contact_axes(const Vector3& normal_W) noexcept {
    // T. Duff et al. 2017, Building an orthonormal basis, revisited, JCGT 6: one branch, on the sign of z.
    const double sign = std::copysign(1.0, normal_W.z());
    const double a = -1.0 / (sign + normal_W.z());
    const double b = normal_W.x() * normal_W.y() * a;
    Matrix3 axes;
    axes.col(0) = normal_W;
    axes.col(1) << 1.0 + sign * normal_W.x() * normal_W.x() * a, sign * b, -sign * normal_W.x();
    axes.col(2) << b, sign + normal_W.y() * normal_W.y() * a, -normal_W.y();
    return axes;
}

double compute_kinetic_energy_J(const ContactProblem& problem) noexcept {
    double twice_J = 0.0;
    for (const ConstrainedBody& body : problem.bodies()) {
        const Vector3 v = body.velocity_W.head<3>();
        const Vector3 w = body.velocity_W.tail<3>();
        twice_J += body.mass_kg * v.squaredNorm() + w.dot(body.inertia_W * w);
    }
    return 0.5 * twice_J;
}

}  // namespace fulcrum
