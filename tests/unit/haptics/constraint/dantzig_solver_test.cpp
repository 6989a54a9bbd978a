#include "haptics/constraint/dantzig_solver.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

#include <span>
#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kPlace_m = 1.0e-7;

TEST_CASE("dantzig solver: a stack stands, and from its last sets nothing is driven") {
    ContactStack stack({.n_cubes = 4}, settings_of(ContactMethod::dantzig));
    CHECK(stack.step().n_pivots > 0);
    for (int k = 0; k < 50; ++k) {
        const SolveReport report = stack.step();
        CHECK(report.converged);
        CHECK(report.n_pivots == 0);
    }
    CHECK(stack.drift_m() <= kPlace_m);
    CHECK(std::abs(stack.sunk_m()) <= kPlace_m);
}

TEST_CASE("dantzig solver: redundant contacts share alike") {
    ContactStack stack({.n_cubes = 2}, settings_of(ContactMethod::dantzig));
    stack.step();
    for (const ContactConstraint& c : stack.problem().contacts()) {
        const double above_kg = 2.0 - c.body_b;
        CHECK(std::abs(c.impulse_Ns.x() - 0.25 * above_kg * kGravity * kStep_s) <= 1.0e-5);
    }
}

TEST_CASE("dantzig solver: rows that contradict each other are answered, finite, and told") {
    ContactProblem problem({1, 0, 2});
    problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
    for (const double target : {1.0, -1.0}) {
        RowConstraint row;
        row.body_b = 0;
        row.jacobian_b << Vector3::UnitX(), Vector3::Zero();
        row.target = target;
        row.least = -HUGE_VAL;
        row.most = HUGE_VAL;
        problem.add_row(row);
    }
    const SolveReport report = solve(problem, settings_of(ContactMethod::dantzig));
    CHECK_FALSE(report.converged);
    CHECK(report.n_regularised > 0);
    CHECK(problem.bodies()[0].velocity_W.allFinite());
}

TEST_CASE("dantzig solver: what it tells of a problem is of that one, whatever it met before") {
    const ContactSolverSettings settings = settings_of(ContactMethod::dantzig);
    const ContactCapacity capacity{2, 2, 0};
    DantzigSolver solver(settings, capacity);
    const std::vector<double> friction{0.0, 0.0};
    const auto fall = [&](int n_bodies, double mass_kg, double speed_m_per_s) {
        ContactProblem problem(capacity);
        for (int body = 0; body < n_bodies; ++body) {
            problem.add_body(mass_kg, ball_inertia(mass_kg, 0.1),
                             moving({0.0, -speed_m_per_s, 0.0}));
            ContactConstraint contact = contact_at(kGround, Vector3::Zero(), body, {0.0, 0.1, 0.0},
                                                   Vector3::Zero(), Vector3::UnitY());
            contact.impulse_Ns.x() = 1.0;  // it was pressed, and so is solved for at once
            problem.add_contact(contact);
        }
        return solver.solve(problem, std::span(friction).first(static_cast<std::size_t>(n_bodies)),
                            1.0e-8);
    };
    // Impulses beyond all numbers, and told so; then one that is easy, of fewer rows.
    CHECK(fall(2, 1.0e3, 1.0e306).n_regularised > 0);
    const SolveReport sound = fall(1, 1.0, 1.0);
    CHECK(sound.converged);
    CHECK(sound.n_regularised == 0);
}

TEST_CASE("dantzig solver: where friction's bounds never agree that is counted") {
    // What slides presses the more the less it is dragged: no rounds of bounds end there.
    const std::vector<double> friction{5.0};
    int n_apart = 0;
    for (const double side : {-1.0, 1.0}) {
        for (const double along : {-5.0, 5.0}) {
            ContactProblem problem({1, 1, 0});
            problem.add_body(1.0, 0.01 * Matrix3::Identity(), moving({along, -1.0, 0.0}));
            problem.add_contact(contact_at(kGround, Vector3::Zero(), 0, {0.3 * side, 0.3, 0.0},
                                           Vector3::Zero(), Vector3::UnitY(), 5.0));
            DantzigSolver solver(settings_of(ContactMethod::dantzig), problem.capacity());
            const SolveReport report = solver.solve(problem, friction, 1.0e-8);
            CAPTURE(side, along, report.n_iterations, report.residual_m_per_s);
            if (!report.converged) {
                ++n_apart;
                CHECK(report.n_regularised > 0);
            }
        }
    }
    CHECK(n_apart > 0);
}

}  // namespace
}  // namespace fulcrum
