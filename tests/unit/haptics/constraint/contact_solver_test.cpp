#include "haptics/constraint/contact_solver.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"
#include "tests/support/refused.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <rapidcheck.h>
#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kEdge_m = 0.1;
constexpr double kFriction = 0.5;
constexpr double kGained_m_per_s = kGravity * kStep_s;
const Vector3 kGained(0.0, -kGained_m_per_s, 0.0);  // by falling for a step

// Axes of a slope that falls towards its first tangent.
Matrix3 slope_axes(double angle_rad) {
    const double s = std::sin(angle_rad);
    const double c = std::cos(angle_rad);
    Matrix3 axes;
    axes.col(0) = Vector3(s, c, 0.0);
    axes.col(1) = Vector3(c, -s, 0.0);
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

// A cube of 2 kg that falls for a step.
ContactProblem cube_on_slope(double angle_rad, double friction, double dynamic_friction = -1.0,
                             const Vector3& velocity = Vector3::Zero()) {
    ContactProblem problem({1, 4, 0});
    problem.add_body(2.0, cube_inertia(2.0, kEdge_m), moving(velocity + kGained));
    add_corners(problem, 0, kEdge_m, friction, slope_axes(angle_rad), dynamic_friction);
    return problem;
}

// A ball on what pushes it along each of the normals.
ContactProblem ball_on(double mass_kg, const Vector3& velocity, const std::vector<Vector3>& normals,
                       double gap_m_per_s = 0.0, double softness_per_kg = 0.0) {
    ContactProblem problem({1, 2, 1});
    problem.add_body(mass_kg, ball_inertia(mass_kg, 0.1), moving(velocity));
    for (const Vector3& normal : normals) {
        ContactConstraint c =
            contact_at(kGround, Vector3::Zero(), 0, Vector3::Zero(), -0.1 * normal, normal);
        c.target_m_per_s.x() = -gap_m_per_s;
        c.softness_per_kg = softness_per_kg;
        problem.add_contact(c);
    }
    return problem;
}

// What a problem's first body and its first contacts must be told, by each method.
void check_answer(const char* name, const ContactProblem& posed, const Vector3& velocity,
                  const std::vector<double>& pushes_Ns = {}) {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(name, to_string(method));
        ContactProblem problem = posed;
        const SolveReport report = solve(problem, settings_of(method));
        CHECK(report.converged);
        // A cube's four corners are one more than hold it.
        CHECK((problem.contacts().size() > 2 || report.n_regularised == 0));
        CHECK(find_apart(problem.bodies()[0].velocity_W, moving(velocity)) <= kSolved);
        for (std::size_t k = 0; k < pushes_Ns.size(); ++k) {
            CHECK(std::abs(problem.contacts()[k].impulse_Ns.x() - pushes_Ns[k]) <= kSolved);
        }
    }
}

TEST_CASE("contact solver: a cube on a slope slides with g (sin - mu cos), a belt takes it along") {
    const double angle = std::atan(kFriction) + 0.1;
    const auto sliding = [&](double friction) {
        const double gained = kGained_m_per_s * (std::sin(angle) - friction * std::cos(angle));
        return Vector3(gained * slope_axes(angle).col(1));
    };
    check_answer("beyond the angle of friction", cube_on_slope(angle, kFriction),
                 sliding(kFriction));
    check_answer("held by the dynamic coefficient at once", cube_on_slope(angle, kFriction, 0.2),
                 sliding(0.2));
    for (const double speed : {1.0, 0.5 * kFriction * kGained_m_per_s}) {
        const double left = std::max(speed - kFriction * kGained_m_per_s, 0.0);
        check_answer("pushed sideways: slowed by mu g, to rest at most",
                     cube_on_slope(0.0, kFriction, -1.0, {speed, 0.0, 0.0}), {left, 0.0, 0.0});
    }
    ContactProblem on_belt = cube_on_slope(0.0, kFriction);
    for (ContactConstraint& contact : on_belt.contacts()) {
        contact.target_m_per_s = contact.axes_W.transpose() * Vector3::UnitX();
    }
    check_answer("on a belt: by mu g at most", on_belt, {kFriction * kGained_m_per_s, 0.0, 0.0});
}

