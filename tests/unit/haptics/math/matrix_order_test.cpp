// In which order numbers are added: the same source gives the same bits wherever it is compiled.
#include "haptics/math/matrix.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

namespace fulcrum {
namespace {

constexpr int kRounds = 1000;

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

}  // namespace

TEST_CASE("matrix order: three are added from the last, four in two pairs, more from the first") {
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
}

TEST_CASE("matrix order: products add from the first, three of at most three rows from the last") {
    const auto in_order = [](const auto& terms) { return add_in_order(terms); };
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

}  // namespace fulcrum
