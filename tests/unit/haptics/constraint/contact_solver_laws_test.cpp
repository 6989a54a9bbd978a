// Laws that hold for every contact problem, whoever solves it. See contact_solver.h.
#include "haptics/constraint/contact_solver.h"
#include "haptics/math/plain_eigen.h"
#include "haptics/math/to_eigen.h"
#include "tests/support/contact_scenes.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <rapidcheck.h>
#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kAgree = 1.0e-7;  // of velocities about 1 m/s, by solvers asked for 1e-10

double number() {
    return *rc::gen::inRange(-1000, 1001) * 1.0e-3;
}
Vector3 vector() {
    const double x = number();
    const double y = number();
    return {x, y, number()};
}

constexpr int kBalls = 3;
const std::array<Vector3, kBalls> kPlaces{Vector3(0.0, 0.1, 0.0), Vector3(0.2, 0.1, 0.0),
                                          Vector3(0.1, 0.28, 0.05)};

// Three balls and a floor, with points of contact anywhere on them, each pair's own normal.
ContactProblem random_problem(double friction, int n_contacts, bool with_floor) {
    ContactProblem problem({kBalls, 8, 0});
    for (int i = 0; i < kBalls; ++i) {
        const double mass_kg = std::exp(3.0 * number());
        problem.add_body(mass_kg, ball_inertia(mass_kg, 0.1), moving(vector(), vector()));
    }
    for (int k = 0; k < n_contacts; ++k) {
        const int b = *rc::gen::inRange(0, kBalls);
        const int a = *rc::gen::inRange(with_floor ? -1 : 0, kBalls);
        if (a == b) {
            continue;
        }
        const Vector3& place = kPlaces[static_cast<std::size_t>(b)];
        const Vector3 from =
            a == kGround ? Vector3(place - Vector3::UnitY()) : kPlaces[static_cast<std::size_t>(a)];
        const Vector3 normal = compute_direction(Vector3(place - from + 0.3 * vector()));
        problem.add_contact(contact_at(a, from, b, place, place - 0.1 * normal + 0.05 * vector(),
                                       normal, friction));
    }
    return problem;
}

// The velocities of a frictionless problem by trying every set of contacts that push.
bool solve_by_sets(const ContactProblem& problem, std::vector<Vector6>& velocities) {
    const auto n = static_cast<int>(problem.contacts().size());
    const auto n_bodies = static_cast<int>(problem.bodies().size());
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, 6 * n_bodies);
    Eigen::VectorXd free(6 * n_bodies);
    Eigen::MatrixXd W = Eigen::MatrixXd::Zero(6 * n_bodies, 6 * n_bodies);
    for (int i = 0; i < n_bodies; ++i) {
        const ConstrainedBody& body = problem.bodies()[static_cast<std::size_t>(i)];
        free.segment<6>(6 * i) = to_eigen(body.free_velocity_W);
        W.block<3, 3>(6 * i, 6 * i) = Eigen::Matrix3d::Identity() / body.mass_kg;
        W.block<3, 3>(6 * i + 3, 6 * i + 3) = to_eigen(body.inverse_inertia_W);
    }
    for (int k = 0; k < n; ++k) {
        const ContactConstraint& c = problem.contacts()[static_cast<std::size_t>(k)];
        const Vector3 normal = c.axes_W.col(0);
        const auto add = [&](int body, double sign, const Vector3& arm) {
            if (body != kGround) {
                J.block<1, 6>(k, 6 * body) =
                    sign * to_eigen(moving(normal, arm.cross(normal))).transpose();
            }
        };
        add(c.body_a, -1.0, c.arm_a);
        add(c.body_b, 1.0, c.arm_b);
    }
    constexpr double kSlack = 1.0e-9;
    for (int set = 0; set < 1 << n; ++set) {
        std::vector<int> push;
        for (int k = 0; k < n; ++k) {
            if ((set >> k & 1) != 0) {
                push.push_back(k);
            }
        }
        Eigen::VectorXd v = free;
        bool pulls = false;
        if (!push.empty()) {
            const Eigen::MatrixXd part = J(push, Eigen::all);
            const Eigen::MatrixXd square = part * W * part.transpose();
            const Eigen::VectorXd p =
                square.completeOrthogonalDecomposition().solve(-(part * free));
            v += W * part.transpose() * p;
            pulls = p.minCoeff() < -kSlack;
        }
        if (!pulls && (n == 0 || (J * v).minCoeff() >= -kSlack)) {
            velocities.clear();
            for (int i = 0; i < n_bodies; ++i) {
                velocities.push_back(from_eigen(v.segment<6>(6 * i)));
            }
            return true;
        }
    }
    return false;
}