TEST_CASE("contact solver: balls press, part and give way in closed form") {
    constexpr double kHalf_rad = 0.6;  // of each of two walls that lean, from the plumb line
    const double side = std::cos(kHalf_rad);
    const double up = std::sin(kHalf_rad);
    const double each_Ns = kGained_m_per_s / (2.0 * up);
    check_answer("between walls that lean: by both alike",
                 ball_on(1.0, kGained, {{side, up, 0.0}, {-side, up, 0.0}}), Vector3::Zero(),
                 {each_Ns, each_Ns});
    for (const double speed : {-0.05, -0.5, 0.3}) {
        check_answer("a gap may close within the step and no more; what parts is let go",
                     ball_on(1.0, {0.0, speed, 0.0}, {Vector3::UnitY()}, 0.1),
                     {0.0, std::max(speed, -0.1), 0.0});
    }
    constexpr double kSoft_Ns = 1.0 / (0.5 + 0.25);
    check_answer("a soft contact gives way by R p",
                 ball_on(2.0, {0.0, -1.0, 0.0}, {Vector3::UnitY()}, 0.0, 0.25),
                 {0.0, -0.25 * kSoft_Ns, 0.0}, {kSoft_Ns});
    // u_n + R p_n = 0, p_t = -mu p_n: no lift by the slip.
    constexpr double kSlid_Ns = 1.0 / (0.5 + 0.4);
    ContactProblem slides = ball_on(2.0, {3.0, -1.0, 0.0}, {Vector3::UnitY()}, 0.0, 0.4);
    slides.contacts()[0].arm_b.setZero();
    slides.contacts()[0].axes_W = slope_axes(0.0);
    slides.contacts()[0].static_friction = slides.contacts()[0].dynamic_friction = kFriction;
    check_answer("a soft contact that slides, along its tangents too", slides,
                 {3.0 - kFriction * kSlid_Ns / 2.0, -0.4 * kSlid_Ns, 0.0}, {kSlid_Ns});
    ContactProblem pair({2, 2, 0});
    pair.add_body(3.0, ball_inertia(3.0, 0.1), moving(kGained));
    pair.add_body(5.0, ball_inertia(5.0, 0.1), moving(kGained));
    const Vector3 low(0.0, 0.1, 0.0);
    pair.add_contact(
        contact_at(kGround, Vector3::Zero(), 0, low, Vector3::Zero(), Vector3::UnitY()));
    pair.add_contact(contact_at(0, low, 1, 3.0 * low, 2.0 * low, Vector3::UnitY()));
    check_answer("on each other: with the weight above them", pair, Vector3::Zero(),
                 {8.0 * kGained_m_per_s, 5.0 * kGained_m_per_s});
    ContactProblem tied = ball_on(2.0, {1.0, 0.0, 0.0}, {});
    RowConstraint row = tie_down(0, moving(Vector3::UnitX()));
    row.softness = 0.25;
    tied.add_row(row);
    check_answer("a soft row gives way by R p", tied, {0.25 / 0.75, 0.0, 0.0});
    for (const ContactMethod method : kContactMethods) {
        ContactProblem problem = tied;
        (void)solve(problem, settings_of(method));
        CHECK(std::abs(problem.rows()[0].impulse + 1.0 / 0.75) <= kSolved);
    }
}

TEST_CASE("contact solver: a cube stays just below the angle of friction, and slides beyond it") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        // Rounds one after the other come to rest slowly this near to it.
        const double below = method == ContactMethod::iterative ? 1.0e-2 : 1.0e-6;
        ContactProblem problem = cube_on_slope(std::atan(kFriction) - below, kFriction);
        CHECK(solve(problem, settings_of(method)).converged);
        CHECK(find_apart(problem.bodies()[0].velocity_W, Vector6::Zero()) <= kSolved);
        CHECK((sum_of_impulses(problem) + 2.0 * kGained).cwiseAbs().maxCoeff() <= kSolved);
        CHECK_FALSE(problem.contacts()[0].slides);
        ContactProblem beyond = cube_on_slope(std::atan(kFriction) + 0.1, kFriction);
        (void)solve(beyond, settings_of(method));
        CHECK(beyond.contacts()[0].slides);
    }
}

TEST_CASE("contact solver: between the two angles a cube stays if it lay and slides if it slid") {
    const double angle = std::atan(0.5 * (kFriction + 0.2));
    for (const ContactMethod method : kContactMethods) {
        for (const bool slid : {false, true}) {
            CAPTURE(to_string(method), slid);
            ContactProblem problem = cube_on_slope(angle, kFriction, 0.2);
            for (ContactConstraint& contact : problem.contacts()) {
                contact.slides = slid;
            }
            CHECK(solve(problem, settings_of(method)).converged);
            CHECK((problem.bodies()[0].velocity_W.head<3>().norm() > 1.0e-4) == slid);
        }
    }
}
TEST_CASE("contact solver: the cone holds alike in all directions, the pyramid more across") {
    const double across = std::sqrt(0.5);
    for (const ContactMethod method : kContactMethods) {
        for (const FrictionShape shape : {FrictionShape::cone, FrictionShape::pyramid}) {
            if (method == ContactMethod::dantzig && shape == FrictionShape::cone) {
                continue;  // it has the pyramid alone
            }
            CAPTURE(to_string(method));
            ContactProblem problem({1, 4, 0});
            problem.add_body(1.0, cube_inertia(1.0, 0.001),  // so small that it cannot tilt
                             moving({across, -kGravity * kStep_s, across}));
            ContactConstraint c;
            c.body_b = 0;
            c.axes_W = slope_axes(0.0);
            c.static_friction = c.dynamic_friction = kFriction;
            problem.add_contact(c);
            CHECK(solve(problem, settings_of(method, shape)).converged);
            const double held = 1.0 - problem.bodies()[0].velocity_W.head<3>().norm();
            const double factor = shape == FrictionShape::cone ? 1.0 : std::sqrt(2.0);
            CHECK(std::abs(held - factor * kFriction * kGravity * kStep_s) <= kSolved);
        }
    }
}

