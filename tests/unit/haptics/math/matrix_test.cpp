#include "haptics/math/matrix.h"

#include "haptics/math/plain_eigen.h"
#include "haptics/math/to_eigen.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace fulcrum {
namespace {

using Eigen::MatrixXd;

constexpr double kRounding = 1.0e-14;  // of sums of up to seven products of numbers below 1

// Column after column, as a matrix of any size.
template <class M>
MatrixXd to_dense(const M& m) {
    return Eigen::Map<const MatrixXd>(m.data(), M::kRows, M::kColumns);
}
template <class M>
double find_difference(const M& ours, const MatrixXd& judge) {
    return (to_dense(ours) - judge).cwiseAbs().maxCoeff();
}

// Calls `law` with an unset matrix of each size.
template <class Law>
void for_each_size(const Law& law) {
    law(Vector3());
    law(Vector4());
    law(Vector6());
    law(Matrix<double, 1, 3>());
    law(Matrix3());
    law(Matrix<double, 3, 6>());
    law(Matrix6());
}

// The same list by ours and by the judge.
template <class M>
std::vector<MatrixXd> compute_each(const M& a, const M& b, double s) {
    std::vector<MatrixXd> all;
    for (const M& m : {M(a + b), M(a - b), M(-a), M(a * s), M(s * a), M(a / s), a.cwiseProduct(b),
                       a.cwiseQuotient(b), a.cwiseMin(b), a.cwiseMax(b), a.cwiseMin(s),
                       a.cwiseMax(s), a.cwiseAbs(), a.cwiseAbs2(), a.cwiseAbs().cwiseSqrt(),
                       a.cwiseInverse(), M(9.0 * a).cwiseFloor(), M(9.0 * a).cwiseRound(),
                       a.unaryExpr([](double x) { return x * x * x; })}) {
        all.push_back(to_dense(m));
    }
    return all;
}
std::vector<MatrixXd> judge_each(const MatrixXd& a, const MatrixXd& b, double s) {
    return {a + b,
            a - b,
            -a,
            a * s,
            s * a,
            a / s,
            a.cwiseProduct(b),
            a.cwiseQuotient(b),
            a.cwiseMin(b),
            a.cwiseMax(b),
            a.cwiseMin(s),
            a.cwiseMax(s),
            a.cwiseAbs(),
            a.cwiseAbs2(),
            a.cwiseAbs().cwiseSqrt(),
            a.cwiseInverse(),
            (9.0 * a).array().floor(),
            (9.0 * a).array().round(),
            a.array().cube()};
}

template <class M>
std::vector<double> compute_sums(const M& a, const M& b) {
    return {a.sum(),  a.prod(),     a.dot(b),     a.squaredNorm(),
            a.norm(), a.minCoeff(), a.maxCoeff(), M(a - a.normalized() * a.norm()).norm()};
}
std::vector<double> judge_sums(const MatrixXd& a, const MatrixXd& b) {
    return {a.sum(),         a.prod(), a.cwiseProduct(b).sum(),
            a.squaredNorm(), a.norm(), a.minCoeff(),
            a.maxCoeff(),    0.0};
}

template <class A, class B>
void check_product() {
    Random random(5);
    double worst = 0.0;
    for (int round = 0; round < 20; ++round) {
        const A a = random.matrix<A>();
        const B b = random.matrix<B>();
        const MatrixXd judge = to_dense(a) * to_dense(b);
        // Rows as columns on either side, as a view and as a matrix.
        const auto at = a.transpose().eval();
        const auto bt = b.transpose().eval();
        worst = std::max({worst, find_difference(a * b, judge),
                          find_difference(at.transpose() * b, judge),
                          find_difference(a * bt.transpose(), judge),
                          find_difference((bt * at).transpose().eval(), judge)});
    }
    CHECK(worst < kRounding);
}

}  // namespace

TEST_CASE("matrix: number by number it computes what another library does, to the bit") {
    for_each_size([](auto size) {
        using M = decltype(size);
        Random random(1);
        for (int round = 0; round < 20; ++round) {
            const auto a = random.matrix<M>();
            const auto b = random.matrix<M>();
            const double s = random.uniform();
            CHECK(compute_each(a, b, s) == judge_each(to_dense(a), to_dense(b), s));
            M c = a;
            c += b;
            CHECK(c == a + b);
            c -= a;
            c *= s;
            c /= s;
            CHECK(c == (((a + b) - a) * s) / s);
            CHECK(to_dense(a.transpose().eval()) == to_dense(a).transpose());
            CHECK(a.isApprox(b, 0.7) == to_dense(a).isApprox(to_dense(b), 0.7));
            CHECK(a.isZero(0.9) == to_dense(a).isZero(0.9));
        }
    });
    CHECK(Vector4(-2.5, -0.5, 0.5, 1.5).cwiseRound() == Vector4(-3.0, -1.0, 1.0, 2.0));
    CHECK(Vector2(-0.5, 2.0).cwiseFloor() == Vector2(-1.0, 2.0));
}

