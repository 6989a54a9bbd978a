// Each method by itself: what iterative_solver.h, dantzig_solver.h and newton_solver.h add to what contact_solver.h asks of all.
#include "haptics/constraint/complementarity.h"
#include "haptics/constraint/dantzig_solver.h"
#include "haptics/constraint/iterative_solver.h"
#include "haptics/constraint/newton_solver.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kStill_m_per_s =
    2.0e-9;  // twenty on each other, each off by the tolerance of 1e-10
constexpr double kPlace_m = 1.0e-8;
constexpr double kPivotedPlace_m = 1.0e-7;
constexpr int kMostAgain = 40;  // of 100 steps

ContactSolverSettings in_rounds(int n_rounds) {
    ContactSolverSettings settings = settings_of(ContactMethod::iterative);
    settings.max_iterations = n_rounds;
    return settings;
}

void check_stands(ContactStack& stack, double within_m) {
    CHECK(stack.drift_m() <= within_m);
    CHECK(std::abs(stack.sunk_m()) <= within_m);
}

TEST_CASE("iterative solver: more rounds leave less; it starts from the last step's impulses") {
    double before = HUGE_VAL;
    for (const int n_rounds : {4, 40, 400}) {
        ContactStack stack({.n_cubes = 6}, in_rounds(n_rounds));
        const SolveReport report = stack.step();
        CHECK(report.n_iterations == n_rounds);
        CHECK_FALSE(report.converged);
        CHECK(report.residual_m_per_s < 0.5 * before);
        before = report.residual_m_per_s;
    }
    ContactStack stack({.n_cubes = 2}, settings_of(ContactMethod::iterative));
    const int first = stack.step().n_iterations;
    CHECK(first > 10);
    CHECK(stack.step().n_iterations < first / 2);
}

TEST_CASE("iterative solver: friction's bound holds in few rounds, and unsolved is not sliding") {
    for (const int n_rounds : {1, 2, 5}) {
        ContactStack stack({.n_cubes = 6, .friction = 0.2, .start_gap_m = 0.0005},
                           in_rounds(n_rounds));
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
    ContactStack stack({.n_cubes = 6}, in_rounds(3));
    // A stack at rest: what moves is what three rounds leave.
    for (int k = 0; k < 5; ++k) {
        CHECK_FALSE(stack.step().converged);
        for (const ContactConstraint& c : stack.problem().contacts()) {
            CHECK_FALSE(c.slides);
        }
    }
}

TEST_CASE("dantzig and newton solver: the corners of a stack share its weight alike") {
    const auto check_shares = [](int n_cubes, ContactMethod method, double within_Ns) {
        ContactStack stack({.n_cubes = n_cubes}, settings_of(method));
        stack.step();
        for (const ContactConstraint& c : stack.problem().contacts()) {
            CAPTURE(to_string(method), c.body_b);
            const double above_kg = n_cubes - c.body_b;
            CHECK(std::abs(c.impulse_Ns.x() - 0.25 * above_kg * kGravity * kStep_s) <= within_Ns);
            CHECK(c.impulse_Ns.tail<2>().cwiseAbs().maxCoeff() <= within_Ns);
        }
    };
    check_shares(2, ContactMethod::dantzig, 1.0e-5);
    check_shares(4, ContactMethod::newton, kSolved);
}

TEST_CASE("dantzig solver: a stack stands; contradicting rows are answered, finite, and told") {
    ContactStack stack({.n_cubes = 4}, settings_of(ContactMethod::dantzig));
    CHECK(stack.step().n_pivots > 0);
    for (int k = 0; k < 50; ++k) {
        const SolveReport report = stack.step();
        CHECK(report.converged);
        CHECK(report.n_pivots == 0);
    }
    check_stands(stack, kPivotedPlace_m);
    ContactProblem problem({1, 0, 2});
    problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
    for (const double target : {1.0, -1.0}) {
        RowConstraint row = tie_down(0, moving(Vector3::UnitX()));
        row.target = target;
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
            check_stands(stack, kPlace_m);
        }
    }
}

TEST_CASE("newton solver: a falling stack lands in few solves; mass ratios make nothing harder") {
    constexpr int kMostSolves = 40;
    ContactStack falling({.n_cubes = 10, .start_gap_m = 0.005}, settings_of(ContactMethod::newton));
    for (int k = 0; k < 1000; ++k) {
        const SolveReport report = falling.step();
        CHECK(report.converged);
        CHECK(report.n_iterations <= kMostSolves);
    }
    check_stands(falling, kPlace_m);
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

TEST_CASE("newton solver: linear takes two or three solves, sliding a few") {
    const Vector3 arm(0.1, 0.05, 0.0);
    for (const double softness : {0.0, 0.1}) {
        ContactProblem problem({8, 0, 32});
        for (int i = 0; i < 8; ++i) {
            problem.add_body(1.0, ball_inertia(1.0, 0.1), moving({1.0 * i, 0.3, -0.2 * i}));
        }
        for (int i = 0; i < 8; ++i) {
            for (int k = 0; k < 3; ++k) {
                RowConstraint row = hold_along(Vector3::Unit(k), i - 1, arm, i, -arm);
                row.softness = softness;
                problem.add_row(row);
            }
        }
        ContactSolverSettings settings = settings_of(ContactMethod::newton);
        settings.tolerance_m_per_s = 1.0e-8;
        const SolveReport report = solve_by_newton(problem, settings);
        CAPTURE(softness, report.residual_m_per_s);
        CHECK(report.converged);
        CHECK(report.n_iterations <= 4);
        CHECK(report.n_regularised == 0);
    }
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

TEST_CASE("newton solver: however few its solves, it is no worse than the last answer or none") {
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
