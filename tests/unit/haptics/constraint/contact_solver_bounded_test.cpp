// Bounded work on many contacts. See contact_solver.h.
#include "haptics/constraint/contact_solver.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

namespace fulcrum {
namespace {

using namespace contact_scenes;

ContactSolverSettings settings_for(int most_exact) {
    ContactSolverSettings settings = settings_of(ContactMethod::newton);
    settings.most_exact_contacts = most_exact;
    return settings;
}

TEST_CASE("contact solver: many contacts get rounds alone, where the problem says so") {
    for (const bool bounded : {false, true}) {
        for (const int most_exact : {16, 32}) {
            CAPTURE(bounded, most_exact);
            ContactStack stack({.n_cubes = 8}, settings_for(most_exact));
            stack.velocity(7) = moving({0.5, -0.2, 0.1});
            stack.prepare();
            ContactProblem& problem = stack.problem();
            problem.set_bounded(bounded);
            const SolveReport report = solve(problem, settings_for(most_exact));
            const bool in_rounds = bounded && most_exact == 16;
            CHECK(report.n_bounded == (in_rounds ? 1 : 0));
            CHECK(report.converged != in_rounds);
            if (in_rounds) {
                CHECK(report.n_iterations <= kBoundedRounds);
            }
        }
    }
}

TEST_CASE("contact solver: bounded work gives no energy, whatever it starts from") {
    CHECK(rc::check([] {
        const auto number = [] { return *rc::gen::inRange(-1000, 1001) * 1.0e-3; };
        const ContactSolverSettings settings = settings_for(1);
        ContactStack stack({.n_cubes = 5, .friction = std::abs(number())}, settings);
        for (int i = 0; i < 5; ++i) {
            stack.velocity(i) =
                moving({number(), number(), number()}, {number(), number(), number()});
        }
        stack.prepare();
        ContactProblem& problem = stack.problem();
        problem.set_bounded(true);
        for (ContactConstraint& c : problem.contacts()) {
            c.impulse_Ns = {10.0 * std::abs(number()), number(), number()};
            c.target_m_per_s.x() = std::min(c.target_m_per_s.x(), 0.0);
        }
        double before_J = 0.0;
        for (ConstrainedBody& body : problem.bodies()) {
            body.velocity_W = body.free_velocity_W;
        }
        before_J = compute_kinetic_energy_J(problem);
        const SolveReport report = solve(problem, settings);
        RC_ASSERT(report.n_bounded >= 1);
        RC_ASSERT(compute_kinetic_energy_J(problem) <= before_J * (1.0 + 1.0e-12) + 1.0e-12);
    }));
}

TEST_CASE("contact solver: bounded work goes on from step to step, until a stack stands") {
    constexpr double kStands_m_per_s = 1.0e-4;
    const ContactSolverSettings settings = settings_for(1);
    ContactStack stack({.n_cubes = 6}, settings);
    ContactSolver solver(settings, ContactStack::capacity_of(6));
    stack.prepare();
    ContactProblem problem = stack.problem();
    double residual = HUGE_VAL;
    for (int k = 0; k < 60; ++k) {
        problem.set_bounded(true);
        residual = solver.solve(problem).residual_m_per_s;
    }
    CHECK(residual <= kStands_m_per_s);
}

}  // namespace
}  // namespace fulcrum
