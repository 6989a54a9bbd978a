#include "haptics/constraint/even_pressure.h"
#include "haptics/constraint/impact.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace fulcrum;
using namespace fulcrum::contact_scenes;

namespace {

constexpr double kLeast_m_per_s = 0.01;

constexpr double kExact = 1.0e-7;  // of the force: the billionth that holds what nothing else does

struct Contact {
    Vector3 arm;
    Vector3 normal;
};

Vector6 sum_of(const std::vector<Contact>& contacts, const EvenPressure& pressure) {
    Vector6 sum = Vector6::Zero();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        sum.head<3>() += pressure.force_N(k) * contacts[k].normal;
        sum.tail<3>() += pressure.force_N(k) * contacts[k].arm.cross(contacts[k].normal);
    }
    return sum;
}

// The corners of a plate of 2 a x 2 b, seen from a height above.
std::vector<Contact> make_plate(double a, double b) {
    std::vector<Contact> contacts;
    for (const double x : {-a, a}) {
        for (const double z : {-b, b}) {
            contacts.push_back({Vector3(x, -0.02, z), Vector3::UnitY()});
        }
    }
    return contacts;
}

EvenPressure make(const std::vector<Contact>& contacts, double reach_m = 0.05) {
    EvenPressure pressure(contacts.size(), reach_m);
    for (const Contact& contact : contacts) {
        REQUIRE(pressure.add(contact.arm, contact.normal, 1.0));
    }
    return pressure;
}

// Up at x, z.
Vector6 push_at(double x, double z, double force_N) {
    Vector6 wrench;
    wrench << Vector3(0.0, force_N, 0.0), Vector3(x, -0.02, z).cross(Vector3(0.0, force_N, 0.0));
    return wrench;
}

ImpactReport collide(ContactProblem& problem, std::vector<Vector6>& velocities) {
    ContactSolver solver(settings_of(ContactMethod::newton), problem.capacity());
    return ImpactSolver(problem.capacity()).solve(problem, kLeast_m_per_s, solver, velocities);
}

// Balls of 1 kg and 0.1 m in a row along x, each touching the next.
struct Row {
    ContactProblem problem;
    std::vector<Vector6> velocities;

    explicit Row(int n_balls, double restitution) : problem({n_balls, n_balls, 0}) {
        for (int i = 0; i < n_balls; ++i) {
            problem.add_body(1.0, ball_inertia(1.0, 0.1), Vector6::Zero());
            velocities.push_back(moving({i == 0 ? 1.0 : 0.0, 0.0, 0.0}));
        }
        for (int i = 0; i + 1 < n_balls; ++i) {
            const Vector3 at(0.2 * i, 0.0, 0.0);
            ContactConstraint contact = contact_at(i, at, i + 1, at + Vector3(0.2, 0.0, 0.0),
                                                   at + Vector3(0.1, 0.0, 0.0), Vector3::UnitX());
            contact.restitution = restitution;
            problem.add_contact(contact);
        }
    }
    ImpactReport meet() { return collide(problem, velocities); }
};

double energy_of(const ContactProblem& problem, std::span<const Vector6> velocities) {
    double twice_J = 0.0;
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        twice_J += velocities[i].dot(compute_momentum(problem.bodies()[i], velocities[i]));
    }
    return 0.5 * twice_J;
}

}  // namespace

TEST_CASE("even pressure: four corners of a plate press as a plane through the load has it") {
    constexpr double kA = 0.03;
    constexpr double kB = 0.02;
    const std::vector<Contact> corners = make_plate(kA, kB);
    EvenPressure pressure = make(corners);
    for (const double x : {0.0, 0.005, -0.011}) {
        for (const double z : {0.0, -0.004, 0.006}) {
            REQUIRE(pressure.solve(push_at(x, z, 3.0)));
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const double share = 0.25 * (1.0 + x * corners[k].arm.x() / (kA * kA) +
                                             z * corners[k].arm.z() / (kB * kB));
                CAPTURE(x, z, k);
                CHECK(pressure.force_N(k) == Approx(3.0 * share).margin(3.0 * kExact));
            }
        }
    }
}

