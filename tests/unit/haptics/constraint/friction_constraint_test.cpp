#include "haptics/constraint/friction_constraint.h"

#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/constraint/held_tool.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

using namespace held_tool;

constexpr double kHalf_m = 0.02;
const Vector3 kUp = Vector3::UnitY();

struct Held {
    Vector3 arm_W, normal_W;
    double least = 0.0;
    double friction = 0.0;
    Vector3 carried_W{Vector3::Zero()};
};

Matrix3 bar_inertia() {
    return Vector3(2.0e-5, 8.0e-5, 6.0e-5).asDiagonal();
}

FrictionConstraintSolver solver_of(const std::vector<Held>& contacts) {
    FrictionConstraintSolver solver(contacts.size());
    REQUIRE(solver.set_inertia(kMass_kg, bar_inertia()));
    for (const Held& c : contacts) {
        REQUIRE(solver.add(c.arm_W, c.normal_W, c.least, c.friction, c.carried_W));
    }
    return solver;
}

// n x n contacts under a cube.
std::vector<Held> under_a_cube(int n, double friction) {
    std::vector<Held> contacts;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double span = n > 1 ? 2.0 * kHalf_m / (n - 1) : 0.0;
            const double start = n > 1 ? -kHalf_m : 0.0;
            contacts.push_back({{start + span * i, 0.0, start + span * j}, kUp, 0.0, friction});
        }
    }
    return contacts;
}

// The law at each contact, and that the forces are all that changes the motion; lengths against `scale`, metres.
void check_law(const std::vector<Held>& contacts, const FrictionConstraintSolver& solver,
               const LeastConstraint& answer, const Vector6& wanted, double scale) {
    const double force_scale = kMass_kg * scale;
    Vector6 sum = Vector6::Zero();
    for (std::size_t k = 0; k < contacts.size(); ++k) {
        const Held& c = contacts[k];
        const Vector3 way =
            answer.acceleration.head<3>() + answer.acceleration.tail<3>().cross(c.arm_W);
        const Vector3 force = solver.force_W(k);
        const double push = force.dot(c.normal_W);
        const Vector3 drag = force - push * c.normal_W;
        const Vector3 relative = way - c.carried_W;
        const Vector3 slip = relative - c.normal_W * relative.dot(c.normal_W);
        const double slack = way.dot(c.normal_W) - c.least;
        REQUIRE(slack >= -1.0e-9 * scale);
        REQUIRE(push >= 0.0);
        REQUIRE(push * slack <= 1.0e-9 * force_scale * scale);
        REQUIRE(drag.norm() <= c.friction * push + 1.0e-9 * force_scale);
        if (slip.norm() > 1.0e-6 * scale) {
            REQUIRE((drag + c.friction * push * slip.normalized()).norm() <= 1.0e-4 * force_scale);
        }
        sum.head<3>() += force;
        sum.tail<3>() += c.arm_W.cross(force);
    }
    Vector6 change = answer.acceleration - wanted;
    change.head<3>() *= kMass_kg;
    change.tail<3>() = (bar_inertia() * change.tail<3>()).eval();
    REQUIRE((change - sum).head<3>().norm() <= 1.0e-9 * force_scale);
    REQUIRE((change - sum).tail<3>().norm() <= 1.0e-9 * force_scale * kHalf_m);
    REQUIRE((answer.force - sum).norm() <= 1.0e-9 * force_scale);
}

TEST_CASE("friction constraint: pressed through its middle it sticks below mu and slides beyond") {
    const int n = GENERATE(1, 2, 10);
    const double along = GENERATE(0.0, 0.29, 0.31, 2.0);
    const double press = GENERATE(1.0e-9, 1.0e-3, 1.0);
    FrictionConstraintSolver solver = solver_of(under_a_cube(n, 0.3));
    const Vector6 wanted = press * six({0.6 * along, -1.0, 0.8 * along});
    const LeastConstraint& answer = solver.solve(wanted);
    CAPTURE(n, along, press);
    REQUIRE(answer.exact);
    const double slid = std::max(along - 0.3, 0.0);
    CHECK((answer.acceleration - press * six({0.6 * slid, 0.0, 0.8 * slid})).norm() <
          1.0e-8 * press);
    const double drag = std::min(along, 0.3);
    const Vector3 force = press * kMass_kg * Vector3(-0.6 * drag, 1.0, -0.8 * drag);
    CHECK((answer.force.head<3>() - force).norm() < 1.0e-10 * press);
    CHECK(answer.force.tail<3>().norm() < 1.0e-10 * press);
}

