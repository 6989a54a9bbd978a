#include "haptics/constraint/newton_solver.h"

#include "haptics/constraint/complementarity.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kStill_m_per_s =
    2.0e-9;  // twenty on each other, each off by the tolerance of 1e-10
constexpr double kPlace_m = 1.0e-8;
constexpr int kMostAgain = 40;  // of 100 steps

TEST_CASE("newton solver: stacks stand, and are seldom solved again") {
    for (const int n : {1, 2, 10, 20}) {
        for (const double top_mass_kg : {1.0, 100.0}) {
            CAPTURE(n, top_mass_kg);
            ContactStack stack({.n_cubes = n, .top_mass_kg = top_mass_kg},
                               settings_of(ContactMethod::newton));
            CHECK(stack.step().n_iterations > 0);
            int n_iterations = 0;
            for (int k = 0; k < 100; ++k) {
                const SolveReport report = stack.step();
                CHECK(report.converged);
                n_iterations += report.n_iterations;
            }
            CHECK(n_iterations <= kMostAgain);
            for (int i = 0; i < n; ++i) {
                CHECK(stack.velocity(i).cwiseAbs().maxCoeff() <= kStill_m_per_s);
            }
            CHECK(stack.drift_m() <= kPlace_m);
            CHECK(std::abs(stack.sunk_m()) <= kPlace_m);
        }
    }
}

TEST_CASE("newton solver: the corners of a stack share its weight alike") {
    ContactStack stack({.n_cubes = 4}, settings_of(ContactMethod::newton));
    stack.step();
    for (const ContactConstraint& c : stack.problem().contacts()) {
        const double above_kg = 4.0 - c.body_b;
        CHECK(std::abs(c.impulse_Ns.x() - 0.25 * above_kg * kGravity * kStep_s) <= kSolved);
        CHECK(c.impulse_Ns.tail<2>().cwiseAbs().maxCoeff() <= kSolved);
    }
}

TEST_CASE("newton solver: a stack that falls lands and stands within few solves a step") {
    constexpr int kMostSolves = 40;
    ContactStack stack({.n_cubes = 10, .start_gap_m = 0.005}, settings_of(ContactMethod::newton));
    for (int k = 0; k < 1000; ++k) {
        const SolveReport report = stack.step();
        CHECK(report.converged);
        CHECK(report.n_iterations <= kMostSolves);
    }
    CHECK(stack.drift_m() <= kPlace_m);
    CHECK(std::abs(stack.sunk_m()) <= kPlace_m);
}

TEST_CASE("newton solver: a heavy body on a light one is no harder than another") {
    for (const double heavy_kg : {1.0e3, 1.0e6}) {
        CAPTURE(heavy_kg);
        ContactStack stack({.n_cubes = 3, .top_mass_kg = heavy_kg},
                           settings_of(ContactMethod::newton));
        const SolveReport report = stack.step();
        CHECK(report.converged);
        for (int i = 0; i < 3; ++i) {
            CHECK(stack.velocity(i).cwiseAbs().maxCoeff() <= kStill_m_per_s);
        }
    }
}

SolveReport solve_by_newton(ContactProblem& problem, const ContactSolverSettings& settings) {
    std::vector<double> friction;
    for (const ContactConstraint& c : problem.contacts()) {
        friction.push_back(c.static_friction);
    }
    return NewtonSolver(settings, problem.capacity())
        .solve(problem, friction, settings.tolerance_m_per_s);
}

TEST_CASE(
    "newton solver: what is linear takes two or three solves, tied bodies and soft rows too") {
    for (const double softness : {0.0, 0.1}) {
        CAPTURE(softness);
        ContactProblem problem({8, 0, 32});
        for (int i = 0; i < 8; ++i) {
            problem.add_body(1.0, ball_inertia(1.0, 0.1), moving({1.0 * i, 0.3, -0.2 * i}));
        }
        for (int i = 0; i < 8; ++i) {
            for (int k = 0; k < 3; ++k) {
                RowConstraint row;
                row.body_a = i - 1;
                row.body_b = i;
                const Vector3 axis = Vector3::Unit(k);
                const Vector3 arm(0.1, 0.05, 0.0);
                row.jacobian_a << -axis, -arm.cross(axis);
                row.jacobian_b << axis, -arm.cross(axis);
                row.least = -HUGE_VAL;
                row.most = HUGE_VAL;
                row.softness = softness;
                problem.add_row(row);
            }
        }
        ContactSolverSettings settings = settings_of(ContactMethod::newton);
        settings.tolerance_m_per_s = 1.0e-8;
        const SolveReport report = solve_by_newton(problem, settings);
        CAPTURE(report.residual_m_per_s);
        CHECK(report.converged);
        CHECK(report.n_iterations <= 4);
        CHECK(report.n_regularised == 0);
    }
}

TEST_CASE(
    "newton solver: what slides is solved in a few solves, from nothing and from last step's "
    "slip") {
    ContactProblem problem({1, 4, 0});
    problem.add_body(1.0, cube_inertia(1.0, 0.1), moving({2.0, -kGravity * kStep_s, 0.5}));
    add_corners(problem, 0, 0.1, 0.3, make_contact_axes(Vector3::UnitY()));
    const ContactSolverSettings settings = settings_of(ContactMethod::newton);
    const SolveReport first = solve_by_newton(problem, settings);
    CHECK(first.converged);
    CHECK(first.n_regularised == 0);
    CHECK(first.n_iterations <= 8);
    // A little later: the slip is known nearly, and the lift with it.
    for (ContactConstraint& c : problem.contacts()) {
        c.slides = true;
    }
    problem.bodies()[0].free_velocity_W += moving({-0.002, 0.0, 0.001});
    const SolveReport second = solve_by_newton(problem, settings);
    CHECK(second.converged);
    CHECK(second.n_iterations <= 4);
}

TEST_CASE(
    "newton solver: however few its solves, its answer is no worse than last step's or none") {
    for (const int most : {1, 2, 3, 5}) {
        ContactSolverSettings settings = settings_of(ContactMethod::newton);
        settings.max_iterations = most;
        for (const double speed : {0.1, 3.0, 30.0}) {
            CAPTURE(most, speed);
            ContactStack stack({.n_cubes = 8, .top_mass_kg = 50.0}, settings);
            for (int i = 0; i < 8; ++i) {
                stack.velocity(i) =
                    moving({speed * (i % 2 == 0 ? 1.0 : -1.0), -speed, 0.2 * speed * i},
                           {speed, 0.0, -2.0 * speed});
            }
            stack.prepare();
            ContactProblem& problem = stack.problem();
            std::vector<double> friction(problem.contacts().size(), 0.6);
            for (ContactConstraint& c : problem.contacts()) {
                c.impulse_Ns = {0.3, 0.1, 0.0};
            }
            BodyMotion motion(8);
            apply_impulses(problem, motion);
            const double before = compute_residual(problem, FrictionShape::cone, friction);
            ContactProblem free = problem;
            for (ContactConstraint& c : free.contacts()) {
                c.impulse_Ns.setZero();
            }
            apply_impulses(free, motion);
            const double none = compute_residual(free, FrictionShape::cone, friction);
            const SolveReport report = solve_by_newton(problem, settings);
            CHECK(report.residual_m_per_s <= std::min(before, none) * (1.0 + 1.0e-12));
            CHECK(report.residual_m_per_s ==
                  compute_residual(problem, FrictionShape::cone, friction));
        }
    }
}

}  // namespace
}  // namespace fulcrum
