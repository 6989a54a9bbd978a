#include "haptics/constraint/complementarity.h"
#include "haptics/constraint/contact_problem.h"
#include "haptics/constraint/set_solver.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::contact_scenes;

namespace {

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

constexpr double kExact = 1.0e-15;

// What add_body takes.
struct Body {
    double mass_kg = 1.0;
    Matrix3 inertia{Matrix3::Identity()};
    Vector6 velocity{Vector6::Zero()};
};

ContactConstraint on_ground() {
    ContactConstraint contact;
    contact.body_b = 0;
    return contact;
}

}  // namespace

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

TEST_CASE("contact problem: a full one drops and counts") {
    ContactProblem problem({1, 1, 1});
    CHECK(problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero()) == 0);
    CHECK(problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero()) == kGround);
    CHECK(problem.add_contact(on_ground()));
    CHECK_FALSE(problem.add_contact(on_ground()));
    RowConstraint row;
    row.body_b = 0;
    CHECK(problem.add_row(row));
    CHECK_FALSE(problem.add_row(row));
    CHECK(problem.n_dropped() == 3);
    problem.clear();
    CHECK(problem.n_dropped() == 0);
    CHECK(problem.bodies().empty());
    CHECK(problem.contacts().empty());
    CHECK(problem.rows().empty());
}

TEST_CASE("contact problem: what is no body, joins no two bodies or has no numbers is refused") {
    ContactProblem problem({2, 8, 8});
    check_refused(Body{},
                  [&](const Body& body) {
                      return problem.add_body(body.mass_kg, body.inertia, body.velocity) != kGround;
                  },
                  {{&Body::mass_kg, 0.0},
                   {&Body::mass_kg, -1.0},
                   {&Body::mass_kg, kNan},
                   {&Body::mass_kg, 1.0e-310},
                   [](Body& body) { body.inertia.setZero(); },
                   [](Body& body) { body.inertia *= kNan; },
                   // Two moments below zero: the determinant is above it.
                   [](Body& body) { body.inertia = Vector3(-1.0, -1.0, 1.0).asDiagonal(); },
                   [](Body& body) { body.inertia = Vector3(1.0, -1.0, -1.0).asDiagonal(); },
                   [](Body& body) { body.inertia(0, 1) = 0.5; },
                   [](Body& body) { body.velocity.setConstant(kNan); }});
    CHECK(problem.bodies().size() == 1);
    CHECK(problem.n_dropped() == 10);
    using C = ContactConstraint;
    check_refused(on_ground(), [&](const C& contact) { return problem.add_contact(contact); },
                  {{&C::body_b, kGround},
                   {&C::body_b, 1},
                   {&C::body_a, -2},
                   {&C::static_friction, -0.1},
                   {&C::dynamic_friction, kNan},
                   {&C::softness_per_kg, -1.0},
                   [](C& contact) { contact.arm_b.x() = kNan; },
                   [](C& contact) { contact.axes_W(1, 1) = kNan; },
                   [](C& contact) { contact.target_m_per_s.z() = HUGE_VAL; },
                   // Weights beyond numbers.
                   [](C& contact) { contact.arm_b.setConstant(1.0e200); }});
    CHECK(problem.contacts()[0].weight_per_kg == 3.0);
    using R = RowConstraint;
    RowConstraint sound;
    sound.body_b = 0;
    check_refused(sound, [&](const R& row) { return problem.add_row(row); },
                  {{&R::least, 1.0},
                   {&R::target, kNan},
                   {&R::softness, kNan},
                   [](R& row) { row.least = row.most = HUGE_VAL; },
                   [](R& row) { row.jacobian_b.setConstant(kNan); },
                   [](R& row) { row.jacobian_b.setConstant(1.0e200); },
                   [](R& row) { row.jacobian_b.setConstant(1.0e-160); }});
    CHECK(problem.n_dropped() == 27);
}

TEST_CASE("contact problem: what was remembered and is no number is forgotten") {
    ContactProblem problem({1, 1, 1});
    problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
    ContactConstraint contact = on_ground();
    contact.impulse_Ns.setConstant(kNan);
    contact.static_friction = 0.2;
    contact.dynamic_friction = 0.7;
    CHECK(problem.add_contact(contact));
    CHECK(problem.contacts()[0].impulse_Ns == Vector3(Vector3::Zero()));
    CHECK(problem.contacts()[0].dynamic_friction == 0.2);
    RowConstraint row;
    row.body_b = 0;
    row.impulse = kNan;
    CHECK(problem.add_row(row));
    CHECK(problem.rows()[0].impulse == 0.0);
}

