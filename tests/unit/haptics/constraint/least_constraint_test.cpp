#include "haptics/constraint/least_constraint.h"

#include "haptics/math/to_eigen.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/wilhelmsen.h"
#include "tests/unit/haptics/constraint/held_tool.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

using namespace held_tool;

struct Contact {
    Vector3 arm_W, normal_W;
    double least = 0.0;
};

Matrix3 bar_inertia() {
    return Vector3(2.0e-5, 8.0e-5, 8.0e-5).asDiagonal();
}

LeastConstraintSolver solver_of(const std::vector<Contact>& contacts,
                                const Matrix3& inertia = bar_inertia()) {
    LeastConstraintSolver solver(contacts.size());
    REQUIRE(solver.set_inertia(kMass_kg, inertia));
    for (const Contact& c : contacts) {
        REQUIRE(solver.add(c.arm_W, c.normal_W, c.least));
    }
    return solver;
}

Matrix6 inertia_of(const Matrix3& inertia) {
    Matrix6 M = Matrix6::Zero();
    M.diagonal().head<3>().setConstant(kMass_kg);
    M.bottomRightCorner<3, 3>() = inertia;
    return M;
}

// The size that counts for the tool: of its kinetic energy.
double size_of(const Matrix3& inertia, const Vector6& a) {
    return std::sqrt(a.dot(inertia_of(inertia) * a));
}

// No bound is missed, no contact pulls, none pushes that parts, and the forces are all that changes the motion.
void check_optimal(const std::vector<Contact>& contacts, const Matrix3& inertia,
                   const LeastConstraintSolver& solver, const LeastConstraint& answer,
                   const Vector6& wanted) {
    REQUIRE(answer.exact);
    const double scale = size_of(inertia, wanted) + 1.0e-12;
    const Eigen::LLT<Eigen::Matrix<double, 6, 6>> factor(to_eigen(inertia_of(inertia)));
    Vector6 force = Vector6::Zero();
    double pushes = 0.0;  // which may be far more than their sum, where the tool is stuck
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Vector6 J = along(contacts[k].arm_W, contacts[k].normal_W);
        const double length = factor.matrixL().solve(to_eigen(J)).norm();
        const double slack = (J.dot(answer.acceleration) - contacts[k].least) / length;
        const double push = solver.force_N(k);
        REQUIRE(slack >= -1.0e-12 * scale);
        REQUIRE(push >= 0.0);
        REQUIRE((push == 0.0 || std::abs(slack) <= 1.0e-12 * scale));
        force += push * J;
        pushes += push * length;
    }
    const Vector6 change = inertia_of(inertia) * (answer.acceleration - wanted);
    REQUIRE(factor.matrixL().solve(to_eigen(Vector6(change - force))).norm() <=
            1.0e-12 * scale + 1.0e-13 * pushes);
    REQUIRE((answer.force - force).norm() <= 1.0e-10 * (force.norm() + pushes + 1.0e-12));
}

TEST_CASE("least constraint: free of contacts it is what is wanted, to the bit, without a force") {
    LeastConstraintSolver solver = solver_of({{{0.1, 0.0, 0.0}, Vector3::UnitY()}});
    const Vector6 up = six({0.3, 0.4, -0.5}, {0.01, 0.02, 0.03});
    const LeastConstraint& answer = solver.solve(up);
    CHECK(answer.acceleration == up);
    CHECK(answer.force == Vector6::Zero());
    CHECK(answer.acting == 0);
    CHECK(answer.exact);
}