TEST_CASE("matrix: single precision and whole numbers obey the same laws") {
    Random random(2);
    const Matrix3f a = random.matrix<Matrix3>().cast<float>();
    const Vector3f v = random.in_cube().cast<float>();
    const auto exact = a.cast<double>() * v.cast<double>();
    CHECK(((a * v).cast<double>() - exact).norm() < 1.0e-6);
    CHECK(Matrix3f(a - a.transpose()).diagonal().isZero(0.0F));
    CHECK(Vector3f(1.1F, -2.0F, 3.0F).cast<double>().cast<float>() == Vector3f(1.1F, -2.0F, 3.0F));
    using Whole = Matrix<std::int64_t, 3, 1>;
    const Whole p(3, -5, 7);
    const Whole q(1 << 20, 2, -4);
    CHECK(p.cross(q) == Whole(6, (7LL << 20) + 12, 6 + (5LL << 20)));
    CHECK(p.dot(q) == (3LL << 20) - 38);
    CHECK(p.allFinite());
    CHECK(Vector3i(1, 2, 3) + Vector3i::Ones() == Vector3i(2, 3, 4));
}

TEST_CASE("matrix: products are those of another library, whatever is read as rows") {
    check_product<Matrix2, Vector2>();
    check_product<Matrix3, Vector3>();
    check_product<Matrix3, Matrix3>();
    check_product<Matrix4, Matrix4>();
    check_product<Matrix6, Matrix6>();
    check_product<Matrix6, Vector6>();
    check_product<Matrix<double, 3, 6>, Matrix<double, 6, 3>>();
    check_product<Matrix<double, 6, 3>, Matrix<double, 3, 6>>();
    check_product<Matrix<double, 6, 7>, Matrix<double, 7, 1>>();
    check_product<Vector6, Matrix<double, 1, 6>>();
    check_product<Matrix<double, 1, 6>, Vector6>();
    // Parts are factors as well.
    Random random(3);
    auto a = random.matrix<Matrix6>();
    const MatrixXd judge = to_dense(a);
    CHECK(find_difference(a.block<3, 3>(1, 2) * a.col(4).tail<3>(),
                          judge.block<3, 3>(1, 2) * judge.col(4).tail<3>()) < kRounding);
    CHECK(find_difference(a.col(1) * a.diagonal().transpose(),
                          judge.col(1) * judge.diagonal().transpose()) < kRounding);
    Matrix6 power = a;
    power *= power;
    CHECK(find_difference(power, judge * judge) < kRounding);
    const Vector6 v = random.matrix<Vector6>();
    CHECK(to_dense(v.asDiagonal() * a) == to_dense(v).col(0).asDiagonal() * judge);
}

TEST_CASE("matrix: sums, lengths and the largest are those of another library") {
    for_each_size([](auto size) {
        using M = decltype(size);
        Random random(4);
        for (int round = 0; round < 20; ++round) {
            const auto a = random.matrix<M>();
            const auto b = random.matrix<M>();
            const std::vector<double> ours = compute_sums(a, b);
            const std::vector<double> judge = judge_sums(to_dense(a), to_dense(b));
            for (std::size_t i = 0; i < judge.size(); ++i) {
                CAPTURE(i);
                CHECK(std::abs(ours[i] - judge[i]) < 2.0 * kRounding);
            }
            M c = a;
            c.normalize();
            CHECK(c == a.normalized());
            int at = -1;
            CHECK(a.maxCoeff(&at) == a.maxCoeff());
            CHECK(a.data()[at] == a.maxCoeff());
            CHECK(a.minCoeff(&at) == a.minCoeff());
            CHECK(a.data()[at] == a.minCoeff());
        }
    });
}

TEST_CASE("matrix: determinants, inverses and cross products are those of another library") {
    Random random(6);
    for (int round = 0; round < 200; ++round) {
        const auto a = random.matrix<Matrix3>();
        const auto small = random.matrix<Matrix2>();
        CHECK(std::abs(a.determinant() - to_dense(a).determinant()) < kRounding);
        CHECK(std::abs(small.determinant() - to_dense(small).determinant()) < kRounding);
        CHECK(std::abs(a.trace() - to_dense(a).trace()) < kRounding);
        const Matrix3 inverse = a.inverse();
        CHECK((a * inverse - Matrix3::Identity()).norm() <
              10.0 * kRounding * a.norm() * inverse.norm() * a.norm() * inverse.norm());
        const Vector3 u = random.vector();
        const Vector3 v = random.vector();
        CHECK(find_difference(u.cross(v), to_eigen(u).cross(to_eigen(v))) < 10.0 * kRounding);
        CHECK(from_eigen(to_eigen(a)) == a);
        CHECK(u.cross(v) == -v.cross(u));
        CHECK(u.cross(u).isZero(0.0));
        CHECK(std::abs(u.unitOrthogonal().dot(u)) < kRounding * u.norm());
        CHECK(u.unitOrthogonal().norm() == Approx(1.0).epsilon(kRounding));
    }
    CHECK_FALSE(Matrix3::Ones().inverse().allFinite());
    CHECK(Vector3::UnitZ().unitOrthogonal().cross(Vector3::UnitZ()).norm() == 1.0);
    CHECK(Vector3(1.0e-30, 0.0, -2.0).unitOrthogonal().norm() == Approx(1.0));
}