TEST_CASE("even pressure: a load over an edge leaves the others free, and one over a corner all") {
    const std::vector<Contact> corners = make_plate(0.03, 0.02);
    EvenPressure pressure = make(corners);
    REQUIRE(pressure.solve(push_at(0.03, 0.0, 2.0)));
    CHECK(pressure.force_N(0) == Approx(0.0).margin(1.0e-5));
    CHECK(pressure.force_N(1) == Approx(0.0).margin(1.0e-5));
    CHECK(pressure.force_N(2) == Approx(1.0).margin(1.0e-5));
    CHECK(pressure.force_N(3) == Approx(1.0).margin(1.0e-5));
    REQUIRE(pressure.solve(push_at(-0.03, -0.02, 2.0)));
    CHECK(pressure.force_N(0) == Approx(2.0).margin(1.0e-5));
}

TEST_CASE("even pressure: shares press, add up to what is shared, and no others are more even") {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 400; ++i) {
        std::vector<Contact> contacts;
        Vector6 wrench = Vector6::Zero();
        std::vector<double> given;
        for (int k = 0; k < 3 + i % 60; ++k) {
            contacts.push_back({0.05 * Vector3(any(random), any(random), any(random)),
                                Vector3(any(random), any(random), any(random)).normalized()});
            given.push_back(std::max(any(random), 0.0));
            wrench.head<3>() += given.back() * contacts.back().normal;
            wrench.tail<3>() += given.back() * contacts.back().arm.cross(contacts.back().normal);
        }
        EvenPressure pressure = make(contacts);
        if (!pressure.solve(wrench)) {
            REQUIRE(wrench.isZero(0.0));
            continue;
        }
        Vector6 off = sum_of(contacts, pressure) - wrench;
        off.tail<3>() /= 0.05;
        double squares = 0.0;
        double given_squares = 0.0;
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            REQUIRE(pressure.force_N(k) >= 0.0);
            squares += pressure.force_N(k) * pressure.force_N(k);
            given_squares += given[k] * given[k];
        }
        CAPTURE(i, contacts.size(), pressure.left_over());
        CHECK(off.norm() < 1.0e-4 * wrench.norm());
        CHECK(squares <= given_squares * (1.0 + 1.0e-4));
    }
}

TEST_CASE("even pressure: shares change evenly with the load, whatever begins to press") {
    const std::vector<Contact> corners = make_plate(0.03, 0.02);
    std::vector<Contact> contacts = corners;
    contacts.push_back({Vector3(0.01, -0.02, 0.005), Vector3::UnitY()});
    contacts.push_back({Vector3(0.0, -0.02, 0.005), Vector3(0.1, 1.0, 0.0).normalized()});
    EvenPressure pressure = make(contacts);
    std::vector<double> before;
    for (int i = 0; i <= 3000; ++i) {
        const double x = 0.0299 * std::sin(0.001 * i);
        REQUIRE(pressure.solve(push_at(x, 0.015 * std::cos(0.0017 * i), 1.0)));
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            if (i > 0) {
                CAPTURE(i, k);
                REQUIRE(std::abs(pressure.force_N(k) - before[k]) < 0.01);
            }
        }
        before.clear();
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            before.push_back(pressure.force_N(k));
        }
    }
}

TEST_CASE("even pressure: a contact twice as stiff bears twice as much, one of weight 0 nothing") {
    EvenPressure pressure(3, 0.05);
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 2.0));
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 1.0));
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 0.0));
    REQUIRE(pressure.solve(push_at(0.0, 0.0, 3.0)));
    CHECK(pressure.force_N(0) == Approx(2.0).margin(1.0e-6));
    CHECK(pressure.force_N(1) == Approx(1.0).margin(1.0e-6));
    CHECK(pressure.force_N(2) == 0.0);
}

