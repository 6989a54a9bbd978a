#include "haptics/constraint/complementarity.h"

#include "tests/support/contact_scenes.h"

#include <catch2/catch.hpp>

#include <array>
#include <limits>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kExact = 1.0e-15;

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
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    CHECK(take_worse(1.0, 2.0) == 2.0);
    CHECK(take_worse(2.0, 1.0) == 2.0);
    CHECK(std::isnan(take_worse(kNone, 1.0)));
    CHECK(std::isnan(take_worse(1.0, kNone)));
    for (int k = 0; k < 3; ++k) {
        Vector3 y = Vector3::Zero();
        y[k] = kNone;
        CHECK(
            std::isnan(compute_residual(FrictionShape::cone, 0.5, 2.0, y, Vector3(1.0, 0.0, 0.0))));
    }
    // A bad contact before a good one, and after it.
    for (const std::size_t bad : {std::size_t{0}, std::size_t{1}}) {
        ContactProblem problem({1, 2, 0});
        problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
        for (int i = 0; i < 2; ++i) {
            ContactConstraint contact;
            contact.body_b = 0;
            problem.add_contact(contact);
        }
        problem.contacts()[bad].impulse_Ns.setConstant(kNone);
        const std::array<double, 2> friction{0.5, 0.5};
        CHECK_FALSE(compute_residual(problem, FrictionShape::cone, friction) <= 1.0);
    }
}

TEST_CASE("complementarity: the ground stands in the next problem, whatever was pushed into it") {
    ContactProblem problem({1, 0, 0});
    problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
    BodyMotion motion(1);
    motion.velocity(kGround).setConstant(std::numeric_limits<double>::quiet_NaN());
    apply_impulses(problem, motion);
    CHECK(motion.velocity(kGround) == Vector6(Vector6::Zero()));
}

}  // namespace
}  // namespace fulcrum