TEST_CASE("contact solver: without friction all find the one motion that the sets allow") {
    const bool holds = rc::check([] {
        const ContactProblem problem = random_problem(0.0, *rc::gen::inRange(1, 7), true);
        std::vector<Vector6> expected;
        RC_PRE(solve_by_sets(problem, expected));
        for (const ContactMethod method : {ContactMethod::newton, ContactMethod::dantzig}) {
            ContactProblem solved = problem;
            const SolveReport report = solve(solved, settings_of(method));
            RC_ASSERT(report.converged);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                RC_ASSERT((solved.bodies()[i].velocity_W - expected[i]).cwiseAbs().maxCoeff() <=
                          kAgree * std::max(1.0, expected[i].cwiseAbs().maxCoeff()));
            }
        }
    });
    CHECK(holds);
}

TEST_CASE("contact solver: bodies that touch each other alone keep their momentum") {
    const bool holds = rc::check([] {
        const ContactProblem problem = random_problem(0.5, 4, false);
        for (const ContactMethod method : kContactMethods) {
            ContactProblem solved = problem;
            ContactSolverSettings settings = settings_of(method);
            settings.max_iterations = 60;
            const SolveReport report = solve(solved, settings);
            RC_ASSERT(std::isfinite(report.residual_m_per_s));
            const Vector6 before = total_momentum(solved, kPlaces, true);
            const Vector6 after = total_momentum(solved, kPlaces, false);
            double scale = 1.0;
            for (const ContactConstraint& c : solved.contacts()) {
                scale = std::max(scale, c.impulse_Ns.cwiseAbs().maxCoeff());
            }
            // Arms are given from places of their own, so a point is one only to rounding.
            RC_ASSERT((after - before).cwiseAbs().maxCoeff() <= 1.0e-12 * scale);
        }
    });
    CHECK(holds);
}
TEST_CASE("contact solver: what meets without bounce loses energy, with friction or without") {
    const bool holds = rc::check([] {
        const double friction = std::abs(number());
        const ContactProblem problem = random_problem(friction, 5, true);
        const double before = compute_kinetic_energy_J(problem);
        for (const ContactMethod method : kContactMethods) {
            ContactProblem solved = problem;
            const SolveReport report = solve(solved, settings_of(method));
            RC_PRE(report.converged);
            RC_ASSERT(compute_kinetic_energy_J(solved) <= before * (1.0 + 1.0e-9) + 1.0e-9);
        }
    });
    CHECK(holds);
}
TEST_CASE("contact solver: hard problems have finite answers, and what is wrong is told") {
    struct Hard {
        const char* name;
        double friction, mass_kg, tilt;
        int n_copies;
    };
    // Coincident contacts, no friction and all of it, mass ratios, and Painleve's rod: a thin rod that leans and slides on its end,
    // which in forces has no answer.
    for (const Hard& hard :
         {Hard{"coincident", 0.5, 1.0, 0.0, 8}, Hard{"frictionless", 0.0, 1.0, 0.3, 1},
          Hard{"sticky", 1.0e9, 1.0, 0.3, 1}, Hard{"light", 0.5, 1.0e-6, 0.3, 2},
          Hard{"heavy", 0.5, 1.0e6, 0.3, 2}, Hard{"Painleve", 5.0, 1.0, 0.5, 1}}) {
        for (const ContactMethod method : kContactMethods) {
            CAPTURE(hard.name, to_string(method));
            ContactProblem problem({1, 8, 0});
            const Matrix3 rod =
                hard.mass_kg * Vector3(1.0 / 12.0, 1.0 / 12.0, 1.0 / 1200.0).asDiagonal();
            problem.add_body(hard.mass_kg, rod, moving({2.0, -kGravity * kStep_s, 0.0}));
            for (int i = 0; i < hard.n_copies; ++i) {
                ContactConstraint c;
                c.body_b = 0;
                c.axes_W = make_contact_axes(Vector3::UnitY());
                c.arm_b = {0.5 * std::sin(hard.tilt), -0.5 * std::cos(hard.tilt), 0.0};
                c.static_friction = c.dynamic_friction = hard.friction;
                problem.add_contact(c);
            }
            const double before = compute_kinetic_energy_J(problem);
            const SolveReport report = solve(problem, settings_of(method));
            CHECK(problem.bodies()[0].velocity_W.allFinite());
            CHECK(std::isfinite(report.residual_m_per_s));
            CHECK(report.converged == (report.residual_m_per_s <= 2.0e-10));
            if (report.converged) {
                CHECK(compute_kinetic_energy_J(problem) <= before * (1.0 + 1.0e-9));
            }
        }
    }
}