TEST_CASE("even pressure: what cannot be borne, nothing and no number") {
    EvenPressure pressure(2, 0.05);
    CHECK_FALSE(pressure.solve(push_at(0.0, 0.0, 1.0)));
    CHECK_FALSE(pressure.add(Vector3(kNan, 0.0, 0.0), Vector3::UnitY(), 1.0));
    CHECK_FALSE(pressure.add(Vector3::Zero(), Vector3::UnitY(), kNan));
    CHECK_FALSE(pressure.add(Vector3::Zero(), Vector3::UnitY(), -1.0));
    CHECK(pressure.size() == 0);
    REQUIRE(pressure.add(Vector3(0.0, -0.02, 0.0), Vector3::UnitY(), 1.0));
    REQUIRE(pressure.add(Vector3(0.01, -0.02, 0.0), Vector3::UnitY(), 1.0));
    CHECK_FALSE(pressure.add(Vector3::Zero(), Vector3::UnitY(), 1.0));
    CHECK_FALSE(pressure.solve(Vector6::Zero()));
    CHECK_FALSE(pressure.solve(Vector6::Constant(kNan)));
    CHECK(pressure.force_N(0) == 0.0);
    // A pull: nobody pulls.
    (void)pressure.solve(push_at(0.0, 0.0, -1.0));
    CHECK(pressure.force_N(0) == Approx(0.0).margin(1.0e-6));
    CHECK(pressure.left_over() > 0.9);
    // Aside: what they can bear of it is nothing.
    Vector6 aside = Vector6::Zero();
    aside.x() = 1.0;
    (void)pressure.solve(aside);
    CHECK(std::isfinite(pressure.force_N(0)));
    CHECK(pressure.left_over() > 0.9);
}

TEST_CASE("impact: in a row of balls that keep all energy the last leaves and the others stand") {
    Row row(5, 1.0);
    const ImpactReport report = row.meet();
    CHECK(report.done);
    CHECK(report.n_rounds == 4);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(row.velocities[i].x() == Approx(i == 4 ? 1.0 : 0.0).margin(kSolved));
    }
}

TEST_CASE("impact: two balls part with e times the speed of their meeting") {
    for (const double restitution : {0.2, 0.5, 1.0}) {
        Row row(2, restitution);
        CHECK(row.meet().n_rounds == 1);
        CHECK(row.velocities[0].x() == Approx(0.5 * (1.0 - restitution)).margin(kSolved));
        CHECK(row.velocities[1].x() == Approx(0.5 * (1.0 + restitution)).margin(kSolved));
    }
}

TEST_CASE("impact: what arrives slowly, leaves, or has no restitution does not bounce") {
    for (const double speed : {0.5 * kLeast_m_per_s, -1.0}) {
        Row row(2, 1.0);
        row.velocities[0].x() = speed;
        CHECK(row.meet().n_rounds == 0);
        CHECK(row.velocities[0].x() == speed);
    }
    Row dull(3, 0.0);
    CHECK(dull.meet().n_rounds == 0);
    Row far(2, 1.0);
    far.problem.contacts()[0].target_m_per_s.x() = -2.0;  // the gap takes two such steps
    CHECK(far.meet().n_rounds == 0);
}

TEST_CASE("impact: what lies under a ball without restitution of its own stays under it") {
    // A ball bounces off the upper of two cubes on the ground; the cubes stay.
    ContactProblem problem({3, 9, 0});
    for (int i = 0; i < 2; ++i) {
        problem.add_body(1.0, cube_inertia(1.0, 0.1), Vector6::Zero());
    }
    problem.add_body(1.0, ball_inertia(1.0, 0.05), Vector6::Zero());
    add_corners(problem, 0, 0.1, 0.6, make_contact_axes(Vector3::UnitY()));
    for (const ContactConstraint& below :
         std::vector<ContactConstraint>(problem.contacts().begin(), problem.contacts().end())) {
        ContactConstraint contact = below;
        contact.body_a = 0;
        contact.body_b = 1;
        contact.arm_a = below.arm_b + Vector3(0.0, 0.1, 0.0);
        problem.add_contact(contact);
    }
    ContactConstraint top =
        contact_at(1, {0.0, 0.15, 0.0}, 2, {0.0, 0.25, 0.0}, {0.0, 0.2, 0.0}, Vector3::UnitY());
    top.restitution = 0.5;
    problem.add_contact(top);
    std::vector<Vector6> velocities{Vector6::Zero(), Vector6::Zero(), moving({0.0, -2.0, 0.0})};
    const ImpactReport report = collide(problem, velocities);
    CHECK(report.n_rounds == 1);
    CHECK(velocities[0].cwiseAbs().maxCoeff() <= kSolved);
    CHECK(velocities[1].cwiseAbs().maxCoeff() <= kSolved);
    CHECK((velocities[2] - moving({0.0, 1.0, 0.0})).cwiseAbs().maxCoeff() <= kSolved);
}