TEST_CASE("friction constraint: turned about what presses it, four corners hold by mu N r") {
    // Symmetric, so that the middle stays.
    for (const double turn : {0.1, 5.0}) {
        FrictionConstraintSolver solver = solver_of(under_a_cube(2, 0.5));
        const Vector6 wanted = six({0.0, -1.0, 0.0}, {0.0, turn, 0.0});
        const LeastConstraint& answer = solver.solve(wanted);
        REQUIRE(answer.exact);
        const double most = 0.5 * kMass_kg * kHalf_m * std::sqrt(2.0);
        const double needed = bar_inertia()(1, 1) * turn;
        CHECK(answer.force[4] == Approx(-std::min(most, needed)).epsilon(1.0e-9));
        CHECK(answer.acceleration[4] ==
              Approx(std::max(needed - most, 0.0) / bar_inertia()(1, 1)).margin(1.0e-9));
    }
}

TEST_CASE("friction constraint: by chance the law holds at each contact") {
    Chance random(1);
    int n_slid = 0;
    int n_inexact = 0;
    constexpr int kTrials = 1500;
    for (int i = 0; i < kTrials; ++i) {
        const double mu = random.draw(0.0, 0.8);
        std::vector<Held> contacts;
        // On a floor and, now and then, against a wall; some are a little away, some are carried along.
        for (int k = 0; k < 2 + i % 12; ++k) {
            const Vector3 carried =
                i % 5 == 0 ? Vector3(0.0005, 0.0, 0.0002) : Vector3(Vector3::Zero());
            contacts.push_back(
                {{random.draw(-kHalf_m, kHalf_m), -kHalf_m, random.draw(-kHalf_m, kHalf_m)},
                 kUp,
                 -random.draw(0.0, 3.0e-6),
                 mu,
                 carried});
        }
        if (i % 3 == 0) {
            contacts.push_back(
                {{-kHalf_m, random.draw(-kHalf_m, kHalf_m), 0.0}, Vector3::UnitX(), 0.0, mu});
        }
        FrictionConstraintSolver solver = solver_of(contacts);
        const Vector6 wanted = six(random.draw_vector(3.0e-3), random.draw_vector(0.1));
        const LeastConstraint& answer = solver.solve(wanted);
        CAPTURE(i, mu, contacts.size(), answer.rounds);
        REQUIRE(answer.acceleration.allFinite());
        if (!answer.exact) {
            ++n_inexact;
            continue;
        }
        check_law(contacts, solver, answer, wanted, 5.0e-3);
        n_slid += answer.acting > 0 ? 1 : 0;
    }
    CHECK(n_slid > kTrials / 2);
    CHECK(n_inexact < kTrials / 100);
}

TEST_CASE("friction constraint: without friction it is the least constraint") {
    Chance random(2);
    for (int i = 0; i < 500; ++i) {
        FrictionConstraintSolver solver(16);
        LeastConstraintSolver plain(16);
        REQUIRE(solver.set_inertia(kMass_kg, bar_inertia()));
        REQUIRE(plain.set_inertia(kMass_kg, bar_inertia()));
        for (int k = 0; k < 8; ++k) {
            const Vector3 arm = random.draw_vector(kHalf_m);
            const Vector3 normal = random.draw_direction();
            const double least = -random.draw(0.0, 1.0e-4);
            REQUIRE(solver.add(arm, normal, least, 0.0));
            REQUIRE(plain.add(arm, normal, least));
        }
        const Vector6 wanted = six(random.draw_vector(3.0e-3), random.draw_vector(0.1));
        const LeastConstraint& a = solver.solve(wanted);
        const LeastConstraint& b = plain.solve(wanted);
        CAPTURE(i);
        REQUIRE(a.exact);
        CHECK((a.acceleration - b.acceleration).head<3>().norm() < 1.0e-9);
        CHECK((a.force - b.force).head<3>().norm() < 1.0e-9);
    }
}

