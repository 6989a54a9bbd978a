#include "haptics/math/spectral_radius.h"

#include "haptics/math/plain_eigen.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <cmath>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;

namespace {

using Eigen::MatrixXd;

constexpr double kRounding = 1e-13;

double find_radius(const MatrixXd& A) {
    return compute_spectral_radius({A.data(), static_cast<std::size_t>(A.size())},
                                   static_cast<std::size_t>(A.rows()));
}

MatrixXd make_pair(double length, double angle_rad) {
    MatrixXd turn(2, 2);
    turn << std::cos(angle_rad), -std::sin(angle_rad), std::sin(angle_rad), std::cos(angle_rad);
    return length * turn;
}

}  // namespace

TEST_CASE("spectral radius: of turns and lengths along a diagonal it is the longest, on any axes") {
    MatrixXd A = MatrixXd::Zero(7, 7);
    A.block<2, 2>(0, 0) = make_pair(1.25, 0.3);
    A.block<2, 2>(2, 2) = make_pair(0.5, 2.0);
    A.diagonal().tail<3>() << -1.2, 1e-3, 0.0;
    CHECK(find_radius(A) == Approx(1.25).epsilon(kRounding));
    A(4, 4) = -1.26;
    CHECK(find_radius(A) == Approx(1.26).epsilon(kRounding));
    // T A T^-1 of a shear T.
    MatrixXd T = MatrixXd::Identity(7, 7);
    T.diagonal(1).setConstant(0.7);
    MatrixXd inverse = MatrixXd::Identity(7, 7);
    for (Eigen::Index k = 1; k < 7; ++k) {
        inverse.diagonal(k).setConstant(std::pow(-0.7, static_cast<double>(k)));
    }
    REQUIRE((T * inverse - MatrixXd::Identity(7, 7)).norm() < kRounding);
    CHECK(find_radius(T * A * inverse) == Approx(1.26).epsilon(1e-12));
}

TEST_CASE("spectral radius: of two numbers' matrix it is the root of its square equation") {
    const bool holds = rc::check("two by two", [](double a, double b, double c, double d) {
        MatrixXd A(2, 2);
        A << std::sin(a), std::sin(b), std::sin(c), std::sin(d);
        const double mean = 0.5 * A.trace();
        const double square = mean * mean - A.determinant();
        const double longest =
            square >= 0.0 ? std::abs(mean) + std::sqrt(square) : std::sqrt(A.determinant());
        RC_ASSERT(std::abs(find_radius(A) - longest) < 1e-6 * (1e-6 + longest) + 1e-12);
    });
    CHECK(holds);
}

TEST_CASE("spectral radius: a mode that is there several times grows no more than once") {
    for (const Eigen::Index n : {2, 6, 12}) {
        MatrixXd A = MatrixXd::Identity(n, n);
        A.diagonal(1).setOnes();
        CHECK(find_radius(A) == Approx(1.0).margin(1e-9));
        CHECK(find_radius(0.5 * A) == Approx(0.5).margin(1e-9));
    }
}

TEST_CASE("spectral radius: none of what comes to nothing, infinite of what is not finite") {
    CHECK(find_radius(MatrixXd(0, 0)) == 0.0);
    CHECK(find_radius(MatrixXd::Zero(3, 3)) == 0.0);
    MatrixXd ends = MatrixXd::Zero(3, 3);
    ends.diagonal(1).setOnes();
    CHECK(find_radius(ends) == 0.0);
    CHECK(find_radius(MatrixXd::Constant(1, 1, -1e300)) == Approx(1e300).epsilon(1e-9));
    MatrixXd bad = MatrixXd::Identity(3, 3);
    bad(1, 2) = kNan;
    CHECK(find_radius(bad) == kInfinity);
}
