#include "haptics/constraint/impact.h"

#include "haptics/constraint/complementarity.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

// Of the energy: what rounding may gain in a round.
constexpr double kRoundedGain = 1.0e-12;

Vector6 find_velocity(std::span<const Vector6> velocities, int body) noexcept {
    return body == kGround ? Vector6(Vector6::Zero()) : velocities[static_cast<std::size_t>(body)];
}

// m v.w + v I w of all bodies.
template <class First, class Second>
double sum_products(std::span<const ConstrainedBody> bodies, const First& first,
                    const Second& second) noexcept {
    double sum = 0.0;
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
        sum += first(i).dot(compute_momentum(bodies[static_cast<std::size_t>(i)], second(i)));
    }
    return sum;
}

}  // namespace

ImpactSolver::ImpactSolver(const ContactCapacity& capacity)
    : capacity_(capacity), round_(capacity), bounced_(capacity.bodies) {}

void ImpactSolver::add_rows(const ContactProblem& problem,
                            std::span<const Vector6> velocities) noexcept {
    for (RowConstraint row : problem.rows()) {
        // A bounded force gives no impulse in no time.
        if (std::isfinite(row.least) && std::isfinite(row.most)) {
            row.least = row.most = 0.0;
        } else if (std::isinf(row.least) && std::isinf(row.most)) {
            row.target = compute_relative_velocity(row, find_velocity(velocities, row.body_a),
                                                   find_velocity(velocities, row.body_b));
        }
        row.impulse = 0.0;
        round_.add_row(row);
    }
}

// False where nothing arrives.
bool ImpactSolver::begin_round(const ContactProblem& problem, std::span<const Vector6> velocities,
                               double least_m_per_s) noexcept {
    round_.clear();
    std::size_t body = 0;
    for (const ConstrainedBody& of : problem.bodies()) {
        round_.add_body(of.mass_kg, of.inertia_W, velocities[body++]);
    }
    bool arrives = false;
    for (ContactConstraint contact : problem.contacts()) {
        const double u_n =
            compute_relative_velocity(contact, find_velocity(velocities, contact.body_a),
                                      find_velocity(velocities, contact.body_b))
                .x();
        if (contact.restitution > 0.0) {
            if (!(u_n < -least_m_per_s && u_n <= contact.target_m_per_s.x())) {
                continue;
            }
            contact.target_m_per_s.x() = -contact.restitution * u_n;
            arrives = true;
        }
        contact.impulse_Ns.setZero();
        contact.slides = false;
        round_.add_contact(contact);
    }
    if (arrives) {
        add_rows(problem, velocities);
    }
    return arrives;
}

SolveReport ImpactSolver::solve_round(ContactSolver& solver) noexcept {
    const auto free = [&](int i) -> const Vector6& {
        return round_.bodies()[static_cast<std::size_t>(i)].free_velocity_W;
    };
    const double twice_before_J = sum_products(round_.bodies(), free, free);
    const SolveReport report = solver.solve(round_);
    if (!(2.0 * compute_kinetic_energy_J(round_) <= twice_before_J * (1.0 + kRoundedGain))) {
        hold_energy(twice_before_J, solver);
    }
    return report;
}

void ImpactSolver::hold_energy(double twice_before_J, ContactSolver& solver) noexcept {
    const std::span<ConstrainedBody> bodies = round_.bodies();
    int i = 0;
    for (const ConstrainedBody& body : bodies) {
        bounced_.velocity(i++) = body.velocity_W;
    }
    for (ContactConstraint& contact : round_.contacts()) {
        contact.target_m_per_s.x() = std::min(contact.target_m_per_s.x(), 0.0);
        contact.impulse_Ns.setZero();
        contact.slides = false;
    }
    (void)solver.solve(round_);
    // E(part) = c + 2 b part + a part^2 of v_0 + part (v_e - v_0).
    const auto start = [&](int k) -> const Vector6& {
        return bodies[static_cast<std::size_t>(k)].velocity_W;
    };
    const auto way = [&](int k) -> Vector6 { return bounced_.velocity(k) - start(k); };
    const double a = sum_products(bodies, way, way);
    const double b = sum_products(bodies, start, way);
    const double c = sum_products(bodies, start, start);
    const double room = std::max(twice_before_J - c, 0.0);
    const double root = std::sqrt(b * b + a * room);
    // The greater root; b <= 0 would lose digits in the other form.
    const double part = b > 0.0 ? room / (b + root) : (root - b) / a;
    const double taken = std::isfinite(part) ? std::clamp(part, 0.0, 1.0) : 0.0;
    i = 0;
    for (ConstrainedBody& body : bodies) {
        body.velocity_W += taken * (bounced_.velocity(i++) - body.velocity_W);
    }
}

ImpactReport ImpactSolver::solve(const ContactProblem& problem, double least_m_per_s,
                                 ContactSolver& solver, std::span<Vector6> velocities) noexcept {
    ImpactReport report;
    const auto fits = [](std::size_t n, int room) {
        return n <= static_cast<std::size_t>(std::max(room, 0));
    };
    if (!fits(problem.bodies().size(), capacity_.bodies) ||
        !fits(problem.contacts().size(), capacity_.contacts) ||
        !fits(problem.rows().size(), capacity_.rows) ||
        velocities.size() < problem.bodies().size()) {
        return report;
    }
    while (begin_round(problem, velocities, least_m_per_s)) {
        if (report.n_rounds == kMostImpactRounds) {
            report.done = false;
            break;
        }
        ++report.n_rounds;
        const SolveReport solved = solve_round(solver);
        if (!(solved.residual_m_per_s <= report.solve.residual_m_per_s)) {
            report.solve = solved;
        }
        std::size_t i = 0;
        for (const ConstrainedBody& body : round_.bodies()) {
            velocities[i++] = body.velocity_W;
        }
    }
    return report;
}

}  // namespace fulcrum
