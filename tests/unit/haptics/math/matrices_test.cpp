#include "haptics/math/matrix.h"
#include "haptics/math/to_eigen.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <type_traits>

using namespace fulcrum;

namespace {

constexpr int kRounds = 1000;
using Eigen6 = Eigen::Matrix<double, 6, 6>;

// From the first to the last.
template <class M>
double add_in_order(const M& terms) {
    double sum = terms.data()[0];
    for (Index i = 1; i < M::kSize; ++i) {
        sum += terms.data()[i];
    }
    return sum;
}
double add_three(const Vector3& t) {
    return t[0] + (t[1] + t[2]);
}
double add_four(const Vector4& t) {
    return (t[0] + t[1]) + (t[2] + t[3]);
}

// The sum as it is, as it must be, and as another order has it, of numbers by chance: to the bit as it must be, and such that one can tell.
template <class M, class Sum, class Right, class Other>
void check_order(const Sum& sum, const Right& right, const Other& other) {
    Random random(12);
    int n_told = 0;
    for (int round = 0; round < kRounds; ++round) {
        const M a = random.matrix<M>();
        const M b = random.matrix<M>();
        const M terms = a.cwiseProduct(b);
        REQUIRE(sum(a, b) == right(terms));
        n_told += right(terms) != other(terms) ? 1 : 0;
    }
    CHECK(n_told > kRounds / 20);
}

// Each number of A B is what `right` makes of its terms.
template <class A, class B, class Right>
void check_product_order(const Right& right) {
    using Terms = Matrix<double, A::kColumns, 1>;
    Random random(13);
    for (int round = 0; round < kRounds; ++round) {
        const A a = random.matrix<A>();
        const B b = random.matrix<B>();
        const auto product = a * b;
        for (int i = 0; i < A::kRows; ++i) {
            for (int j = 0; j < B::kColumns; ++j) {
                const Terms terms = a.row(i).transpose().cwiseProduct(b.col(j));
                REQUIRE(product(i, j) == right(terms));
            }
        }
    }
}

// The same change to a matrix of ours and to one that keeps a copy of what it reads.
template <class Change>
void check_alike(const Change& change) {
    Random random(8);
    Matrix6 ours = random.matrix<Matrix6>();
    Eigen6 judge = to_eigen(ours);
    const Eigen6 before = judge;
    change(ours, judge, before);
    CHECK(to_eigen(ours) == judge);
    CHECK(judge != before);
}

// Calls `act` with each kind of part of ours and with the same one of the judge, by the names that both have for them.
template <class M, class J, class Act>
void for_each_part(M& m, J& j, const Act& act) {
    act(m.col(2), j.col(2));
    act(m.row(5), j.row(5));
    act(m.diagonal(), j.diagonal());
    act(m.template block<2, 3>(1, 3), j.template block<2, 3>(1, 3));
    act(m.template topLeftCorner<3, 2>(), j.template topLeftCorner<3, 2>());
    act(m.template topRightCorner<3, 2>(), j.template topRightCorner<3, 2>());
    act(m.template bottomLeftCorner<3, 2>(), j.template bottomLeftCorner<3, 2>());
    act(m.template bottomRightCorner<3, 2>(), j.template bottomRightCorner<3, 2>());
    act(m.template leftCols<2>(), j.template leftCols<2>());
    act(m.template rightCols<2>(), j.template rightCols<2>());
    act(m.template topRows<2>(), j.template topRows<2>());
    act(m.template bottomRows<2>(), j.template bottomRows<2>());
    // Parts of parts.
    act(m.col(4).template head<2>(), j.col(4).template head<2>());
    act(m.diagonal().template tail<3>(), j.diagonal().template tail<3>());
}

}  // namespace

// In which order numbers are added: the same source gives the same bits wherever it is compiled.

