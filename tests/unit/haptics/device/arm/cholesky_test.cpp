#include "haptics/device/arm/cholesky.h"

#include "tests/unit/haptics/device/arm/arm_fixture.h"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>

using namespace fulcrum;
using namespace fulcrum::arm_test;

TEST_CASE("Cholesky: the solution solves, for every size that an arm has") {
    std::mt19937 random(71);
    for (int n = 0; n <= kMostJoints; ++n) {
        JointMatrix mixing(n, n);
        for (int i = 0; i < n; ++i) {
            mixing.col(i) = draw(random, n, 1.0);
        }
        const JointMatrix matrix = mixing * mixing.transpose() + 0.01 * JointMatrix::Identity(n, n);
        const JointVector right = draw(random, n, 3.0);
        JointMatrix factor = matrix;
        // The upper half is not looked at.
        factor.triangularView<Eigen::StrictlyUpper>().setConstant(1e9);
        factor_cholesky(factor);
        JointVector solution = right;
        solve_cholesky(factor, solution);
        CHECK((matrix * solution - right).norm() <= 1e-12 * (1.0 + right.norm()) * 100.0);
    }
}

TEST_CASE("Cholesky: half a solution gives what the whole one does between two sides") {
    std::mt19937 random(72);
    for (int n = 1; n <= kMostJoints; ++n) {
        JointMatrix mixing(n, n);
        HandleJacobian rows(6, n);
        for (int i = 0; i < n; ++i) {
            mixing.col(i) = draw(random, n, 1.0);
            rows.col(i) = draw(random, 6, 1.0);
        }
        const JointMatrix matrix = mixing * mixing.transpose() + 0.1 * JointMatrix::Identity(n, n);
        JointMatrix factor = matrix;
        factor_cholesky(factor);
        HandleJacobian half = rows;
        solve_lower(factor, half);
        const Eigen::MatrixXd whole =
            rows * Eigen::MatrixXd(matrix).llt().solve(Eigen::MatrixXd(rows.transpose()));
        CHECK((half * half.transpose() - whole).norm() <= 1e-9 * whole.norm());
    }
}
