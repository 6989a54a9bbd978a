#include "haptics/constraint/dantzig_solver.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

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

}  // namespace
}  // namespace fulcrum