TEST_CASE("matrix order: sums and products add in the order that is told") {
    const auto sum = [](const auto& a, const auto& b) { return a.cwiseProduct(b).sum(); };
    const auto dot = [](const auto& a, const auto& b) { return a.dot(b); };
    const auto in_order = [](const auto& terms) { return add_in_order(terms); };
    check_order<Vector3>(sum, add_three, in_order);
    check_order<Vector3>(dot, add_three, in_order);
    check_order<Vector4>(sum, add_four, in_order);
    check_order<Vector4>(dot, add_four, in_order);
    const auto backwards = [](const Vector6& t) {
        double all = t[5];
        for (Index i = 4; i >= 0; --i) {
            all += t[i];
        }
        return all;
    };
    check_order<Vector6>(sum, in_order, backwards);
    check_order<Vector6>(dot, in_order, backwards);
    Random random(14);
    for (int round = 0; round < kRounds; ++round) {
        const Vector3 v = random.vector();
        REQUIRE(v.squaredNorm() == add_three(v.cwiseAbs2()));
        REQUIRE(v.norm() == std::sqrt(add_three(v.cwiseAbs2())));
        const auto m = random.matrix<Matrix3>();
        REQUIRE(m.sum() == add_in_order(m));
        REQUIRE(m.trace() == add_three(m.diagonal()));
    }
    check_product_order<Matrix3, Vector3>(add_three);
    check_product_order<Matrix3, Matrix3>(add_three);
    check_product_order<Matrix<double, 1, 3>, Matrix3>(add_three);
    check_product_order<Matrix2, Matrix2>(in_order);
    check_product_order<Matrix4, Vector4>(in_order);
    check_product_order<Matrix6, Vector6>(in_order);
    check_product_order<Matrix6, Matrix6>(in_order);
    check_product_order<Matrix<double, 3, 6>, Vector6>(in_order);
    check_product_order<Matrix<double, 6, 3>, Vector3>(in_order);
}

// Parts of matrices, how they are filled, and in which order numbers are added.

TEST_CASE("matrix parts: what is written to a part is written to its whole, and to nothing else") {
    Random random(8);
    Matrix6 ours = random.matrix<Matrix6>();
    Eigen6 judge = to_eigen(ours);
    int n_parts = 0;
    for_each_part(ours, judge, [&](auto part, auto same) {
        const Matrix6 ours_before = ours;
        const Eigen6 judge_before = judge;
        const double number = 10.0 + ++n_parts;
        part = decltype(part)::Value::Constant(number);
        same.setConstant(number);
        CAPTURE(n_parts);
        CHECK(to_eigen(ours) == judge);
        CHECK(judge != judge_before);
        ours = ours_before;
        judge = judge_before;
    });
    CHECK(n_parts == 14);
    check_alike([](auto& m, auto& j, auto&) {
        m.template block<3, 3>(2, 1).diagonal()[1] = j(3, 2) = 7.0;
    });
    check_alike([](auto& m, auto& j, auto&) { m.row(3)[1] = j(3, 1) = 9.0; });
    check_alike([](auto& m, auto& j, auto&) {
        m.template bottomRightCorner<2, 2>()(1, 0) = j(5, 4) = 9.0;
    });
    check_alike([](auto& m, auto& j, auto&) { m.row(1) *= 3.0, j.row(1) *= 3.0; });
    check_alike([](auto& m, auto& j, auto&) { m.col(1) /= 3.0, j.col(1) /= 3.0; });
    check_alike([](auto& m, auto& j, auto&) {
        m.diagonal().setConstant(2.0), j.diagonal().setConstant(2.0);
    });
    check_alike([](auto& m, auto& j, auto&) { m.row(0).setZero(), j.row(0).setZero(); });
}