TEST_CASE("least constraint: on a plane, in a corner and a slot the force is that of mechanics") {
    const double kExact = 1.0e-14;
    SECTION("a ball's middle over its contact: the normal part is gone, the rest stays") {
        LeastConstraintSolver solver = solver_of({{{0.0, -0.02, 0.0}, Vector3::UnitY()}});
        const LeastConstraint& answer = solver.solve(six({1.0, -2.0, 3.0}, {4.0, 5.0, 6.0}));
        CHECK((answer.acceleration - six({1.0, 0.0, 3.0}, {4.0, 5.0, 6.0})).norm() <= kExact);
        CHECK((answer.force - six({0.0, 2.0 * kMass_kg, 0.0})).norm() <= kExact);
        CHECK(solver.force_N(0) == Approx(2.0 * kMass_kg).epsilon(1.0e-14));
    }
    SECTION("at one end of a bar: lambda = a_n / (1/m + d^2 / I)") {
        constexpr double kArm_m = 0.06;
        LeastConstraintSolver solver = solver_of({{{kArm_m, 0.0, 0.0}, Vector3::UnitY()}});
        const LeastConstraint& answer = solver.solve(six({0.0, -1.0, 0.0}));
        const double lambda = 1.0 / (1.0 / kMass_kg + kArm_m * kArm_m / 8.0e-5);
        CHECK(solver.force_N(0) == Approx(lambda).epsilon(1.0e-14));
        CHECK(answer.acceleration[1] == Approx(-1.0 + lambda / kMass_kg).epsilon(1.0e-14));
        CHECK(answer.acceleration[5] == Approx(kArm_m * lambda / 8.0e-5).epsilon(1.0e-14));
    }
    SECTION("three walls of a corner through the middle: only motion out of it is left") {
        LeastConstraintSolver solver = solver_of({{Vector3::Zero(), Vector3::UnitX()},
                                                  {Vector3::Zero(), Vector3::UnitY()},
                                                  {Vector3::Zero(), Vector3::UnitZ()}});
        const LeastConstraint& answer = solver.solve(six({-1.0, -2.0, 0.5}, {1.0, 2.0, 3.0}));
        CHECK((answer.acceleration - six({0.0, 0.0, 0.5}, {1.0, 2.0, 3.0})).norm() <= kExact);
        CHECK(answer.acting == 2);
    }
    SECTION("in a slot nothing holds along it") {
        LeastConstraintSolver solver = solver_of(
            {{{0.0, -0.01, 0.0}, Vector3::UnitY()}, {{0.0, 0.01, 0.0}, -Vector3::UnitY()}});
        const LeastConstraint& answer = solver.solve(six({1.0, -7.0, 2.0}));
        CHECK((answer.acceleration - six({1.0, 0.0, 2.0})).norm() <= kExact);
    }
    SECTION("a gap may be closed first: least = -gap / time^2") {
        LeastConstraintSolver solver = solver_of({{{0.0, -0.02, 0.0}, Vector3::UnitY(), -0.5}});
        CHECK(solver.solve(six({0.0, -0.4, 0.0})).acting == 0);
        CHECK(solver.solve(six({0.0, -2.0, 0.0})).acceleration[1] == Approx(-0.5).epsilon(1.0e-14));
    }
}

TEST_CASE("least constraint: the same point as Wilhelmsen's, to 1e-12, for any contacts") {
    Chance random(7);
    for (int trial = 0; trial < 2000; ++trial) {
        const Vector3 axes(random.draw(1.0e-6, 1.0e-3), random.draw(1.0e-6, 1.0e-3),
                           random.draw(1.0e-6, 1.0e-3));
        const Matrix3 turn =
            Quaternion(random.draw(-1, 1), random.draw(-1, 1), random.draw(-1, 1), 1.0)
                .normalized()
                .toRotationMatrix();
        const Matrix3 inertia = turn * axes.asDiagonal() * turn.transpose();
        const int n = 1 + trial % 40;
        std::vector<Contact> contacts;
        for (int k = 0; k < n; ++k) {
            // All kinds: any direction, one side only, doubled, in one plane.
            const int kind = trial % 4;
            Vector3 normal = random.draw_direction();
            Vector3 arm = random.draw_vector(0.1);
            if (kind == 1) {
                normal = (normal + 2.0 * Vector3::UnitY()).normalized();
            } else if (kind == 2 && k % 2 == 1) {
                contacts.push_back(contacts.back());
                continue;
            } else if (kind == 3) {
                normal = Vector3::UnitY();
                arm.y() = -0.02;
            }
            contacts.push_back({arm, normal});
        }
        LeastConstraintSolver solver = solver_of(contacts, inertia);
        const Vector6 wanted = six(random.draw_vector(10.0), random.draw_vector(100.0));
        const LeastConstraint answer = solver.solve(wanted);
        check_optimal(contacts, inertia, solver, answer, wanted);

        using wilhelmsen::Real;
        const auto to_real = [](const Vector6& v) { return to_eigen(v.cast<Real>()); };
        const auto M = to_eigen(inertia_of(inertia).cast<Real>());
        const Eigen::Matrix<Real, 6, 6> L = M.llt().matrixL();
        std::vector<wilhelmsen::Vector> generators;
        for (const Contact& c : contacts) {
            generators.emplace_back(
                L.triangularView<Eigen::Lower>().solve(to_real(along(c.arm_W, c.normal_W))));
        }
        const wilhelmsen::Vector y = L.transpose() * to_real(wanted);
        const wilhelmsen::Vector at = y + wilhelmsen::nearest_in_cone(generators, -y);
        const wilhelmsen::Vector ours = L.transpose() * to_real(answer.acceleration);
        INFO("trial " << trial << ", " << n << " contacts");
        REQUIRE(static_cast<double>((ours - at).norm() / y.norm()) <= 1.0e-12);
    }
}

