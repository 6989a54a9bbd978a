#include "haptics/device/arm/stick_slip.h"

#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

StickSlipProblem make_one(double push, double dry, double low, double high) {
    StickSlipProblem problem;
    problem.inertia = JointMatrix(1, 1);
    problem.inertia(0, 0) = 2.0;
    problem.push = make_joints({push});
    problem.dry = make_joints({dry});
    problem.low = make_joints({low});
    problem.high = make_joints({high});
    return problem;
}

double solve_one(const StickSlipProblem& problem) {
    JointHolds holds{};
    JointVector w;
    solve_stick_slip(problem, holds, w);
    return w(0);
}

// The function that is minimised.
double evaluate(const StickSlipProblem& problem, const JointVector& w) {
    return 0.5 * w.dot(multiply(problem.inertia, w)) - problem.push.dot(w) +
           problem.dry.dot(w.cwiseAbs());
}

StickSlipProblem draw_problem(std::mt19937& random, double spread) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    StickSlipProblem problem;
    // Rows from a thin matrix: coupled as strongly as `spread` is small.
    Eigen::MatrixXd mixing(7, 7);
    for (int i = 0; i < 7; ++i) {
        mixing.col(i) = to_eigen(draw(random, 7, 1.0));
    }
    problem.inertia =
        to_joint_matrix(mixing * mixing.transpose() + spread * Eigen::MatrixXd::Identity(7, 7));
    problem.push = draw(random, 7, 3.0);
    problem.dry = draw(random, 7, 1.0);
    problem.low = -1.0 * draw(random, 7, 1.0).cwiseAbs();
    problem.high = draw(random, 7, 1.0).cwiseAbs();
    for (int i = 0; i < 7; ++i) {
        problem.dry(i) = std::max(problem.dry(i), 0.0);
        // Many joints stand at a stop, some have none near.
        problem.low(i) = unit(random) < 0.2 ? 0.0 : problem.low(i);
        problem.high(i) = unit(random) < 0.2 ? 0.0 : problem.high(i);
        problem.high(i) += unit(random) < 0.3 ? 100.0 : 0.0;
    }
    return problem;
}

}  // namespace

TEST_CASE("stick-slip: one joint sticks, slides and stops as friction says") {
    CHECK(solve_one(make_one(0.9, 1.0, -5.0, 5.0)) == 0.0);
    CHECK(solve_one(make_one(-1.0, 1.0, -5.0, 5.0)) == 0.0);
    CHECK(solve_one(make_one(3.0, 1.0, -5.0, 5.0)) == Approx(1.0));
    CHECK(solve_one(make_one(-3.0, 1.0, -5.0, 5.0)) == Approx(-1.0));
    CHECK(solve_one(make_one(30.0, 1.0, -5.0, 5.0)) == 5.0);
    CHECK(solve_one(make_one(30.0, 1.0, -5.0, 0.0)) == 0.0);
    CHECK(solve_one(make_one(-30.0, 1.0, -5.0, 0.0)) == -5.0);
    CHECK(solve_one(make_one(-3.0, 1.0, 0.0, 0.0)) == 0.0);
    CHECK(solve_one(make_one(3.0, 0.0, -5.0, 5.0)) == Approx(1.5));
}

TEST_CASE("stick-slip: the optimum is found from any sets, and nothing near it is lower") {
    std::mt19937 random(11);
    std::uniform_int_distribution<int> any_hold(0, 4);
    for (int k = 0; k < 2000; ++k) {
        const StickSlipProblem problem = draw_problem(random, 0.1);
        JointHolds holds{};
        for (JointHold& hold : holds) {
            hold = static_cast<JointHold>(any_hold(random));
        }
        JointVector w;
        solve_stick_slip(problem, holds, w);
        for (int i = 0; i < 7; ++i) {
            REQUIRE(w(i) >= problem.low(i));
            REQUIRE(w(i) <= problem.high(i));
        }
        REQUIRE(compute_stick_slip_residual(problem, w) < 1e-10);
        const double least = evaluate(problem, w);
        for (int trial = 0; trial < 20; ++trial) {
            JointVector other = w + draw(random, 7, 0.1);
            for (int i = 0; i < 7; ++i) {
                other(i) = std::clamp(other(i), problem.low(i), problem.high(i));
            }
            REQUIRE(evaluate(problem, other) >= least - 1e-12);
        }
    }
}

TEST_CASE("stick-slip: the sets that were found hold again, in one try, to the same bits") {
    std::mt19937 random(12);
    for (int k = 0; k < 500; ++k) {
        const StickSlipProblem problem = draw_problem(random, 0.1);
        JointHolds holds{};
        JointVector first;
        const bool swept = solve_stick_slip(problem, holds, first).sweeps > 0;
        JointVector settled;
        JointHolds kept = holds;
        const StickSlipCount count = solve_stick_slip(problem, kept, settled);
        // What was swept for stands at zero or at a stop; of which of the two a try may tell better.
        REQUIRE(count.tries <= (swept ? 2 : 1));
        REQUIRE(count.sweeps == 0);
        REQUIRE((settled - first).norm() < 1e-9);
    }
}

TEST_CASE("stick-slip: what the sweeps find is what the sets prove") {
    // Sets that cycle are rare; many draws make sure that some are met.
    std::mt19937 random(13);
    int n_swept = 0;
    for (int k = 0; k < 20000; ++k) {
        const StickSlipProblem problem = draw_problem(random, 0.02);
        JointHolds holds{};
        JointVector w;
        const StickSlipCount count = solve_stick_slip(problem, holds, w);
        if (count.sweeps > 0) {
            ++n_swept;
            REQUIRE(compute_stick_slip_residual(problem, w) < 1e-9);
        }
    }
    CHECK(n_swept > 0);
}
