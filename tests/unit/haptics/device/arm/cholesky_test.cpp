#include "haptics/device/arm/cholesky.h"

#include "tests/unit/haptics/device/arm/arm_fixture.h"

#include <catch2/catch.hpp>

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