TEST_CASE("matrix parts: what is assigned may overlap what it is assigned to") {
    check_alike([](auto& m, auto& j, auto& b) { m = m.transpose(), j = b.transpose(); });
    check_alike([](auto& m, auto& j, auto& b) { m += m.transpose(), j += b.transpose(); });
    check_alike([](auto& m, auto& j, auto& b) {
        m.template block<4, 4>(0, 0) = m.template block<4, 4>(1, 2);
        j.template block<4, 4>(0, 0) = b.template block<4, 4>(1, 2);
    });
    check_alike([](auto& m, auto& j, auto& b) {
        m.template block<4, 4>(1, 2) = m.template block<4, 4>(0, 0);
        j.template block<4, 4>(1, 2) = b.template block<4, 4>(0, 0);
    });
    check_alike([](auto& m, auto& j, auto& b) {
        m.template block<3, 3>(0, 0) = m.template block<3, 3>(1, 0).transpose();
        j.template block<3, 3>(0, 0) = b.template block<3, 3>(1, 0).transpose();
    });
    check_alike([](auto& m, auto& j, auto& b) {
        m.template block<3, 3>(1, 1) += m.template block<3, 3>(0, 0);
        j.template block<3, 3>(1, 1) += b.template block<3, 3>(0, 0);
    });
    check_alike([](auto& m, auto& j, auto& b) {
        m.template block<3, 3>(1, 1) -= m.template block<3, 3>(0, 2);
        j.template block<3, 3>(1, 1) -= b.template block<3, 3>(0, 2);
    });
    check_alike([](auto& m, auto& j, auto& b) {
        m.col(0) = m.row(0).transpose();
        j.col(0) = b.row(0).transpose();
    });
    check_alike([](auto& m, auto& j, auto& b) {
        m.row(2) = m.diagonal().transpose();
        j.row(2) = b.diagonal().transpose();
    });
    check_alike([](auto& m, auto& j, auto& b) {
        // Of the same kind, and one that itself cannot be changed.
        const auto to = m.col(3).template tail<4>();
        to = m.col(3).template head<4>();
        j.col(3).template tail<4>() = b.col(3).template head<4>();
    });
    check_alike([](auto& m, auto& j, auto& b) {
        m.col(2) = m * m.col(2);
        Matrix6 copy = from_eigen(b);
        j.col(2) = to_eigen(copy * copy.col(2));
    });
}

TEST_CASE("matrix parts: a part of what cannot be changed is a copy or a view to read") {
    Random random(9);
    const auto m = random.matrix<Matrix6>();
    const Eigen6 judge = to_eigen(m);
    for_each_part(m, judge, [](const auto& part, const auto& same) {
        CHECK(to_eigen(typename std::decay_t<decltype(part.eval())>(part)) == same);
    });
    CHECK(m.row(1).transpose().dot(m.col(1)) ==
          Approx(judge.row(1).transpose().dot(judge.col(1))).epsilon(1.0e-14));
    // Nor does it compile to assign to such a part.
    static_assert(!std::is_assignable_v<decltype(m.col(0)), Vector6>);
    static_assert(!std::is_assignable_v<decltype(m.diagonal()), Vector6>);
    static_assert(!std::is_assignable_v<decltype(m.topRows<2>()), Matrix<double, 2, 6>>);
    static_assert(!std::is_assignable_v<decltype(m.bottomRows<2>()), Matrix<double, 2, 6>>);
    static_assert(!std::is_assignable_v<decltype(m.block<3, 3>(0, 0)), Matrix3>);
    static_assert(!std::is_assignable_v<decltype(m.row(0)[0]), double>);
    static_assert(!std::is_assignable_v<decltype(m.transpose()(0, 0)), double>);
    // Of what goes, rows as columns are kept.
    const auto kept = (m + m).transpose();
    static_assert(std::is_same_v<decltype(kept), const Matrix6>);
    CHECK(to_eigen(kept) == 2.0 * judge.transpose());
}