TEST_CASE("contact solver: what is squeezed from two sides has bounded impulses, and is counted") {
    constexpr double kMostImpulse_Ns = 1.0e9;
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactProblem problem = squeezed_ball(0.0);
        ContactSolverSettings settings;
        settings.method = method;
        for (int k = 0; k < 20; ++k) {
            const SolveReport report = solve(problem, settings);
            CHECK_FALSE(report.converged);
            CHECK(report.n_regularised > 0);
            for (const ContactConstraint& c : problem.contacts()) {
                CHECK(c.impulse_Ns.x() <= kMostImpulse_Ns);
            }
            CHECK(problem.bodies()[0].velocity_W.cwiseAbs().maxCoeff() <= 1.0);
        }
    }
}

TEST_CASE("contact solver: an answer is the same to the bit whatever was solved before") {
    const ContactCapacity capacity{16, 8, 64};
    const auto chain = [&](int n, int skip, ContactSolver& solver) {
        // Balls tied in a row, and a few across.
        ContactProblem problem(capacity);
        for (int i = 0; i < n; ++i) {
            problem.add_body(1.0 + i, ball_inertia(1.0, 0.1 + 0.01 * i),
                             moving({1.0 * i, 2.0, -0.3 * i}));
        }
        for (int i = 0; i < n; ++i) {
            for (const int far : {1, skip}) {
                problem.add_row(tie(i, moving(-Vector3::UnitX(), 0.1 * Vector3::UnitY()),
                                    (i + far) % n,
                                    moving(Vector3::UnitX(), 0.2 * Vector3::UnitZ())));
            }
        }
        (void)solver.solve(problem);
        std::vector<Vector6> velocities;
        for (const ConstrainedBody& body : problem.bodies()) {
            velocities.push_back(body.velocity_W);
        }
        return velocities;
    };
    for (const ContactMethod method : kContactMethods) {
        CAPTURE(to_string(method));
        ContactSolver fresh(settings_of(method), capacity);
        const std::vector<Vector6> expected = chain(9, 2, fresh);
        ContactSolver used(settings_of(method), capacity);
        (void)chain(9, 4, used);
        CHECK(chain(9, 2, used) == expected);
        (void)chain(5, 2, used);
        CHECK(chain(9, 2, used) == expected);
    }
}

}  // namespace
}  // namespace fulcrum
