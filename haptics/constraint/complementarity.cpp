#include "haptics/constraint/complementarity.h"

namespace fulcrum {

void apply_impulses(ContactProblem& problem, BodyMotion& motion) noexcept {
    const std::span<ConstrainedBody> bodies = problem.bodies();
    motion.clear_momenta(bodies.size());
    for (const ContactConstraint& c : problem.contacts()) {
        add_impulse(c, c.impulse_Ns, motion.momentum(c.body_a), motion.momentum(c.body_b));
    }
    for (const RowConstraint& row : problem.rows()) {
        add_impulse(row, row.impulse, motion.momentum(row.body_a), motion.momentum(row.body_b));
    }
    int i = 0;
    for (ConstrainedBody& body : bodies) {
        body.velocity_W = body.free_velocity_W + compute_velocity_change(body, motion.momentum(i));
        motion.velocity(i++) = body.velocity_W;
    }
}

double compute_residual(const ContactProblem& problem, FrictionShape shape,
                        std::span<const double> friction) noexcept {
    const std::span<const ConstrainedBody> bodies = problem.bodies();
    const Vector6 still = Vector6::Zero();
    const auto velocity = [&](int body) -> const Vector6& {
        return body == kGround ? still : bodies[static_cast<std::size_t>(body)].velocity_W;
    };
    double worst = 0.0;
    std::size_t i = 0;
    for (const ContactConstraint& c : problem.contacts()) {
        const Vector3 y = compute_relative_velocity(c, velocity(c.body_a), velocity(c.body_b)) -
                          c.target_m_per_s + c.softness_per_kg * c.impulse_Ns;
        worst = take_worse(
            worst, compute_residual(shape, friction[i++], c.weight_per_kg, y, c.impulse_Ns));
    }
    for (const RowConstraint& row : problem.rows()) {
        if (row.weight > 0.0) {
            const double u =
                compute_relative_velocity(row, velocity(row.body_a), velocity(row.body_b));
            worst = take_worse(
                worst, compute_residual(row, row.weight,
                                        u - row.target + row.softness * row.impulse, row.impulse));
        }
    }
    return worst;
}

}  // namespace fulcrum