TEST_CASE("contact solver: rows hold, and bounded ones no more than their bounds") {
    // A ball joint half way, a motor with little torque, and a limit that pushes one way.
    ContactProblem posed({2, 0, 5});
    posed.add_body(1.0, ball_inertia(1.0, 0.1), moving({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}));
    posed.add_body(2.0, ball_inertia(2.0, 0.1), moving({-1.0, 0.5, 0.0}));
    const Vector3 arm(0.2, 0.0, 0.0);
    for (int k = 0; k < 3; ++k) {
        posed.add_row(hold_along(Vector3::Unit(k), 0, arm, 1, -arm));
    }
    const Vector6 turn = moving(Vector3::Zero(), Vector3::UnitZ());
    RowConstraint motor = tie(0, -turn, 1, turn);
    motor.target = 50.0;
    motor.least = -0.001;
    motor.most = 0.001;
    posed.add_row(motor);
    RowConstraint limit = tie_down(1, moving(Vector3::UnitX()));
    limit.target = 0.25;
    limit.least = 0.0;
    posed.add_row(limit);
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem = posed;
        CHECK(solve(problem, settings_of(method)).converged);
        const Vector6& a = problem.bodies()[0].velocity_W;
        const Vector6& b = problem.bodies()[1].velocity_W;
        const Vector3 at_a = a.head<3>() + a.tail<3>().cross(arm);
        const Vector3 at_b = b.head<3>() - b.tail<3>().cross(arm);
        CHECK((at_a - at_b).cwiseAbs().maxCoeff() <= kSolved);
        CHECK(problem.rows()[3].impulse == 0.001);
        CHECK(b.x() >= 0.25 - kSolved);
        CHECK(problem.rows()[4].impulse >= 0.0);
    }
}

TEST_CASE("contact solver: a row that moves nothing is left alone") {
    ContactProblem problem = ball_on(1.0, {1.0, 0.0, 0.0}, {});
    RowConstraint row = tie_down(0, Vector6::Zero());
    row.target = 5.0;
    problem.add_row(row);
    for (const ContactMethod method : kContactMethods) {
        CHECK(solve(problem, settings_of(method)).converged);
        CHECK(problem.rows()[0].impulse == 0.0);
        CHECK(problem.bodies()[0].velocity_W == moving({1.0, 0.0, 0.0}));
    }
}

TEST_CASE("contact solver: the next step takes the last impulses as they are, if there is room") {
    ContactProblem problem = cube_on_slope(0.3, kFriction);
    const Vector6 free = problem.bodies()[0].velocity_W;
    ContactSolver small(settings_of(ContactMethod::newton), {1, 3, 0});
    CHECK_FALSE(small.solve(problem).converged);
    CHECK(problem.bodies()[0].velocity_W == free);
    ContactSolver solver(settings_of(ContactMethod::newton), problem.capacity());
    CHECK(solver.solve(problem).n_iterations > 0);
    const SolveReport again = solver.solve(problem);
    CHECK(again.converged);
    CHECK(again.n_iterations == 0);
}

TEST_CASE("contact solver: what Newton does not find is pivoted, where there are few rows") {
    ContactSolverSettings settings = settings_of(ContactMethod::newton);
    settings.max_iterations = 1;
    settings.tolerance_m_per_s = 1.0e-8;
    // Dropped, 4 contacts a cube: 12 rows each.
    for (const int n_cubes : {kMostPivotRows / 12, kMostPivotRows / 12 + 1}) {
        CAPTURE(n_cubes);
        ContactStack stack({.n_cubes = n_cubes, .start_gap_m = 1.0e-6}, settings);
        stack.prepare();
        const SolveReport report = stack.solve();
        const bool may_pivot = 12 * n_cubes <= kMostPivotRows;
        CHECK(report.converged == may_pivot);
        CHECK(report.n_pivoted == (may_pivot ? 1 : 0));
    }
    ContactProblem slope = cube_on_slope(0.3, kFriction);
    CHECK(solve(slope, settings_of(ContactMethod::newton)).n_pivoted == 0);
}

TEST_CASE("contact solver: methods are found by name, and settings outside their ranges refused") {
    for (const ContactMethod method : kContactMethods) {
        CHECK(find_contact_method(to_string(method)).value() == method);
    }
    CHECK(find_contact_method("simplex").error().what_to_do.find("newton") != std::string::npos);
    using S = ContactSolverSettings;
    check_refused(S{}, {{&S::tolerance_m_per_s, std::nan("")},
                        {&S::tolerance_m_per_s, 0.0},
                        {&S::max_iterations, 0},
                        {&S::friction_rounds, 0},
                        {&S::most_exact_contacts, 0},
                        {&S::relaxation, 2.0},
                        {&S::stiffening, 0.0}});
}

// Bounded work on many contacts.
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
        for (ConstrainedBody& body : problem.bodies()) {
            body.velocity_W = body.free_velocity_W;
        }
        const double before_J = compute_kinetic_energy_J(problem);
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
