#include "haptics/math/dense.h"
#include "haptics/math/plain_eigen.h"
#include "haptics/math/spectral_radius.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <cmath>
#include <rapidcheck.h>
#include <vector>

using namespace fulcrum;

namespace {

using Eigen::MatrixXd;

constexpr double kRounding = 1.0e-13;  // of systems with a condition of about 100
constexpr int kRounds = 200;

template <class M>
M draw_symmetric(Random& random) {
    const auto m = random.matrix<M>();
    return m + m.transpose();
}
template <class M>
M draw_definite(Random& random) {
    const auto m = random.matrix<M>();
    return m * m.transpose() + 0.1 * M::Identity();
}
// What stands above the diagonal is not to be read.
template <class M>
M spoil_upper(M m) {
    for (Index j = 1; j < M::kColumns; ++j) {
        for (Index i = 0; i < j; ++i) {
            m(i, j) = kNan;
        }
    }
    return m;
}

// To `rounding`: a column each of length 1, across the others, that the matrix only lengthens, by values that rise.
void check_axes(const Matrix3& A, const SymmetricAxes& found, double rounding) {
    const Matrix3& V = found.axes;
    CHECK((A * V - V * found.values.asDiagonal()).norm() < rounding * (1.0 + A.norm()));
    CHECK((V.transpose() * V - Matrix3::Identity()).norm() < rounding);
    CHECK(found.values.x() <= found.values.y());
    CHECK(found.values.y() <= found.values.z());
}

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

TEST_CASE("dense: a positive definite matrix has its triangle, another has none") {
    Random random(1);
    for (int round = 0; round < kRounds; ++round) {
        const auto A = draw_definite<Matrix3>(random);
        const auto L = compute_cholesky(spoil_upper(A));
        REQUIRE(L);
        CHECK((*L * L->transpose() - A).norm() < kRounding);
        CHECK((*L)(0, 1) == 0.0);
        CHECK((*L)(0, 2) == 0.0);
        CHECK((*L)(1, 2) == 0.0);
        CHECK(all_below(Vector3::Zero(), L->diagonal()));
        // One of its values below zero, along any direction.
        const Vector3 n = random.direction();
        const Vector3 along = A * n;
        const Matrix3 bent = A - (1.1 / n.dot(along)) * along * along.transpose();
        CHECK_FALSE(compute_cholesky(bent));
    }
    CHECK_FALSE(compute_cholesky(Matrix3::Zero()));
    CHECK_FALSE(compute_cholesky(-Matrix3::Identity()));
    CHECK(compute_cholesky(Matrix3::Identity()) == Matrix3::Identity());
}

TEST_CASE("dense: systems are solved, by Cholesky and by LU") {
    Random random(2);
    for (int round = 0; round < kRounds; ++round) {
        const auto A = draw_definite<Matrix6>(random);
        const auto b = random.matrix<Vector6>();
        const Vector6 x = solve_cholesky(spoil_upper(A), b);
        CHECK((A * x - b).norm() < kRounding * (1.0 + A.norm() * x.norm()));
        auto any = random.matrix<Matrix6>();
        // The first pivot is not where it stands.
        any(0, 0) = round % 2 == 0 ? 0.0 : any(0, 0);
        const Vector6 y = solve_lu(any, b);
        CHECK((any * y - b).norm() < kRounding * (1.0 + any.norm() * y.norm()));
    }
    CHECK(solve_lu(2.0 * Matrix6::Identity(), Vector6::Ones()) == Vector6::Constant(0.5));
    CHECK(solve_cholesky(4.0 * Matrix6::Identity(), Vector6::Ones()) == Vector6::Constant(0.25));
    CHECK_FALSE(solve_lu(Matrix6::Zero(), Vector6::Ones()).allFinite());
    Matrix6 lost = Matrix6::Identity();
    lost(4, 4) = 0.0;
    CHECK_FALSE(solve_lu(lost, Vector6::Ones()).allFinite());
}

TEST_CASE("dense: the pivots are those of U: their product is the determinant, but for its sign") {
    Random random(3);
    for (int round = 0; round < kRounds; ++round) {
        // A triangle times a triangle, whose determinants are their diagonals'.
        auto L = random.matrix<Matrix6>();
        auto U = random.matrix<Matrix6>();
        double determinant = 1.0;
        for (Index j = 0; j < 6; ++j) {
            for (Index i = 0; i < 6; ++i) {
                (i < j ? L : U)(i, j) = i == j ? U(i, j) : 0.0;
            }
            L(j, j) = 1.0;
        }
        for (Index j = 0; j < 6; ++j) {
            for (Index i = j + 1; i < 6; ++i) {
                U(i, j) = 0.0;
            }
            determinant *= U(j, j);
        }
        Vector6 pivots;
        (void)solve_lu(L * U, Vector6::Ones(), &pivots);
        CHECK(std::abs(pivots.prod()) == Approx(std::abs(determinant)).margin(kRounding));
    }
    Vector6 pivots;
    const Vector6 values = (Vector6() << 3, -2, 5, 7, 1, 4).finished();
    (void)solve_lu(values.asDiagonal(), Vector6::Ones(), &pivots);
    CHECK(pivots == values);
}

TEST_CASE("dense: a lower triangle's transpose is solved from the last number up") {
    Random random(4);
    for (int round = 0; round < kRounds; ++round) {
        auto L = random.matrix<Matrix6>();
        for (Index j = 0; j < 6; ++j) {
            L(j, j) = 2.0 + std::abs(L(j, j));
            for (Index i = 0; i < j; ++i) {
                L(i, j) = 0.0;
            }
        }
        const auto b = random.matrix<Vector6>();
        const Vector6 x = solve_lower_transposed(spoil_upper(L), b);
        CHECK((L.transpose() * x - b).norm() < kRounding);
    }
}

TEST_CASE("dense: a symmetric matrix only lengthens along its axes") {
    Random random(5);
    for (int round = 0; round < kRounds; ++round) {
        const auto A = draw_symmetric<Matrix3>(random);
        check_axes(A, compute_symmetric_axes(spoil_upper(A)), kRounding);
        // By angles, so that half the digits are left where two values are near each other.
        check_axes(A, compute_symmetric_axes_direct(spoil_upper(A)), 1.0e-7);
        // Of known values, also of the same ones, and on any scale.
        const Matrix3 R = random.turn(3.0).toRotationMatrix();
        for (const Vector3& values : {Vector3(-1.0, 2.0, 3.0), Vector3(1.0, 1.0, 4.0),
                                      Vector3(2.0, 2.0, 2.0), Vector3(0.0, 0.0, 1.0)}) {
            for (const double scale : {1.0, 1.0e-9, 1.0e9}) {
                const Matrix3 turned = scale * (R * values.asDiagonal() * R.transpose());
                const Matrix3 even = 0.5 * (turned + turned.transpose());
                const SymmetricAxes found = compute_symmetric_axes(even);
                check_axes(even / scale, {found.values / scale, found.axes}, kRounding);
                CHECK((found.values / scale - values).norm() < kRounding);
                const SymmetricAxes direct = compute_symmetric_axes_direct(even);
                CHECK((direct.values / scale - values).norm() < 1.0e-7);
            }
        }
    }
    const SymmetricAxes plain = compute_symmetric_axes(Vector3(3.0, 1.0, 2.0).asDiagonal());
    CHECK(plain.values == Vector3(1.0, 2.0, 3.0));
    CHECK(plain.axes.cwiseAbs().col(0) == Vector3::UnitY());
    CHECK(compute_symmetric_axes(Matrix3::Zero()).values == Vector3::Zero());
}

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

TEST_CASE("spectral radius: two numbers' matrix gives its equation's root, several modes no more") {
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