TEST_CASE("least constraint: bounds of any height that can be kept are kept, the nearest way") {
    Chance random(11);
    for (int trial = 0; trial < 500; ++trial) {
        std::vector<Contact> contacts;
        // Some motion keeps them all.
        const Vector6 good = six(random.draw_vector(5.0), random.draw_vector(50.0));
        for (int k = 0; k < 12; ++k) {
            Contact c{random.draw_vector(0.05), random.draw_direction()};
            c.least =
                along(c.arm_W, c.normal_W).dot(good) - (k % 3 == 0 ? 0.0 : random.draw(0.0, 2.0));
            contacts.push_back(c);
        }
        LeastConstraintSolver solver = solver_of(contacts);
        const Vector6 wanted = six(random.draw_vector(10.0), random.draw_vector(100.0));
        const LeastConstraint answer = solver.solve(wanted);
        check_optimal(contacts, bar_inertia(), solver, answer, wanted);
        CHECK(size_of(bar_inertia(), answer.acceleration - wanted) <=
              size_of(bar_inertia(), good - wanted) * (1.0 + 1.0e-12));
    }
}

TEST_CASE("least constraint: a thousand contacts of one plane are as good as three") {
    Chance random(3);
    std::vector<Contact> contacts;
    for (int k = 0; k < 1000; ++k) {
        // As a mesh tells them: each with its own rounding.
        contacts.push_back({{random.draw(-0.05, 0.05), -0.02, random.draw(-0.05, 0.05)},
                            Vector3(random.draw(-1e-15, 1e-15), 1.0, random.draw(-1e-15, 1e-15))});
    }
    LeastConstraintSolver solver = solver_of(contacts);
    for (int i = 0; i < 100; ++i) {
        const Vector6 wanted =
            six({random.draw(-1, 1), -3.0, random.draw(-1, 1)},
                {random.draw(-20, 20), random.draw(-20, 20), random.draw(-20, 20)});
        const LeastConstraint answer = solver.solve(wanted);
        check_optimal(contacts, bar_inertia(), solver, answer, wanted);
        CHECK(answer.acting <= 6);
        // Along the plane nothing holds it.
        CHECK(std::abs(answer.acceleration[0] - wanted[0]) <= 1.0e-11);
        CHECK(std::abs(answer.acceleration[2] - wanted[2]) <= 1.0e-11);
        CHECK(std::abs(answer.acceleration[4] - wanted[4]) <= 1.0e-9);
    }
}

// Sixty contacts on walls through the tool, as a mesh tells them: each normal off by up to `error`.
std::vector<Contact> make_contacts_off(Chance& random, double error, bool opposed) {
    std::vector<Contact> contacts;
    for (int k = 0; k < 60; ++k) {
        const double up = opposed && k % 2 == 1 ? -1.0 : 1.0;
        const Vector3 normal(random.draw(-error, error), up, random.draw(-error, error));
        contacts.push_back({{random.draw(-0.05, 0.05), -0.02 * up, random.draw(-0.05, 0.05)},
                            normal.normalized()});
    }
    return contacts;
}

