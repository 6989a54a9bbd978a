#include "haptics/constraint/contact_solver.h"

#include "tests/support/contact_scenes.h"
#include "tests/support/contact_stack.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kEdge_m = 0.1;
constexpr double kFriction = 0.5;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

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

ContactProblem cube_on_slope(double angle_rad, double friction, double dynamic_friction = -1.0) {
    ContactProblem problem({1, 4, 0});
    problem.add_body(2.0, cube_inertia(2.0, kEdge_m), moving({0.0, -kGravity * kStep_s, 0.0}));
    add_corners(problem, 0, kEdge_m, friction, slope_axes(angle_rad), dynamic_friction);
    return problem;
}

TEST_CASE("contact solver: a cube on a slope stays just below the angle of friction") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        // Rounds one after the other come to rest slowly this near to it.
        const double below = method == ContactMethod::iterative ? 1.0e-2 : 1.0e-6;
        ContactProblem problem = cube_on_slope(std::atan(kFriction) - below, kFriction);
        const SolveReport report = solve(problem, settings_of(method));
        CHECK(report.converged);
        CHECK(problem.bodies()[0].velocity_W.cwiseAbs().maxCoeff() <= kSolved);
        CHECK((sum_of_impulses(problem) - Vector3(0.0, 2.0 * kGravity * kStep_s, 0.0))
                  .cwiseAbs()
                  .maxCoeff() <= kSolved);
        CHECK_FALSE(problem.contacts()[0].slides);
    }
}

TEST_CASE("contact solver: beyond it the cube slides with g (sin - mu cos)") {
    const double angle = std::atan(kFriction) + 0.1;
    const double expected = kGravity * kStep_s * (std::sin(angle) - kFriction * std::cos(angle));
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem = cube_on_slope(angle, kFriction);
        const SolveReport report = solve(problem, settings_of(method));
        CHECK(report.converged);
        const Vector6& v = problem.bodies()[0].velocity_W;
        CHECK((v - moving(expected * slope_axes(angle).col(1))).cwiseAbs().maxCoeff() <= kSolved);
        CHECK(problem.contacts()[0].slides);
    }
}

TEST_CASE("contact solver: what begins to slide is held by the dynamic coefficient at once") {
    const double angle = std::atan(kFriction) + 0.1;
    const double expected = kGravity * kStep_s * (std::sin(angle) - 0.2 * std::cos(angle));
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem = cube_on_slope(angle, kFriction, 0.2);
        CHECK(solve(problem, settings_of(method)).converged);
        CHECK((problem.bodies()[0].velocity_W - moving(expected * slope_axes(angle).col(1)))
                  .cwiseAbs()
                  .maxCoeff() <= kSolved);
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

TEST_CASE("contact solver: a cube pushed sideways is slowed by mu g and comes to rest") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        for (const double speed : {1.0, 0.5 * kFriction * kGravity * kStep_s}) {
            ContactProblem problem({1, 4, 0});
            problem.add_body(2.0, cube_inertia(2.0, kEdge_m),
                             moving({speed, -kGravity * kStep_s, 0.0}));
            add_corners(problem, 0, kEdge_m, kFriction, make_contact_axes(Vector3::UnitY()));
            CHECK(solve(problem, settings_of(method)).converged);
            const double left = std::max(speed - kFriction * kGravity * kStep_s, 0.0);
            CHECK(
                (problem.bodies()[0].velocity_W - moving({left, 0.0, 0.0})).cwiseAbs().maxCoeff() <=
                kSolved);
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
            Matrix3 axes;
            axes << 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0;
            ContactConstraint c;
            c.body_b = 0;
            c.axes_W = axes;
            c.static_friction = c.dynamic_friction = kFriction;
            problem.add_contact(c);
            CHECK(solve(problem, settings_of(method, shape)).converged);
            const double held = 1.0 - problem.bodies()[0].velocity_W.head<3>().norm();
            const double factor = shape == FrictionShape::cone ? 1.0 : std::sqrt(2.0);
            CHECK(std::abs(held - factor * kFriction * kGravity * kStep_s) <= kSolved);
        }
    }
}

TEST_CASE("contact solver: two bodies on each other press with the weight above them") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem({2, 2, 0});
        const Vector6 fall = moving({0.0, -kGravity * kStep_s, 0.0});
        problem.add_body(3.0, ball_inertia(3.0, 0.1), fall);
        problem.add_body(5.0, ball_inertia(5.0, 0.1), fall);
        problem.add_contact(contact_at(kGround, Vector3::Zero(), 0, {0.0, 0.1, 0.0},
                                       Vector3::Zero(), Vector3::UnitY()));
        problem.add_contact(
            contact_at(0, {0.0, 0.1, 0.0}, 1, {0.0, 0.3, 0.0}, {0.0, 0.2, 0.0}, Vector3::UnitY()));
        CHECK(solve(problem, settings_of(method)).converged);
        CHECK(std::abs(problem.contacts()[0].impulse_Ns.x() - 8.0 * kGravity * kStep_s) <= kSolved);
        CHECK(std::abs(problem.contacts()[1].impulse_Ns.x() - 5.0 * kGravity * kStep_s) <= kSolved);
    }
}