TEST_CASE("matrix parts: a view computes what its copy does") {
    Random random(10);
    auto m = random.matrix<Matrix6>();
    const auto view = m.block<3, 3>(2, 1);
    const Matrix3 copy = view;
    const auto numbers = [](const auto& of) {
        return std::array{of.determinant(), of.trace(),    of.norm(),
                          of.minCoeff(),    of.maxCoeff(), of.sum()};
    };
    CHECK(numbers(view) == numbers(copy));
    CHECK(view.inverse() == copy.inverse());
    CHECK(view.cwiseAbs() == copy.cwiseAbs());
    CHECK(view.cwiseAbs2() == copy.cwiseAbs2());
    CHECK(view.cwiseAbs().cwiseSqrt() == copy.cwiseAbs().cwiseSqrt());
    CHECK(view.cwiseMin(copy.transpose()) == copy.cwiseMin(copy.transpose()));
    CHECK(view.cwiseMax(copy.transpose()) == copy.cwiseMax(copy.transpose()));
    CHECK(view.cwiseProduct(copy) == copy.cwiseAbs2());
    CHECK(view.allFinite());
    CHECK(view.isApprox(copy, 0.0));
    CHECK(view + view == 2.0 * copy);
    CHECK(view - copy == Matrix3::Zero());
    CHECK(-view == -copy);
    CHECK(view / 3.0 == copy / 3.0);
    const auto line = m.diagonal().tail<3>();
    const Vector3 v = line;
    CHECK(line.x() == v.x());
    CHECK(line.y() == v.y());
    CHECK(line.z() == v.z());
    CHECK(line.dot(v) == v.squaredNorm());
    CHECK(line.squaredNorm() == v.squaredNorm());
    CHECK(line.normalized() == v.normalized());
    CHECK(line.cross(Vector3::UnitX()) == v.cross(Vector3::UnitX()));
    CHECK(line.cast<float>() == v.cast<float>());
    CHECK(Matrix3::Zero().isZero(0.0));
}

TEST_CASE("matrix parts: numbers and parts fill row by row from the left") {
    Matrix<double, 2, 3> m;
    m << 1, 2, 3, 4, 5, 6;
    CHECK(m(0, 2) == 3.0);
    CHECK(m(1, 0) == 4.0);
    Random random(11);
    const auto a = random.matrix<Matrix3>();
    const Vector3 v = random.in_cube();
    Matrix4 whole;
    whole << a, v, v.transpose(), 7.0;
    CHECK(whole.topLeftCorner<3, 3>() == a);
    CHECK(whole.topRightCorner<3, 1>() == v);
    CHECK(whole.bottomLeftCorner<1, 3>() == Matrix<double, 1, 3>(v.data()));
    CHECK(whole(3, 3) == 7.0);
    Vector6 both;
    both << v, 2.0 * v;
    CHECK(both.head<3>() == v);
    CHECK(both.tail<3>() == 2.0 * v);
    CHECK((Vector6() << 1, v.head<2>(), v).finished() ==
          (Vector6() << 1, v.x(), v.y(), v.x(), v.y(), v.z()).finished());
    Matrix3 columns;
    columns << v, 2.0 * v, 3.0 * v;
    CHECK(columns == v * Vector3(1, 2, 3).transpose());
    // A part is filled likewise, and what is beside it stays.
    const double held_numbers[] = {1, 3, 2, 4};  // column after column
    Matrix6 held = Matrix6::Zero();
    held.block<2, 2>(1, 3) << 1, 2, 3, 4;
    held.col(5).head<3>() << v;
    held.row(5) << 8, 9, 0, 0, 0, 0;
    CHECK(held.block<2, 2>(1, 3) == Matrix2(held_numbers));
    CHECK(held.col(5).head<3>() == v);
    CHECK(held.row(5)[0] == 8.0);
    CHECK(held.row(5)[1] == 9.0);
    CHECK(held.cwiseAbs().sum() == Approx(27.0 + v.cwiseAbs().sum()).epsilon(1.0e-14));
}