TEST_CASE("friction constraint: between narrowing walls nothing moves or gains energy") {
    SECTION("between walls that lean by 0.5 rad, pressed in: whatever holds along them") {
        const double slope = 1.0 / std::tan(0.5);
        const Vector3 left(std::sin(0.5), std::cos(0.5), 0.0);
        const Vector3 right(-std::sin(0.5), std::cos(0.5), 0.0);
        for (const double share : {0.5, 1.1}) {
            const double mu = share / slope;
            FrictionConstraintSolver solver =
                solver_of({{-0.01 * left, left, 0.0, mu}, {-0.01 * right, right, 0.0, mu}});
            const LeastConstraint& answer = solver.solve(six({0.0, -0.002, 0.0}));
            CHECK(answer.exact);
            CHECK(answer.acceleration.norm() < 1.0e-11);
            // Drawn out again nothing holds it.
            CHECK(solver.solve(six({0.0, 0.002, 0.0})).acceleration[1] == Approx(0.002));
        }
    }
    SECTION("among contacts from all sides") {
        Chance random(3);
        int n_inexact = 0;
        for (int i = 0; i < 400; ++i) {
            std::vector<Held> contacts;
            for (int k = 0; k < 12; ++k) {
                contacts.push_back({random.draw_vector(0.03), random.draw_direction(),
                                    -random.draw(0.0, 1.0e-5), 1.0});
            }
            FrictionConstraintSolver solver = solver_of(contacts);
            const Vector6 wanted = six(random.draw_vector(3.0e-3), random.draw_vector(0.1));
            const LeastConstraint& answer = solver.solve(wanted);
            n_inexact += answer.exact ? 0 : 1;
            REQUIRE(answer.acceleration.allFinite());
            // The work of all contacts on the way that was gone; what is let go is let go against nothing.
            const double work = answer.force.dot(answer.acceleration);
            const double kinetic = kMass_kg * 1.0e-5 + 8.0e-5 * 0.03;
            CHECK(work <= 1.0e-4 * kinetic);
        }
        CHECK(n_inexact > 0);
    }
}

TEST_CASE("friction constraint: the force told is what the contacts push, by the thousand too") {
    Chance random(7);
    int n_inexact = 0;
    for (const std::size_t n : {30U, 100U, 1000U}) {
        for (int i = 0; i < 10; ++i) {
            std::vector<Held> contacts;
            for (std::size_t k = 0; k < n; ++k) {
                // A floor that is a little curved.
                const Vector3 normal =
                    Vector3(random.draw(-1.0e-3, 1.0e-3), 1.0, random.draw(-1.0e-3, 1.0e-3))
                        .normalized();
                contacts.push_back(
                    {{random.draw(-kHalf_m, kHalf_m), -kHalf_m, random.draw(-kHalf_m, kHalf_m)},
                     normal,
                     -random.draw(0.0, 1.0e-7),
                     random.draw(0.1, 1.0)});
            }
            FrictionConstraintSolver solver = solver_of(contacts);
            const Vector6 wanted =
                six({random.draw(-2.0e-3, 2.0e-3), -2.0e-3, random.draw(-2.0e-3, 2.0e-3)},
                    random.draw_vector(0.05));
            const LeastConstraint answer = solver.solve(wanted);
            n_inexact += answer.exact ? 0 : 1;
            if (!answer.exact && answer.acceleration == Vector6::Zero()) {
                // No time: it stays, and is held by what was wanted.
                const Vector6 held =
                    six(-kMass_kg * wanted.head<3>(), -(bar_inertia() * wanted.tail<3>()));
                CHECK((answer.force - held).norm() <= 1.0e-12 * held.norm());
                CHECK(n == 1000);
                continue;
            }
            Vector6 sum = Vector6::Zero();
            for (std::size_t k = 0; k < n; ++k) {
                const Vector3 force_W = solver.force_W(k);
                const double push = force_W.dot(contacts[k].normal_W);
                const Vector3 along = force_W - push * contacts[k].normal_W;
                CHECK(push >= -1.0e-15);
                if (answer.exact) {
                    CHECK(along.norm() <= contacts[k].friction * push + 1.0e-9);
                }
                sum += six(force_W, contacts[k].arm_W.cross(force_W));
            }
            CAPTURE(n, i, answer.exact, answer.rounds);
            CHECK((answer.force - sum).head<3>().norm() <= 1.0e-9 * answer.force.norm());
            CHECK((answer.force - sum).tail<3>().norm() <= 1.0e-9 * answer.force.norm());
            // Held back, exactly or nearly.
            CHECK(answer.acceleration[1] > -2.0e-4);
        }
    }
    CHECK(n_inexact > 0);
}

