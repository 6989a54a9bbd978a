#include "haptics/constraint/set_solver.h"

#include "haptics/constraint/complementarity.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <rapidcheck.h>
#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kTolerance = 1.0e-8;
constexpr double kHeld_Ns = 1.0e-8;

std::vector<double> friction_of(const ContactProblem& problem) {
    std::vector<double> friction;
    for (const ContactConstraint& c : problem.contacts()) {
        friction.push_back(c.static_friction);
    }
    return friction;
}
// As newton_solver.h does: from the problem's impulses, and with the velocities that come of the answer's.
SetSolver::Answer solve_by_guesses(ContactProblem& problem,
                                   FrictionShape shape = FrictionShape::cone,
                                   int most = kMostGuesses) {
    const auto n = static_cast<int>(problem.bodies().size());
    BlockSystem matrix(problem.capacity().bodies);
    matrix.begin(n);
    for (const ContactConstraint& c : problem.contacts()) {
        matrix.add_pair(c.body_a, c.body_b);
    }
    for (const RowConstraint& r : problem.rows()) {
        matrix.add_pair(r.body_a, r.body_b);
    }
    REQUIRE(matrix.find_order());
    BodyMotion motion(problem.capacity().bodies);
    apply_impulses(problem, motion);
    const std::vector<double> friction = friction_of(problem);
    SetSolver solver(settings_of(ContactMethod::newton, shape), problem.capacity());
    const SetSolver::Answer answer =
        solver.solve(problem, friction, kTolerance, most, matrix, motion);
    apply_impulses(problem, motion);
    return answer;
}
TEST_CASE("set solver: a cube that lands and slides obeys Coulomb's law, by both shapes") {
    constexpr double kFriction = 0.3;
    constexpr double kFall = 0.5;
    for (const FrictionShape shape : {FrictionShape::cone, FrictionShape::pyramid}) {
        CAPTURE(static_cast<int>(shape));
        ContactProblem problem({1, 4, 0});
        problem.add_body(2.0, cube_inertia(2.0, 0.1), moving({0.0, -kFall, 0.0}));
        add_corners(problem, 0, 0.1, kFriction, make_contact_axes(Vector3::UnitY()));
        // Along a tangent, where cone and pyramid are the same, and high enough not to trip over an edge.
        const Vector3 along = problem.contacts()[0].axes_W.col(1);
        problem.bodies()[0].free_velocity_W.head<3>() += 2.0 * along;
        for (ContactConstraint& c : problem.contacts()) {
            c.arm_b -= c.axes_W.col(0) * c.arm_b.dot(c.axes_W.col(0));
        }
        const SetSolver::Answer answer = solve_by_guesses(problem, shape);
        CHECK(answer.found);
        CHECK(answer.n_guesses <= 5);
        // All that falls is stopped, and friction takes mu of that from the slide.
        const Vector3 expected = (2.0 - kFriction * kFall) * along;
        CHECK((problem.bodies()[0].velocity_W.head<3>() - expected).norm() <= kHeld_Ns);
        CHECK(std::abs(sum_of_impulses(problem).y() - 2.0 * kFall) <= kHeld_Ns);
    }
}

TEST_CASE("set solver: a soft row and one at its bound give their closed forms") {
    ContactProblem problem({2, 0, 2});
    RowConstraint soft = tie_down(0, moving(Vector3::UnitX()));
    soft.softness = 0.25;
    RowConstraint weak = tie_down(1, moving(Vector3::UnitX()));
    weak.most = 0.5;
    for (RowConstraint* row : {&soft, &weak}) {
        row->body_b = problem.add_body(2.0, ball_inertia(2.0, 0.1), moving({-3.0, 0.0, 0.0}));
        problem.add_row(*row);
    }
    CHECK(solve_by_guesses(problem).found);
    // (1/m + R) p = 3, and the bound.
    CHECK(std::abs(problem.rows()[0].impulse - 3.0 / (0.5 + 0.25)) <= kHeld_Ns);
    CHECK(problem.rows()[1].impulse == 0.5);
}

