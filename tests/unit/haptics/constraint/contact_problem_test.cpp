#include "haptics/constraint/contact_problem.h"

#include "tests/support/contact_scenes.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kExact = 1.0e-15;

TEST_CASE("contact problem: a full one drops and counts") {
    ContactProblem problem({1, 1, 1});
    const Matrix3 inertia = Matrix3::Identity();
    CHECK(problem.add_body(1.0, inertia, Vector6::Zero()) == 0);
    CHECK(problem.add_body(1.0, inertia, Vector6::Zero()) == kGround);
    ContactConstraint contact;
    contact.body_b = 0;
    CHECK(problem.add_contact(contact));
    CHECK_FALSE(problem.add_contact(contact));
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

TEST_CASE("contact problem: what is no body is refused") {
    ContactProblem problem({8, 0, 0});
    const Matrix3 inertia = Matrix3::Identity();
    CHECK(problem.add_body(0.0, inertia, Vector6::Zero()) == kGround);
    CHECK(problem.add_body(-1.0, inertia, Vector6::Zero()) == kGround);
    CHECK(problem.add_body(kNone, inertia, Vector6::Zero()) == kGround);
    CHECK(problem.add_body(1.0, Matrix3::Zero(), Vector6::Zero()) == kGround);
    CHECK(problem.add_body(1.0, kNone * inertia, Vector6::Zero()) == kGround);
    CHECK(problem.add_body(1.0, inertia, Vector6::Constant(kNone)) == kGround);
    CHECK(problem.bodies().empty());
    CHECK(problem.n_dropped() == 6);
}

TEST_CASE("contact problem: what joins no two bodies or has no numbers is refused") {
    ContactProblem problem({2, 8, 8});
    problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
    const auto refused = [&](auto change) {
        ContactConstraint contact;
        contact.body_b = 0;
        change(contact);
        return !problem.add_contact(contact);
    };
    CHECK(refused([](ContactConstraint& c) { c.body_b = kGround; }));
    CHECK(refused([](ContactConstraint& c) { c.body_b = 1; }));
    CHECK(refused([](ContactConstraint& c) { c.body_a = -2; }));
    CHECK(refused([](ContactConstraint& c) { c.arm_b.x() = kNone; }));
    CHECK(refused([](ContactConstraint& c) { c.axes_W(1, 1) = kNone; }));
    CHECK(refused([](ContactConstraint& c) { c.target_m_per_s.z() = HUGE_VAL; }));
    CHECK(refused([](ContactConstraint& c) { c.static_friction = -0.1; }));
    CHECK(refused([](ContactConstraint& c) { c.dynamic_friction = kNone; }));
    CHECK(refused([](ContactConstraint& c) { c.softness_per_kg = -1.0; }));
    const auto row_refused = [&](auto change) {
        RowConstraint row;
        row.body_b = 0;
        change(row);
        return !problem.add_row(row);
    };
    CHECK(row_refused([](RowConstraint& r) { r.least = 1.0; }));
    CHECK(row_refused([](RowConstraint& r) { r.least = r.most = HUGE_VAL; }));
    CHECK(row_refused([](RowConstraint& r) { r.jacobian_b.setConstant(kNone); }));
    CHECK(row_refused([](RowConstraint& r) { r.target = kNone; }));
    CHECK(row_refused([](RowConstraint& r) { r.softness = kNone; }));
    CHECK(problem.n_dropped() == 14);
}

TEST_CASE("contact problem: what was remembered and is no number is forgotten") {
    ContactProblem problem({1, 1, 1});
    problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero());
    ContactConstraint contact;
    contact.body_b = 0;
    contact.impulse_Ns.setConstant(kNone);
    contact.static_friction = 0.2;
    contact.dynamic_friction = 0.7;
    CHECK(problem.add_contact(contact));
    CHECK(problem.contacts()[0].impulse_Ns == Vector3(Vector3::Zero()));
    CHECK(problem.contacts()[0].dynamic_friction == 0.2);
    RowConstraint row;
    row.body_b = 0;
    row.impulse = kNone;
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

TEST_CASE(
    "contact problem: an inertia that is not positive definite is refused, and so are weights "
    "beyond numbers") {
    ContactProblem problem({8, 8, 8});
    // Two moments below zero: the determinant is above it.
    CHECK(problem.add_body(1.0, Vector3(-1.0, -1.0, 1.0).asDiagonal(), Vector6::Zero()) == kGround);
    CHECK(problem.add_body(1.0, Vector3(1.0, -1.0, -1.0).asDiagonal(), Vector6::Zero()) == kGround);
    Matrix3 skewed = Matrix3::Identity();
    skewed(0, 1) = 0.5;
    CHECK(problem.add_body(1.0, skewed, Vector6::Zero()) == kGround);
    constexpr double kDenormal = 1.0e-310;
    CHECK(problem.add_body(kDenormal, Matrix3::Identity(), Vector6::Zero()) == kGround);
    REQUIRE(problem.add_body(1.0, Matrix3::Identity(), Vector6::Zero()) == 0);
    ContactConstraint contact;
    contact.body_b = 0;
    CHECK(problem.add_contact(contact));
    CHECK(problem.contacts()[0].weight_per_kg == 3.0);
    contact.arm_b.setConstant(1.0e200);
    CHECK_FALSE(problem.add_contact(contact));
    RowConstraint row;
    row.body_b = 0;
    row.jacobian_b.setConstant(1.0e200);
    CHECK_FALSE(problem.add_row(row));
    row.jacobian_b.setConstant(1.0e-160);
    CHECK_FALSE(problem.add_row(row));
    CHECK(problem.n_dropped() == 7);
}

}  // namespace
}  // namespace fulcrum