TEST_CASE(
    "friction constraint: asked step by step, what it calls exact is balanced in every step") {
    Chance random(8);
    int n_acting = 0;
    int n_exact = 0;
    for (int course = 0; course < 40; ++course) {
        // An edge, a face or more, tilted a little; the hand that drags the cube along and turns it wanders.
        const auto n = static_cast<std::size_t>(2 + course % 5);
        FrictionConstraintSolver solver(n);
        REQUIRE(solver.set_inertia(kMass_kg, bar_inertia()));
        std::vector<Held> contacts(n);
        Vector6 wanted = six({0.0, -1.0e-3, 0.0});
        Vector6 drift = Vector6::Zero();
        for (int i = 0; i < 2000; ++i) {
            if (i % 50 == 0) {
                for (Held& c : contacts) {
                    c = {{random.draw(-kHalf_m, kHalf_m), -kHalf_m, random.draw(-kHalf_m, kHalf_m)},
                         (kUp + random.draw_vector(0.05)).normalized(),
                         -random.draw(0.0, 1.0e-6),
                         0.5};
                }
            }
            solver.clear();
            for (const Held& c : contacts) {
                REQUIRE(solver.add(c.arm_W, c.normal_W, c.least, c.friction));
            }
            drift = 0.98 * drift + six(random.draw_vector(2.0e-5), random.draw_vector(1.0e-3)) -
                    0.002 * (wanted - six({0.0, -1.0e-3, 0.0}));
            wanted += drift;
            const LeastConstraint answer = solver.solve(wanted);
            n_acting += answer.acting > 0 ? 1 : 0;
            n_exact += answer.exact && answer.acting > 0 ? 1 : 0;
            Vector6 sum = Vector6::Zero();
            for (std::size_t k = 0; k < n && answer.acting > 0; ++k) {
                const Vector3 force_W = solver.force_W(k);
                sum += six(force_W, contacts[k].arm_W.cross(force_W));
            }
            CAPTURE(course, i, n, answer.exact, answer.rounds);
            REQUIRE((answer.force - sum).head<3>().norm() <= 1.0e-9 * kMass_kg * wanted.norm());
        }
    }
    CHECK(n_acting > 40000);
    CHECK(n_exact > n_acting * 9 / 10);
}

TEST_CASE("friction constraint: asked again it answers the same, whatever it was asked before") {
    FrictionConstraintSolver solver = solver_of(under_a_cube(3, 0.4));
    const Vector6 wanted = six({2.0e-3, -2.0e-3, 1.0e-3}, {0.02, 0.05, -0.01});
    const Vector6 first = solver.solve(wanted).acceleration;
    (void)solver.solve(six({-1.0, -2.0, 0.5}, {3.0, 0.0, 0.0}));
    const Vector6 again = solver.solve(wanted).acceleration;
    CHECK((first - again).head<3>().norm() < 1.0e-9);
    // Off the floor nothing is felt, to the bit.
    const LeastConstraint& free = solver.solve(six({0.1, 0.2, 0.3}));
    CHECK(free.acceleration == six({0.1, 0.2, 0.3}));
    CHECK(free.force == Vector6::Zero());
    CHECK(free.acting == 0);
}

TEST_CASE("friction constraint: what is no number, or has no room, is refused") {
    FrictionConstraintSolver solver(1);
    CHECK_FALSE(solver.set_inertia(0.0, bar_inertia()));
    CHECK_FALSE(solver.set_inertia(kMass_kg, -bar_inertia()));
    REQUIRE(solver.set_inertia(kMass_kg, bar_inertia()));
    CHECK_FALSE(solver.add({kNan, 0.0, 0.0}, kUp, 0.0, 0.5));
    CHECK_FALSE(solver.add(Vector3::Zero(), kUp, kNan, 0.5));
    CHECK_FALSE(solver.add(Vector3::Zero(), kUp, 0.0, -0.5));
    CHECK_FALSE(solver.add(Vector3::Zero(), kUp, 0.0, kNan));
    CHECK_FALSE(solver.add(Vector3::Zero(), kUp, 0.0, kInfinity));
    CHECK(solver.add(Vector3::Zero(), kUp, 0.0, 0.5));
    CHECK_FALSE(solver.add(Vector3::Zero(), kUp, 0.0, 0.5));
    const LeastConstraint& answer = solver.solve(six({kNan, 0.0, 0.0}));
    CHECK_FALSE(answer.exact);
    CHECK(answer.acceleration == Vector6::Zero());
    CHECK(solver.solve(Vector6::Zero()).exact);
    CHECK(solver.force_W(0) == Vector3::Zero());
}

TEST_CASE("friction constraint: after a way of any size it answers, and by numbers") {
    FrictionConstraintSolver solver = solver_of(under_a_cube(2, 0.3));
    for (const double size : {1.0, 1.0e150, 1.0e-160, 1.0e-3, 1.0e150, 1.0}) {
        CAPTURE(size);
        const LeastConstraint& answer = solver.solve(size * six({0.1, -1.0, 0.0}));
        REQUIRE(answer.acceleration.allFinite());
        REQUIRE(answer.force.allFinite());
        REQUIRE(answer.exact);
        CHECK(answer.acceleration.norm() <= 1.0e-6 * size);
        CHECK(answer.force[1] == Approx(kMass_kg * size).epsilon(1.0e-3));
    }
}

}  // namespace
}  // namespace fulcrum
