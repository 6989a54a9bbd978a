// How the bodies of a problem move, and what an impulse at a contact or in a row does to them.
//
// The ground has a place among the bodies, the first, so that no loop asks for it: nothing moves it, and what is pushed into
// it is forgotten. Weights say how much a unit impulse moves a constraint, so that impulses and velocities compare:
//   contact   trace of J M^-1 J^T = 3/m_a + 3/m_b + sum over both of  tr(I^-1) |r|^2 - r . I^-1 r
//   row       J M^-1 J^T
//
// Thread: that of the solver. Cost: some 30 multiplications a constraint.
#pragma once

#include "haptics/constraint/contact_constraint.h"

#include <algorithm>
#include <span>
#include <vector>

namespace fulcrum {

/// Velocities and momenta of all bodies; index with a body's number or kGround.
class BodyMotion {
  public:
    explicit BodyMotion(int max_bodies)
        : velocities_(static_cast<std::size_t>(std::max(max_bodies, 0)) + 1, Vector6::Zero()),
          momenta_(velocities_) {}

    [[nodiscard]] Vector6& velocity(int body) noexcept { return velocities_[slot_of(body)]; }
    [[nodiscard]] const Vector6& velocity(int body) const noexcept {
        return velocities_[slot_of(body)];
    }
    [[nodiscard]] Vector6& momentum(int body) noexcept { return momenta_[slot_of(body)]; }

    /// Momenta of the first `n_bodies` bodies and of the ground become zero, and the ground stands.
    void clear_momenta(std::size_t n_bodies) noexcept {
        velocities_.front().setZero();
        std::fill_n(momenta_.begin(), n_bodies + 1, Vector6::Zero());
    }

    void copy_velocities(const BodyMotion& from, std::size_t n_bodies) noexcept {
        std::copy_n(from.velocities_.begin(), n_bodies + 1, velocities_.begin());
    }

  private:
    static std::size_t slot_of(int body) noexcept { return static_cast<std::size_t>(body) + 1; }
    std::vector<Vector6> velocities_;  // m/s and rad/s; the first is the ground's
    std::vector<Vector6> momenta_;     // N s and N m s that impulses gave
};

/// M^-1 times a momentum.
inline Vector6 compute_velocity_change(const ConstrainedBody& body,
                                       const Vector6& momentum) noexcept {
    Vector6 change;
    change.head<3>() = momentum.head<3>() / body.mass_kg;
    change.tail<3>() = body.inverse_inertia_W * momentum.tail<3>();
    return change;
}
/// M times a velocity.
inline Vector6 compute_momentum(const ConstrainedBody& body, const Vector6& velocity) noexcept {
    Vector6 momentum;
    momentum.head<3>() = body.mass_kg * velocity.head<3>();
    momentum.tail<3>() = body.inertia_W * velocity.tail<3>();
    return momentum;
}

/// Velocity of the point of b over that of a, along the axes, m/s.
inline Vector3 compute_relative_velocity(const ContactConstraint& contact, const Vector6& a,
                                         const Vector6& b) noexcept {
    const Vector3 linear = b.head<3>() - a.head<3>();
    const Vector3 velocity_W =
        linear + b.tail<3>().cross(contact.arm_b) - a.tail<3>().cross(contact.arm_a);
    return contact.axes_W.transpose() * velocity_W;
}
inline double compute_relative_velocity(const RowConstraint& row, const Vector6& a,
                                        const Vector6& b) noexcept {
    return row.jacobian_a.dot(a) + row.jacobian_b.dot(b);
}

/// How far the bodies' relative velocity is from the one that is asked for: along the axes of a contact, along a row.
inline Vector3 compute_miss(const ContactConstraint& contact, const BodyMotion& motion) noexcept {
    return compute_relative_velocity(contact, motion.velocity(contact.body_a),
                                     motion.velocity(contact.body_b)) -
           contact.target_m_per_s;
}
inline double compute_miss(const RowConstraint& row, const BodyMotion& motion) noexcept {
    return compute_relative_velocity(row, motion.velocity(row.body_a),
                                     motion.velocity(row.body_b)) -
           row.target;
}

/// What an impulse along the axes gives both bodies.
inline void add_impulse(const ContactConstraint& contact, const Vector3& impulse_Ns, Vector6& a,
                        Vector6& b) noexcept {
    const Vector3 impulse_W = contact.axes_W * impulse_Ns;
    a.head<3>() -= impulse_W;
    a.tail<3>() -= contact.arm_a.cross(impulse_W);
    b.head<3>() += impulse_W;
    b.tail<3>() += contact.arm_b.cross(impulse_W);
}
inline void add_impulse(const RowConstraint& row, double impulse, Vector6& a, Vector6& b) noexcept {
    a += impulse * row.jacobian_a;
    b += impulse * row.jacobian_b;
}

/// 1/kg, more than zero.
inline double compute_weight(std::span<const ConstrainedBody> bodies,
                             const ContactConstraint& contact) noexcept {
    const auto one = [&](int body, const Vector3& arm) {
        if (body == kGround) {
            return 0.0;
        }
        const ConstrainedBody& b = bodies[static_cast<std::size_t>(body)];
        const double turning =
            b.inverse_inertia_W.trace() * arm.squaredNorm() - arm.dot(b.inverse_inertia_W * arm);
        return 3.0 / b.mass_kg + turning;
    };
    return one(contact.body_a, contact.arm_a) + one(contact.body_b, contact.arm_b);
}
/// Zero where the row moves no body.
inline double compute_weight(std::span<const ConstrainedBody> bodies,
                             const RowConstraint& row) noexcept {
    const auto one = [&](int body, const Vector6& jacobian) {
        return body == kGround ? 0.0
                               : jacobian.dot(compute_velocity_change(
                                     bodies[static_cast<std::size_t>(body)], jacobian));
    };
    return one(row.body_a, row.jacobian_a) + one(row.body_b, row.jacobian_b);
}

}  // namespace fulcrum