TEST_CASE("contact solver: a ball between two walls that lean is pressed by both alike") {
    const double half = 0.6;  // radians of each wall from the plumb line
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem({1, 2, 0});
        problem.add_body(1.0, ball_inertia(1.0, 0.1), moving({0.0, -kGravity * kStep_s, 0.0}));
        for (const double side : {1.0, -1.0}) {
            const Vector3 normal(side * std::cos(half), std::sin(half), 0.0);
            problem.add_contact(
                contact_at(kGround, Vector3::Zero(), 0, Vector3::Zero(), -0.1 * normal, normal));
        }
        CHECK(solve(problem, settings_of(method)).converged);
        const double expected = kGravity * kStep_s / (2.0 * std::sin(half));
        CHECK(std::abs(problem.contacts()[0].impulse_Ns.x() - expected) <= kSolved);
        CHECK(std::abs(problem.contacts()[1].impulse_Ns.x() - expected) <= kSolved);
    }
}

TEST_CASE("contact solver: a gap may close within the step and no more; what parts is let go") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        for (const double speed : {-0.05, -0.5, 0.3}) {
            ContactProblem problem({1, 1, 0});
            problem.add_body(1.0, ball_inertia(1.0, 0.1), moving({0.0, speed, 0.0}));
            ContactConstraint c = contact_at(kGround, Vector3::Zero(), 0, {0.0, 0.1, 0.0},
                                             Vector3::Zero(), Vector3::UnitY());
            c.target_m_per_s.x() = -0.1;
            problem.add_contact(c);
            CHECK(solve(problem, settings_of(method)).converged);
            CHECK(std::abs(problem.bodies()[0].velocity_W.y() - std::max(speed, -0.1)) <= kSolved);
        }
    }
}

TEST_CASE("contact solver: a belt takes along what lies on it, by mu g at most") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem({1, 4, 0});
        problem.add_body(1.0, cube_inertia(1.0, kEdge_m), moving({0.0, -kGravity * kStep_s, 0.0}));
        add_corners(problem, 0, kEdge_m, kFriction, make_contact_axes(Vector3::UnitY()));
        const Vector3 belt(1.0, 0.0, 0.0);
        for (ContactConstraint& contact : problem.contacts()) {
            contact.target_m_per_s = contact.axes_W.transpose() * belt;
        }
        CHECK(solve(problem, settings_of(method)).converged);
        CHECK((problem.bodies()[0].velocity_W - moving(kFriction * kGravity * kStep_s * belt))
                  .cwiseAbs()
                  .maxCoeff() <= kSolved);
    }
}

TEST_CASE("contact solver: a soft contact gives way by R p") {
    constexpr double kSoftness = 0.25;
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem({1, 1, 0});
        problem.add_body(2.0, ball_inertia(2.0, 0.1), moving({0.0, -1.0, 0.0}));
        ContactConstraint c = contact_at(kGround, Vector3::Zero(), 0, {0.0, 0.1, 0.0},
                                         Vector3::Zero(), Vector3::UnitY());
        c.softness_per_kg = kSoftness;
        problem.add_contact(c);
        CHECK(solve(problem, settings_of(method)).converged);
        const double impulse = 1.0 / (0.5 + kSoftness);
        CHECK(std::abs(problem.contacts()[0].impulse_Ns.x() - impulse) <= kSolved);
        CHECK(std::abs(problem.bodies()[0].velocity_W.y() + kSoftness * impulse) <= kSolved);
    }
}

