#include "haptics/device/arm/cholesky.h"

#include "haptics/device/arm/arm_posture.h"
#include "haptics/math/plain_eigen.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

// Positive definite: M M^T + `least`.
JointMatrix draw_matrix(std::mt19937& random, int n, double least) {
    Eigen::MatrixXd mixing(n, n);
    for (int i = 0; i < n; ++i) {
        mixing.col(i) = to_eigen(draw(random, n, 1.0));
    }
    return to_joint_matrix(mixing * mixing.transpose() + least * Eigen::MatrixXd::Identity(n, n));
}

}  // namespace

TEST_CASE("Cholesky: the solution solves, for every size that an arm has") {
    std::mt19937 random(71);
    for (int n = 0; n <= kMostJoints; ++n) {
        const JointMatrix matrix = draw_matrix(random, n, 0.01);
        const JointVector right = draw(random, n, 3.0);
        JointMatrix factor = matrix;
        // The upper half is not looked at.
        for (int j = 1; j < n; ++j) {
            for (int i = 0; i < j; ++i) {
                factor(i, j) = 1e9;
            }
        }
        factor_cholesky(factor);
        JointVector solution = right;
        solve_cholesky(factor, solution);
        CHECK((multiply(matrix, solution) - right).norm() <= 1e-12 * (1.0 + right.norm()) * 100.0);
    }
}

TEST_CASE("Cholesky: half a solution gives what the whole one does between two sides") {
    std::mt19937 random(72);
    for (int n = 1; n <= kMostJoints; ++n) {
        const JointMatrix matrix = draw_matrix(random, n, 0.1);
        HandleJacobian rows = HandleJacobian::Zero();
        for (int i = 0; i < n; ++i) {
            rows.col(i) = Vector6(draw(random, 6, 1.0).data());
        }
        JointMatrix factor = matrix;
        factor_cholesky(factor);
        HandleJacobian half = rows;
        solve_lower(factor, half);
        const Eigen::MatrixXd some = to_eigen(rows).leftCols(n);
        const Eigen::MatrixXd whole = some * to_eigen(matrix).llt().solve(some.transpose());
        CHECK((to_eigen(Matrix6(half * half.transpose())) - whole).norm() <= 1e-9 * whole.norm());
    }
}