TEST_CASE("matrix: what stands where, and what begins as what") {
    const double numbers[] = {1, 2, 3, 4, 5, 6};
    const Matrix<double, 2, 3> m(numbers);
    CHECK(m(1, 0) == 2.0);
    CHECK(m(0, 1) == 3.0);
    CHECK(m.coeff(1, 2) == 6.0);
    CHECK(std::equal(m.begin(), m.end(), numbers));
    CHECK(Vector4(1, 2, 3, 4).w() == 4.0);
    CHECK(to_dense(Matrix<double, 3, 6>::Identity()) == MatrixXd::Identity(3, 6));
    CHECK(Matrix2::Ones().sum() == 4.0);
    CHECK(Vector3::Unit(1) == Vector3::UnitY());
    Matrix3 set;
    CHECK(set.setConstant(2.0) == Matrix3::Constant(2.0));
    CHECK(set.setIdentity() == Matrix3::Identity());
    CHECK(set.setOnes() == Matrix3::Ones());
    CHECK(set.setZero() == Matrix3::Zero());
    static_assert(sizeof(Matrix6) == 36 * sizeof(double));
    static_assert(sizeof(Vector3f) == 3 * sizeof(float));
    static_assert(std::is_trivially_copyable_v<Matrix3>);
    // The compiler computes with them as well.
    static_assert(Vector3(1, 2, 3).cross(Vector3(0, 1, 0)).dot(Vector3(1, 1, 1)) == -2.0);
}

TEST_CASE("matrix: what is no number is told, and goes where it must not be lost") {
    for (int at = 0; at < 4; ++at) {
        Vector4 v(1.0, -3.0, 2.0, -1.0);
        for (const double bad : {kNan, kInfinity, -kInfinity}) {
            CHECK(v.allFinite());
            Vector4 spoilt = v;
            spoilt[at] = bad;
            CHECK_FALSE(spoilt.allFinite());
            CHECK_FALSE(spoilt.isZero(1.0e300));
            CHECK_FALSE(spoilt.isApprox(v));
            CHECK_FALSE(std::isfinite(spoilt.norm()));
            CHECK_FALSE(std::isfinite(spoilt.sum()));
        }
        Vector4 spoilt = v;
        spoilt[at] = kNan;
        CHECK_FALSE(spoilt == spoilt);
        CHECK_FALSE(all_at_most(spoilt, Vector4::Constant(9.0)));
        CHECK_FALSE(all_below(spoilt, Vector4::Constant(9.0)));
        CHECK(std::isnan(spoilt.normalized()[at]));
        // Where two cannot be compared the first stays.
        CHECK(std::isnan(spoilt.cwiseMin(v)[at]));
        CHECK(std::isnan(spoilt.cwiseMax(v)[at]));
        CHECK(v.cwiseMin(spoilt) == v);
        CHECK(v.cwiseMax(spoilt) == v);
        int where = -1;
        CHECK(std::isnan(spoilt.maxCoeff()) == (at == 0));
        CHECK(std::isnan(spoilt.minCoeff()) == (at == 0));
        CHECK(std::isnan(spoilt.maxCoeff(&where)) == (at == 0));
        CHECK(where == (at == 0 ? 0 : at == 2 ? 0 : 2));
        CHECK(std::isnan(spoilt.minCoeff(&where)) == (at == 0));
        CHECK(where == (at == 0 ? 0 : at == 1 ? 3 : 1));
    }
    // The first of several.
    int where = -1;
    CHECK(Vector4(1.0, 2.0, 2.0, 1.0).maxCoeff(&where) == 2.0);
    CHECK(where == 1);
    CHECK(Vector4(2.0, 1.0, 2.0, 1.0).minCoeff(&where) == 1.0);
    CHECK(where == 1);
}

TEST_CASE("matrix: comparisons look at every number, and a zero vector has no direction") {
    const Vector3 a(1.0, 2.0, 3.0);
    CHECK(all_at_most(a, a));
    CHECK_FALSE(all_below(a, a));
    for (int i = 0; i < 3; ++i) {
        Vector3 b = a;
        b[i] += 1.0e-9;
        CHECK_FALSE(a == b);
        CHECK(all_at_most(a, b));
        CHECK_FALSE(all_at_most(b, a));
        CHECK_FALSE(all_below(a, b));
        CHECK(all_below(a, b + Vector3::Constant(1.0e-9)));
        CHECK_FALSE(Vector3(b - a).isZero());
        CHECK(Vector3(b - a).isZero(1.1e-9));
        CHECK(a.isApprox(b, 1.0e-9));
        CHECK_FALSE(a.isApprox(b));
    }
    CHECK(Vector3(1.0e-13, 0.0, -1.0e-13).isZero());
    CHECK(Vector3::Zero().normalized() == Vector3::Zero());
    Vector6 zero = Vector6::Zero();
    zero.normalize();
    CHECK(zero == Vector6::Zero());
}

}  // namespace fulcrum