TEST_CASE("least constraint: opposed walls whose normals err hold nothing along them") {
    const double error = GENERATE(0.0, 1e-15, 1e-13, 1e-12, 1e-11, 1e-10, 4e-10, 1e-9);
    const bool opposed = GENERATE(true, false);
    CAPTURE(error, opposed);
    Chance random(17);
    for (int trial = 0; trial < 50; ++trial) {
        const std::vector<Contact> contacts = make_contacts_off(random, error, opposed);
        LeastConstraintSolver solver = solver_of(contacts);
        // Anew, and then from the answer before.
        for (int i = 0; i < 3; ++i) {
            const Vector6 wanted =
                six({random.draw(-1, 1), -3.0, random.draw(-1, 1)},
                    {random.draw(-20, 20), random.draw(-20, 20), random.draw(-20, 20)});
            const LeastConstraint answer = solver.solve(wanted);
            REQUIRE(answer.exact);
            REQUIRE(std::abs(answer.acceleration[0] - wanted[0]) <= 1.0e-6);
            REQUIRE(std::abs(answer.acceleration[2] - wanted[2]) <= 1.0e-6);
            REQUIRE(std::abs(answer.acceleration[4] - wanted[4]) <= 1.0e-5);
            Vector6 sum = Vector6::Zero();
            double pushes_N = 0.0;
            for (std::size_t k = 0; k < contacts.size(); ++k) {
                const Contact& c = contacts[k];
                const double push_N = solver.force_N(k);
                REQUIRE(push_N >= 0.0);
                sum += push_N * along(c.arm_W, c.normal_W);
                pushes_N += push_N;
                // No wall is entered by more than its normal errs.
                REQUIRE(along(c.arm_W, c.normal_W).dot(answer.acceleration) >= -4.0e-7);
            }
            REQUIRE((sum - answer.force).norm() <= 1.0e-6 * answer.force.norm());
            REQUIRE(pushes_N <= 100.0 * kMass_kg * wanted.norm());
        }
    }
}

TEST_CASE("least constraint: of walls alike but for their normals' error the strictest holds") {
    const double error = GENERATE(1e-15, 1e-12, 1e-10, 1e-9);
    Chance random(19);
    std::vector<Contact> contacts = make_contacts_off(random, error, false);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        contacts[k].least = -0.01 * static_cast<double>(k + 1);
    }
    LeastConstraintSolver solver = solver_of(contacts);
    const Vector6 wanted = six({0.5, -3.0, 0.2}, {3.0, 0.0, -2.0});
    const LeastConstraint answer = solver.solve(wanted);
    REQUIRE(answer.exact);
    CHECK(answer.acting > 0);
    for (const Contact& c : contacts) {
        CHECK(along(c.arm_W, c.normal_W).dot(answer.acceleration) >= c.least - 1.0e-7);
    }
    SECTION("and opposed ones that leave no room contradict each other") {
        LeastConstraintSolver closed(2);
        REQUIRE(closed.set_inertia(kMass_kg, bar_inertia()));
        REQUIRE(closed.add(Vector3::Zero(), Vector3::UnitY(), 1.0e-3));
        REQUIRE(closed.add(Vector3::Zero(), Vector3(error, -1.0, 0.0), 1.0e-3));
        CHECK_FALSE(closed.solve(wanted).exact);
    }
}

TEST_CASE("least constraint: in a vee whose normals err rows do not change places for ever") {
    Chance random(31);
    for (int trial = 0; trial < 12000; ++trial) {
        std::vector<Contact> contacts;
        for (int k = 0; k < 4 + trial % 60; ++k) {
            const Vector3 normal =
                Vector3(k % 2 == 0 ? -0.5 : 0.5, 1.0, 0.0) + random.draw_vector(1.0e-9);
            contacts.push_back({Vector3(random.draw(-0.05, 0.05), -0.02, random.draw(-0.05, 0.05)),
                                normal.normalized()});
        }
        LeastConstraintSolver solver = solver_of(contacts);
        const Vector6 wanted =
            six({random.draw(-1, 1), -3.0, random.draw(-1, 1)}, random.draw_vector(20.0));
        const LeastConstraint answer = solver.solve(wanted);
        CAPTURE(trial, answer.rounds);
        REQUIRE(answer.exact);
        double deepest = 0.0;
        for (const Contact& c : contacts) {
            deepest = std::max(deepest, -along(c.arm_W, c.normal_W).dot(answer.acceleration));
        }
        REQUIRE(deepest <= 1.0e-6);
    }
}

