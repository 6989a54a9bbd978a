#include "haptics/device/arm/arm_posture.h"
#include "haptics/device/arm/cholesky.h"
#include "haptics/device/arm/joint_matrix.h"
#include "haptics/math/plain_eigen.h"
#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/device/arm/arm_fixture.h"
#include "tests/unit/haptics/device/arm/dense_joints.h"

#include <catch2/catch.hpp>

#include <Eigen/Cholesky>
#include <cmath>

using namespace fulcrum;
using namespace fulcrum::arm_test;

namespace {

// Positive definite: M M^T + `least`.
JointMatrix draw_definite(std::mt19937& random, int n, double least) {
    Eigen::MatrixXd mixing(n, n);
    for (int i = 0; i < n; ++i) {
        mixing.col(i) = to_eigen(draw(random, n, 1.0));
    }
    return to_joint_matrix(mixing * mixing.transpose() + least * Eigen::MatrixXd::Identity(n, n));
}

constexpr double kRounding = 1.0e-14;  // of sums of seven products of numbers below 1

JointMatrix draw_matrix(std::mt19937& random, int rows, int cols) {
    JointMatrix m(rows, cols);
    for (int i = 0; i < rows; ++i) {
        const JointVector row = draw(random, cols, 1.0);
        for (int j = 0; j < cols; ++j) {
            m(i, j) = row(j);
        }
    }
    return m;
}

}  // namespace

TEST_CASE("Cholesky: the solution solves, for every size that an arm has") {
    std::mt19937 random(71);
    for (int n = 0; n <= kMostJoints; ++n) {
        const JointMatrix matrix = draw_definite(random, n, 0.01);
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
        const JointMatrix matrix = draw_definite(random, n, 0.1);
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

TEST_CASE("joint vector: for any number of joints it computes what another library does") {
    std::mt19937 random(1);
    for (int n = 0; n <= kMostJoints; ++n) {
        for (int round = 0; round < 20; ++round) {
            const JointVector a = draw(random, n, 1.0);
            const JointVector b = draw(random, n, 1.0);
            const Eigen::VectorXd ja = to_eigen(a);
            const Eigen::VectorXd jb = to_eigen(b);
            REQUIRE(a.size() == n);
            REQUIRE(ja.size() == n);
            CHECK(to_joints(ja) == a);
            CHECK(to_eigen(a + b) == ja + jb);
            CHECK(to_eigen(a - b) == ja - jb);
            CHECK(to_eigen(0.3 * a) == 0.3 * ja);
            CHECK(to_eigen(a * 0.3) == ja * 0.3);
            CHECK(to_eigen(a.cwiseAbs()) == ja.cwiseAbs());
            CHECK(std::abs(a.dot(b) - ja.dot(jb)) < kRounding);
            CHECK(std::abs(a.norm() - ja.norm()) < kRounding);
            CHECK(a.maxCoeff() == (n == 0 ? 0.0 : ja.maxCoeff()));
            JointVector c = a;
            c += b;
            CHECK(c == a + b);
            c -= a;
            CHECK(c == (a + b) - a);
            c *= 0.7;
            CHECK(c == 0.7 * ((a + b) - a));
        }
    }
}

TEST_CASE("joint vector: it begins with zeros, and so does what is new in it") {
    for (int n = 0; n <= kMostJoints; ++n) {
        CHECK(JointVector(n).norm() == 0.0);
        CHECK(JointVector::Zero(n) == JointVector(n));
        JointVector v = JointVector(kMostJoints);
        for (int i = 0; i < kMostJoints; ++i) {
            v(i) = 1.0 + i;
        }
        v.resize(n);
        CHECK(v.size() == n);
        v.resize(kMostJoints);
        for (int i = 0; i < kMostJoints; ++i) {
            CHECK(v[i] == (i < n ? 1.0 + i : 0.0));
        }
        v.setZero();
        CHECK(v == JointVector(kMostJoints));
    }
    CHECK(JointVector().size() == 0);
    CHECK_FALSE(JointVector(2) == JointVector(3));
    CHECK_FALSE(make_joints({1.0, 2.0}) == make_joints({1.0, 3.0}));
    CHECK(make_joints({-3.0, -1.0, -2.0}).maxCoeff() == -1.0);
}

TEST_CASE("joint matrix: for any shape it computes what another library does") {
    std::mt19937 random(2);
    for (int rows = 0; rows <= kMostJoints; ++rows) {
        for (int cols = 0; cols <= kMostJoints; ++cols) {
            const JointMatrix a = draw_matrix(random, rows, cols);
            const JointVector v = draw(random, cols, 1.0);
            REQUIRE(a.rows() == rows);
            REQUIRE(a.cols() == cols);
            const Eigen::MatrixXd judge = to_eigen(a);
            const JointVector product = multiply(a, v);
            REQUIRE(product.size() == rows);
            CHECK((to_eigen(product) - judge * to_eigen(v)).norm() < kRounding);
            CHECK(to_eigen(a.transpose()) == judge.transpose());
            CHECK(to_eigen(JointMatrix::Identity(rows, cols)) ==
                  Eigen::MatrixXd::Identity(rows, cols));
            CHECK(to_eigen(JointMatrix::Zero(rows, cols)) == Eigen::MatrixXd::Zero(rows, cols));
            CHECK(to_eigen(to_joint_matrix(judge)) == judge);
        }
    }
}

TEST_CASE("joint matrix: each row is added from its first number to its last, to the bit") {
    std::mt19937 random(3);
    for (const int n : {2, 6, kMostJoints}) {
        for (int round = 0; round < 200; ++round) {
            const JointMatrix a = draw_matrix(random, n, n);
            const JointVector v = draw(random, n, 1.0);
            const JointVector product = multiply(a, v);
            for (int i = 0; i < n; ++i) {
                double sum = 0.0;
                for (int j = 0; j < n; ++j) {
                    sum += a(i, j) * v(j);
                }
                REQUIRE(product(i) == sum);
            }
        }
    }
}

TEST_CASE("joint matrix: what is not finite is told, of the joints that there are") {
    for (const double bad : {kNan, kInfinity}) {
        for (int i = 0; i < 4; ++i) {
            JointVector v(4);
            v(i) = bad;
            CHECK_FALSE(v.allFinite());
            CHECK_FALSE(std::isfinite(v.norm()));
            v.resize(i);
            CHECK(v.allFinite());
            JointMatrix m(4, 4);
            m(i, 3 - i) = bad;
            CHECK_FALSE(m.allFinite());
            m(i, 3 - i) = 0.0;
            CHECK(m.allFinite());
        }
    }
}
