#include "haptics/constraint/iterative_solver.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

using namespace contact_scenes;

TEST_CASE("iterative solver: more rounds leave less, and too few are told") {
    double before = HUGE_VAL;
    for (const int n_rounds : {4, 40, 400}) {
        ContactSolverSettings settings = settings_of(ContactMethod::iterative);
        settings.max_iterations = n_rounds;
        ContactStack stack({.n_cubes = 6}, settings);
        const SolveReport report = stack.step();
        CHECK(report.n_iterations == n_rounds);
        CHECK_FALSE(report.converged);
        CHECK(report.residual_m_per_s < 0.5 * before);
        before = report.residual_m_per_s;
    }
}

TEST_CASE("iterative solver: it starts from the last step's impulses") {
    ContactSolverSettings settings = settings_of(ContactMethod::iterative);
    ContactStack stack({.n_cubes = 2}, settings);
    const int first = stack.step().n_iterations;
    CHECK(first > 10);
    CHECK(stack.step().n_iterations < first / 2);
}

TEST_CASE("iterative solver: a row that moves nothing is left alone") {
    ContactProblem problem({1, 0, 1});
    problem.add_body(1.0, Matrix3::Identity(), moving({1.0, 0.0, 0.0}));
    RowConstraint row;
    row.body_b = 0;
    row.least = -HUGE_VAL;
    row.most = HUGE_VAL;
    row.target = 5.0;
    problem.add_row(row);
    for (const ContactMethod method : kContactMethods) {
        CHECK(solve(problem, settings_of(method)).converged);
        CHECK(problem.rows()[0].impulse == 0.0);
        CHECK(problem.bodies()[0].velocity_W == moving({1.0, 0.0, 0.0}));
    }
}

TEST_CASE("iterative solver: however few its rounds, no contact holds more than friction does") {
    for (const int n_rounds : {1, 2, 5}) {
        ContactSolverSettings settings = settings_of(ContactMethod::iterative);
        settings.max_iterations = n_rounds;
        ContactStack stack({.n_cubes = 6, .friction = 0.2, .start_gap_m = 0.0005}, settings);
        for (int i = 0; i < 6; ++i) {
            stack.velocity(i) = moving({0.3 * i, -1.0, 0.1}, {0.5, 0.2, -0.4 * i});
        }
        for (int k = 0; k < 20; ++k) {
            stack.step();
            for (const ContactConstraint& c : stack.problem().contacts()) {
                CHECK(c.impulse_Ns.tail<2>().norm() <= 0.2 * c.impulse_Ns.x() * (1.0 + 1.0e-12));
            }
        }
    }
}

TEST_CASE("iterative solver: what is not yet solved is not called sliding") {
    ContactSolverSettings settings = settings_of(ContactMethod::iterative);
    settings.max_iterations = 3;
    ContactStack stack({.n_cubes = 6}, settings);
    // A stack at rest: what moves is what three rounds leave.
    for (int k = 0; k < 5; ++k) {
        CHECK_FALSE(stack.step().converged);
        for (const ContactConstraint& c : stack.problem().contacts()) {
            CHECK_FALSE(c.slides);
        }
    }
}

}  // namespace
}  // namespace fulcrum
