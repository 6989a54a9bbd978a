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

}  // namespace
}  // namespace fulcrum