TEST_CASE("contact problem: axes are perpendicular, right-handed, and begin with the normal") {
    for (const Vector3& direction :
         {Vector3(0.0, 1.0, 0.0), Vector3(0.0, 0.0, -1.0), Vector3(0.0, 0.0, 1.0),
          Vector3(1.0, 2.0, -3.0), Vector3(-1.0, 1.0e-9, -1.0e-9)}) {
        const Vector3 normal = compute_direction(direction);
        const Matrix3 axes = make_contact_axes(normal);
        CHECK(axes.col(0) == normal);
        CHECK((axes.transpose() * axes - Matrix3::Identity()).cwiseAbs().maxCoeff() <= kExact);
        CHECK(std::abs(axes.determinant() - 1.0) <= kExact);
    }
}
TEST_CASE("contact problem: the energy is that of motion and of turning") {
    ContactProblem problem({1, 0, 0});
    problem.add_body(2.0, Vector3(1.0, 2.0, 3.0).asDiagonal(),
                     moving({1.0, 2.0, 2.0}, {1.0, 1.0, 2.0}));
    CHECK(compute_kinetic_energy_J(problem) == 0.5 * (2.0 * 9.0 + 1.0 + 2.0 + 12.0));
}
TEST_CASE("complementarity: a contact's residual is the velocity that does not fit") {
    const auto residual = [](const Vector3& u, const Vector3& p) {
        return compute_residual(FrictionShape::cone, 0.5, 2.0, u, p);
    };
    // What pushes: the velocity left.
    CHECK(std::abs(residual({0.01, 0.0, 0.0}, {1.0, 0.0, 0.0}) - 0.01) <= kExact);
    CHECK(std::abs(residual({-0.01, 0.0, 0.0}, {1.0, 0.0, 0.0}) - 0.01) <= kExact);
    CHECK(std::abs(residual({0.0, 0.02, 0.0}, {1.0, 0.1, 0.0}) - 0.02) <= kExact);
    // What does not: nothing where bodies part, all of their approach.
    CHECK(residual({0.3, 7.0, 0.0}, Vector3::Zero()) == 0.0);
    CHECK(residual({-0.3, 0.0, 0.0}, Vector3::Zero()) == 0.3);
    // A drag at its bound: nothing where it is against the slip.
    CHECK(residual({0.0, -0.3, 0.0}, {1.0, 0.5, 0.0}) <= kExact);
    CHECK(residual({0.0, 0.3, 0.0}, {1.0, 0.5, 0.0}) > 0.1);
    // Beyond it, and pulling.
    CHECK(residual(Vector3::Zero(), {1.0, 0.75, 0.0}) == 0.5);
    CHECK(residual(Vector3::Zero(), {-1.0, 0.0, 0.0}) == 2.0);
}
TEST_CASE("complementarity: a row's is what is left between its bounds, or against them") {
    RowConstraint row;
    row.least = -1.0;
    row.most = 2.0;
    CHECK(std::abs(compute_residual(row, 4.0, 0.25, 0.5) - 0.25) <= kExact);
    CHECK(compute_residual(row, 4.0, -3.0, 2.0) == 0.0);
    CHECK(compute_residual(row, 4.0, 3.0, -1.0) == 0.0);
    CHECK(compute_residual(row, 4.0, 3.0, 2.0) == 3.0);
    CHECK(compute_residual(row, 4.0, 0.0, 2.5) == 2.0);
}
TEST_CASE("complementarity: impulses keep the momentum of bodies that touch only each other") {
    const std::array<Vector3, 2> places{Vector3(0.0, 0.0, 0.0), Vector3(0.3, 0.4, 0.1)};
    ContactProblem problem({2, 1, 1});
    problem.add_body(2.0, ball_inertia(2.0, 0.3), moving({1.0, 2.0, 3.0}, {0.5, 0.0, 1.0}));
    problem.add_body(3.0, ball_inertia(3.0, 0.2), moving({-1.0, 0.0, 1.0}, {0.0, 2.0, 0.0}));
    ContactConstraint contact =
        contact_at(0, places[0], 1, places[1], {0.1, 0.2, 0.0}, compute_direction(places[1]), 0.4);
    contact.impulse_Ns = {1.0, 0.3, -0.2};
    problem.add_contact(contact);
    const Vector6 before = total_momentum(problem, places, true);
    BodyMotion motion(2);
    apply_impulses(problem, motion);
    CHECK((total_momentum(problem, places, false) - before).cwiseAbs().maxCoeff() <= 1.0e-14);
    CHECK((problem.bodies()[1].velocity_W - problem.bodies()[1].free_velocity_W).norm() > 0.1);
    const std::array<double, 1> friction{0.4};
    CHECK(compute_residual(problem, FrictionShape::cone, friction) > 0.1);
}
TEST_CASE("complementarity: what is no number does not read as an answer, wherever it stands") {
    CHECK(take_worse(1.0, 2.0) == 2.0);
    CHECK(take_worse(2.0, 1.0) == 2.0);
    CHECK(std::isnan(take_worse(kNan, 1.0)));
    CHECK(std::isnan(take_worse(1.0, kNan)));
    for (int k = 0; k < 3; ++k) {
        Vector3 y = Vector3::Zero();
        y[k] = kNan;
        CHECK(
            std::isnan(compute_residual(FrictionShape::cone, 0.5, 2.0, y, Vector3(1.0, 0.0, 0.0))));
    }
    // A bad contact before a good one, and after it.
    for (const std::size_t bad : {std::size_t{0}, std::size_t{1}}) {
        ContactProblem problem({1, 2, 0});
        problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
        for (int i = 0; i < 2; ++i) {
            problem.add_contact(on_ground());
        }
        problem.contacts()[bad].impulse_Ns.setConstant(kNan);
        const std::array<double, 2> friction{0.5, 0.5};
        CHECK_FALSE(compute_residual(problem, FrictionShape::cone, friction) <= 1.0);
    }
}
TEST_CASE("complementarity: the ground stands in the next problem, whatever was pushed into it") {
    ContactProblem problem({1, 0, 0});
    problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
    BodyMotion motion(1);
    motion.velocity(kGround).setConstant(kNan);
    apply_impulses(problem, motion);
    CHECK(motion.velocity(kGround) == Vector6(Vector6::Zero()));
}
