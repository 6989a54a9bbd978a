#include "haptics/constraint/incremental_ldlt.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <random>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSolved = 1.0e-10;  // of numbers about 1, condition about 1000

// A positive definite matrix as a chain makes it: zero beyond the band.
Eigen::MatrixXd make_matrix(int n, int band) {
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        for (int j = std::max(0, i - band); j < i; ++j) {
            A(i, j) = A(j, i) = number(engine);
        }
        A(i, i) = 2.0 * band;
    }
    return A;
}

void append(IncrementalLdlt& factor, const Eigen::MatrixXd& A, std::vector<int>& rows, int row) {
    std::vector<double> entries;
    for (const int other : rows) {
        entries.push_back(A(row, other));
    }
    REQUIRE(factor.append(entries, A(row, row)));
    rows.push_back(row);
}

void check_solves(const IncrementalLdlt& factor, const Eigen::MatrixXd& A,
                  const std::vector<int>& rows) {
    REQUIRE(factor.size() == rows.size());
    const Eigen::MatrixXd part = A(rows, rows);
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(part.rows(), -1.0, 1.0);
    std::vector<double> x(right.begin(), right.end());
    factor.solve(x);
    const Eigen::VectorXd found = Eigen::Map<const Eigen::VectorXd>(x.data(), part.rows());
    CHECK((part * found - right).cwiseAbs().maxCoeff() <= kSolved);
}

TEST_CASE("incremental ldlt: rows join and leave in any order, and it solves as one made anew") {
    for (const int band : {2, 5, 40}) {
        const Eigen::MatrixXd A = make_matrix(40, band);
        IncrementalLdlt factor(40);
        std::vector<int> rows;
        for (int i = 0; i < 40; i += 2) {
            append(factor, A, rows, i);
        }
        check_solves(factor, A, rows);
        std::mt19937 engine(5);
        for (int k = 0; k < 60; ++k) {
            const int row = static_cast<int>(engine() % 40U);
            const auto at = std::find(rows.begin(), rows.end(), row);
            if (at == rows.end()) {
                append(factor, A, rows, row);
            } else {
                factor.remove(static_cast<std::size_t>(at - rows.begin()));
                rows.erase(at);
            }
            check_solves(factor, A, rows);
        }
    }
}

TEST_CASE(
    "incremental ldlt: a row that follows from others is mended and told, and so is a full one") {
    IncrementalLdlt factor(2);
    CHECK(factor.append({}, 1.0));
    const std::vector<double> same{1.0};
    CHECK_FALSE(factor.append(same, 1.0));
    std::vector<double> x{1.0, 1.0};
    factor.solve(x);
    CHECK(std::abs(x[0] + x[1] - 1.0) <= kSolved);
    const std::vector<double> more{0.0, 0.0};
    CHECK_FALSE(factor.append(more, 1.0));
    CHECK(factor.size() == 2);
}

}  // namespace
}  // namespace fulcrum