TEST_CASE("impact: with friction too no energy is gained, and bodies alone keep their momentum") {
    // Rods that lean meet the ground or each other on their ends: where slip would turn round, Newton's law alone gains energy.
    Random random(11);
    int n_with_ground = 0;
    for (int trial = 0; trial < 400; ++trial) {
        CAPTURE(trial);
        const bool on_ground = trial % 2 == 0;
        n_with_ground += on_ground ? 1 : 0;
        ContactProblem problem({2, 2, 0});
        std::vector<Vector6> velocities;
        const std::array<Vector3, 2> places{Vector3(0.0, 0.4, 0.0), Vector3(0.1, 1.1, 0.0)};
        for (int i = 0; i < 2; ++i) {
            problem.add_body(1.0, Vector3(1.0 / 12.0, 1.0 / 12.0, 1.0 / 1200.0).asDiagonal(),
                             Vector6::Zero());
            velocities.push_back(moving(random.in_cube(), 3.0 * random.in_cube()));
        }
        const double friction = 0.75 * (1.0 + random.uniform());
        const double restitution = 0.5 * (1.0 + random.uniform());
        for (int k = 0; k < (on_ground ? 2 : 1); ++k) {
            const int a = k == 0 ? 0 : kGround;
            const int b = k == 0 ? 1 : 0;
            const Vector3 from = k == 0 ? places[0] : Vector3(0.0, -1.0, 0.0);
            const Vector3& to = places[static_cast<std::size_t>(b)];
            ContactConstraint contact =
                contact_at(a, from, b, to, to + 0.4 * random.in_cube(), Vector3::UnitY(), friction);
            contact.restitution = restitution;
            problem.add_contact(contact);
        }
        const double before_J = energy_of(problem, velocities);
        const Vector6 sum = velocities[0] + velocities[1];
        const ImpactReport report = collide(problem, velocities);
        REQUIRE(report.done);
        REQUIRE(energy_of(problem, velocities) <= before_J * (1.0 + 1.0e-9));
        if (!on_ground) {
            const Vector6 change = velocities[0] + velocities[1] - sum;
            REQUIRE(change.head<3>().cwiseAbs().maxCoeff() <= 1.0e-12);
        }
    }
    CHECK(n_with_ground == 200);
}

TEST_CASE("impact: a joint passes a blow on, a motor does not") {
    // Two balls are tied; the first is hit by a third.
    ContactProblem problem({3, 1, 2});
    std::vector<Vector6> velocities;
    for (int i = 0; i < 3; ++i) {
        problem.add_body(1.0, ball_inertia(1.0, 0.1), Vector6::Zero());
        velocities.push_back(moving({i == 0 ? 1.0 : 0.0, 0.0, 0.0}));
    }
    ContactConstraint contact =
        contact_at(0, Vector3::Zero(), 1, {0.2, 0.0, 0.0}, {0.1, 0.0, 0.0}, Vector3::UnitX());
    contact.restitution = 1.0;
    problem.add_contact(contact);
    const RowConstraint tied = tie(1, moving(-Vector3::UnitX()), 2, moving(Vector3::UnitX()));
    problem.add_row(tied);
    RowConstraint motor = tied;
    motor.target = 5.0;
    motor.least = -1.0;
    motor.most = 1.0;
    problem.add_row(motor);
    (void)collide(problem, velocities);
    // 1 kg against 2 kg: -1/3 and 2/3.
    CHECK(velocities[0].x() == Approx(-1.0 / 3.0));
    CHECK(velocities[1].x() == Approx(2.0 / 3.0));
    CHECK(velocities[2].x() == Approx(2.0 / 3.0));
}

TEST_CASE("impact: a problem beyond its capacity is left as it is") {
    Row row(3, 1.0);
    ContactSolver solver(settings_of(ContactMethod::newton), row.problem.capacity());
    CHECK(ImpactSolver({2, 3, 0})
              .solve(row.problem, kLeast_m_per_s, solver, row.velocities)
              .n_rounds == 0);
    CHECK(row.velocities[0].x() == 1.0);
}