TEST_CASE("contact solver: rows hold, and bounded ones no more than their bounds") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem({2, 0, 5});
        problem.add_body(1.0, ball_inertia(1.0, 0.1), moving({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}));
        problem.add_body(2.0, ball_inertia(2.0, 0.1), moving({-1.0, 0.5, 0.0}));
        // A ball joint half way, a motor with little torque, and a limit that pushes one way.
        const Vector3 arm(0.2, 0.0, 0.0);
        for (int k = 0; k < 3; ++k) {
            RowConstraint row;
            row.body_a = 0;
            row.body_b = 1;
            const Vector3 axis = Vector3::Unit(k);
            row.jacobian_a << -axis, -arm.cross(axis);
            row.jacobian_b << axis, -arm.cross(axis);
            row.least = -HUGE_VAL;
            row.most = HUGE_VAL;
            problem.add_row(row);
        }
        RowConstraint motor;
        motor.body_a = 0;
        motor.body_b = 1;
        motor.jacobian_a << Vector3::Zero(), -Vector3::UnitZ();
        motor.jacobian_b << Vector3::Zero(), Vector3::UnitZ();
        motor.target = 50.0;
        motor.least = -0.001;
        motor.most = 0.001;
        problem.add_row(motor);
        RowConstraint limit;
        limit.body_b = 1;
        limit.jacobian_b << Vector3::UnitX(), Vector3::Zero();
        limit.target = 0.25;
        limit.most = HUGE_VAL;
        problem.add_row(limit);
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

TEST_CASE("contact solver: the next step takes the last one's impulses as they are") {
    ContactProblem problem = cube_on_slope(0.3, kFriction);
    ContactSolver solver(settings_of(ContactMethod::newton), problem.capacity());
    CHECK(solver.solve(problem).n_iterations > 0);
    const SolveReport again = solver.solve(problem);
    CHECK(again.converged);
    CHECK(again.n_iterations == 0);
}

TEST_CASE("contact solver: of a problem beyond its capacity it says so") {
    ContactProblem problem = cube_on_slope(0.3, kFriction);
    const Vector6 free = problem.bodies()[0].velocity_W;
    ContactSolver solver(settings_of(ContactMethod::newton), {1, 3, 0});
    CHECK_FALSE(solver.solve(problem).converged);
    CHECK(problem.bodies()[0].velocity_W == free);
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
    CHECK(validate(ContactSolverSettings{}).has_value());
    const auto refused = [](auto change) {
        ContactSolverSettings settings;
        change(settings);
        return !validate(settings).has_value();
    };
    CHECK(refused([](ContactSolverSettings& s) { s.tolerance_m_per_s = kNone; }));
    CHECK(refused([](ContactSolverSettings& s) { s.tolerance_m_per_s = 0.0; }));
    CHECK(refused([](ContactSolverSettings& s) { s.max_iterations = 0; }));
    CHECK(refused([](ContactSolverSettings& s) { s.friction_rounds = 0; }));
    CHECK(refused([](ContactSolverSettings& s) { s.most_exact_contacts = 0; }));
    CHECK(refused([](ContactSolverSettings& s) { s.relaxation = 2.0; }));
    CHECK(refused([](ContactSolverSettings& s) { s.stiffening = 0.0; }));
}

TEST_CASE("contact solver: a soft contact that slides gives way by R p along its tangents too") {
    constexpr double kSoftness = 0.4;
    constexpr double kMass_kg = 2.0;
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem({1, 1, 0});
        problem.add_body(kMass_kg, ball_inertia(kMass_kg, 0.1), moving({3.0, -1.0, 0.0}));
        ContactConstraint c;
        c.body_b = 0;
        c.axes_W.col(0) = Vector3::UnitY();
        c.axes_W.col(1) = Vector3::UnitX();
        c.axes_W.col(2) = -Vector3::UnitZ();
        c.static_friction = c.dynamic_friction = kFriction;
        c.softness_per_kg = kSoftness;
        problem.add_contact(c);
        const SolveReport report = solve(problem, settings_of(method));
        CHECK(report.converged);
        CHECK(report.n_regularised == 0);
        // u_n + R p_n = 0, p_t = -mu p_n: no lift by the slip.
        const double impulse = 1.0 / (1.0 / kMass_kg + kSoftness);
        CHECK(std::abs(problem.contacts()[0].impulse_Ns.x() - impulse) <= kSolved);
        CHECK(std::abs(problem.bodies()[0].velocity_W.x() -
                       (3.0 - kFriction * impulse / kMass_kg)) <= kSolved);
    }
}

TEST_CASE("contact solver: a soft row gives way by R p") {
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem({1, 0, 1});
        problem.add_body(2.0, ball_inertia(2.0, 0.1), moving({1.0, 0.0, 0.0}));
        RowConstraint row;
        row.body_b = 0;
        row.jacobian_b << Vector3::UnitX(), Vector3::Zero();
        row.least = -HUGE_VAL;
        row.most = HUGE_VAL;
        row.softness = 0.25;
        problem.add_row(row);
        CHECK(solve(problem, settings_of(method)).converged);
        CHECK(std::abs(problem.rows()[0].impulse + 1.0 / 0.75) <= kSolved);
        CHECK(std::abs(problem.bodies()[0].velocity_W.x() - 0.25 / 0.75) <= kSolved);
    }
}

}  // namespace
}  // namespace fulcrum