TEST_CASE("set solver: contacts that are apart or part are not pushed") {
    ContactProblem problem({1, 4, 0});
    problem.add_body(1.0, cube_inertia(1.0, 0.1), moving({0.0, 0.2, 0.0}, {0.1, 0.0, 0.0}));
    add_corners(problem, 0, 0.1, 0.5, make_contact_axes(Vector3::UnitY()));
    for (ContactConstraint& c : problem.contacts()) {
        c.impulse_Ns = {0.5, 0.1, 0.0};
    }
    CHECK(solve_by_guesses(problem).found);
    for (const ContactConstraint& c : problem.contacts()) {
        CHECK(c.impulse_Ns == Vector3::Zero());
    }
}

TEST_CASE("set solver: what is hit or begins to rest is answered in a few guesses, however high") {
    for (const int n : {1, 10, 40}) {
        CAPTURE(n);
        ContactStack stack({.n_cubes = n}, settings_of(ContactMethod::newton));
        stack.prepare();
        const SetSolver::Answer answer = solve_by_guesses(stack.problem());
        CHECK(answer.found);
        CHECK(answer.n_guesses <= 4);
    }
    // Any hit on a stack within its weight's hold.
    constexpr int kCubes = 10;
    ContactStack stack({.n_cubes = kCubes}, settings_of(ContactMethod::newton));
    (void)stack.step();
    int n_guesses = 0;
    for (int hit = 0; hit < kCubes; ++hit) {
        CAPTURE(hit);
        stack.prepare();
        ContactProblem& problem = stack.problem();
        problem.bodies()[static_cast<std::size_t>(hit)].free_velocity_W.x() += 0.015;
        const SetSolver::Answer answer = solve_by_guesses(problem);
        CHECK(answer.found);
        n_guesses += answer.n_guesses;
    }
    CHECK(n_guesses <= 12 * kCubes);
}

TEST_CASE("set solver: what it finds fits to the tolerance, and what it does not find stays") {
    CHECK(rc::check([] {
        const auto number = [] { return *rc::gen::inRange(-1000, 1001) * 1.0e-3; };
        const FrictionShape shape = *rc::gen::element(FrictionShape::cone, FrictionShape::pyramid);
        ContactStack stack({.n_cubes = 4, .friction = std::abs(number())},
                           settings_of(ContactMethod::newton, shape));
        for (int i = 0; i < 4; ++i) {
            stack.velocity(i) =
                moving({number(), number(), number()}, {number(), number(), number()});
        }
        stack.prepare();
        ContactProblem& problem = stack.problem();
        for (ContactConstraint& c : problem.contacts()) {
            c.impulse_Ns = {std::abs(number()), 0.0, 0.0};
        }
        const ContactProblem before = problem;
        const SetSolver::Answer answer = solve_by_guesses(problem, shape);
        RC_CLASSIFY(answer.found);
        if (answer.found) {
            RC_ASSERT(compute_residual(problem, shape, friction_of(problem)) <= 2.0 * kTolerance);
            return;
        }
        for (std::size_t i = 0; i < problem.contacts().size(); ++i) {
            RC_ASSERT(problem.contacts()[i].impulse_Ns == before.contacts()[i].impulse_Ns);
        }
    }));
}

TEST_CASE("set solver: what has no answer, or may take no guess, is left as it was") {
    ContactProblem squeezed = squeezed_ball(0.25);
    for (const int most : {0, kMostGuesses}) {
        const SetSolver::Answer answer = solve_by_guesses(squeezed, FrictionShape::cone, most);
        CHECK_FALSE(answer.found);
        CHECK(answer.n_guesses <= most);
        for (const ContactConstraint& c : squeezed.contacts()) {
            CHECK(c.impulse_Ns == Vector3(0.25, 0.0, 0.0));
        }
    }
}

}  // namespace
}  // namespace fulcrum