TEST_CASE("least constraint: started where it ended it needs no round, and gives the same") {
    Chance random(5);
    std::vector<Contact> contacts;
    for (int k = 0; k < 30; ++k) {
        contacts.push_back(
            {random.draw_vector(0.05), (random.draw_direction() + Vector3::UnitY()).normalized()});
    }
    LeastConstraintSolver solver = solver_of(contacts);
    const Vector6 wanted = six({0.1, -5.0, 0.2}, {1.0, 2.0, 3.0});
    const LeastConstraint first = solver.solve(wanted);
    REQUIRE(first.rounds > 0);
    const LeastConstraint again = solver.solve(wanted);
    CHECK(again.rounds == 0);
    CHECK(again.acceleration == first.acceleration);
    // Fewer contacts than before, and none.
    solver.clear();
    REQUIRE(solver.add(contacts[0].arm_W, contacts[0].normal_W));
    check_optimal({contacts[0]}, bar_inertia(), solver, solver.solve(wanted), wanted);
    solver.clear();
    CHECK(solver.solve(wanted).acceleration == wanted);
}

TEST_CASE("least constraint: bounds that contradict each other are told, and nothing moves") {
    LeastConstraintSolver solver = solver_of(
        {{Vector3::Zero(), Vector3::UnitY(), 1.0}, {Vector3::Zero(), -Vector3::UnitY(), 1.0}});
    const LeastConstraint answer = solver.solve(six({0.0, -1.0, 0.0}));
    CHECK_FALSE(answer.exact);
    CHECK(answer.acceleration == Vector6::Zero());
    CHECK(answer.force == Vector6::Zero());
    // And the next problem is solved.
    solver.clear();
    REQUIRE(solver.add(Vector3::Zero(), Vector3::UnitY()));
    CHECK(solver.solve(six({0.0, -1.0, 0.0})).exact);
}

TEST_CASE("least constraint: what is no number, no direction or no body is refused") {
    LeastConstraintSolver solver(1);
    CHECK_FALSE(solver.set_inertia(0.0, bar_inertia()));
    CHECK_FALSE(solver.set_inertia(kNan, bar_inertia()));
    CHECK_FALSE(solver.set_inertia(1.0, Matrix3::Zero()));
    CHECK_FALSE(solver.set_inertia(1.0, Matrix3(-bar_inertia())));
    REQUIRE(solver.set_inertia(kMass_kg, bar_inertia()));
    CHECK_FALSE(solver.add({kNan, 0.0, 0.0}, Vector3::UnitY()));
    CHECK_FALSE(solver.add(Vector3::Zero(), {0.0, kInfinity, 0.0}));
    CHECK_FALSE(solver.add(Vector3::Zero(), Vector3::Zero()));
    CHECK_FALSE(solver.add(Vector3::Zero(), Vector3::UnitY(), kNan));
    CHECK_FALSE(solver.add(Vector3::Zero(), Vector3::UnitY(), kInfinity));
    CHECK(solver.add(Vector3::Zero(), Vector3::UnitY(), -kInfinity));
    CHECK_FALSE(solver.add(Vector3::Zero(), Vector3::UnitX()));
    const Vector6 wanted = six({0.0, -1.0, 0.0});
    CHECK(solver.solve(wanted).acceleration == wanted);
    Vector6 bad = wanted;
    bad[3] = kNan;
    CHECK_FALSE(solver.solve(bad).exact);
    CHECK(solver.solve(wanted).exact);
}

}  // namespace
}  // namespace fulcrum
