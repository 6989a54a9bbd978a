#include "haptics/constraint/block_system.h"

#include "haptics/math/to_eigen.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <random>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSolved = 1.0e-11;  // of numbers about 1, condition about 100

struct Pair {
    int a, b;
};

struct Random {
    std::mt19937 engine{7};
    std::uniform_real_distribution<double> number{-1.0, 1.0};
    Matrix6 matrix() {
        return Matrix6::Zero().unaryExpr([&](double) { return number(engine); });
    }
};

// Fills both a BlockSystem and a dense matrix, and compares the answers.
void check_solves(int n, const std::vector<Pair>& pairs, bool symmetric, BlockSystem& system) {
    Random random;
    system.begin(n);
    for (const Pair& pair : pairs) {
        system.add_pair(pair.a, pair.b);
    }
    REQUIRE(system.find_order());
    system.clear(symmetric);
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * n, 6 * n);
    for (int i = 0; i < n; ++i) {
        Matrix6 block = random.matrix();
        if (symmetric) {
            block += block.transpose();
        }
        block += 20.0 * Matrix6::Identity();
        system.diagonal(i) += block;
        dense.block<6, 6>(6 * i, 6 * i) = to_eigen(block);
    }
    for (const Pair& pair : pairs) {
        const Matrix6 K = random.matrix();
        const Matrix6 opposite = symmetric ? K : random.matrix();
        system.add(pair.a, pair.b, K, opposite);
        dense.block<6, 6>(6 * pair.a, 6 * pair.b) += to_eigen(K);
        dense.block<6, 6>(6 * pair.b, 6 * pair.a) += to_eigen(opposite).transpose();
    }
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(6 * n, -1.0, 2.0);
    std::vector<Vector6> g(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        g[static_cast<std::size_t>(i)] = from_eigen(right.segment<6>(6 * i));
    }
    CHECK(system.factor() == 0);
    system.solve(g);
    const Eigen::VectorXd expected = dense.partialPivLu().solve(right);
    for (int i = 0; i < n; ++i) {
        const Vector6& found = g[static_cast<std::size_t>(i)];
        CHECK((found - from_eigen(expected.segment<6>(6 * i))).cwiseAbs().maxCoeff() <= kSolved);
    }
}

TEST_CASE("block system: chains, rings, stars and all with all are solved as a dense matrix is") {
    const std::vector<Pair> chain{{0, 1}, {1, 2}, {3, 2}, {3, 4}, {5, 4}};
    std::vector<Pair> ring = chain;
    ring.push_back({5, 0});
    const std::vector<Pair> star{{0, 1}, {0, 2}, {3, 0}, {0, 4}, {5, 0}};
    std::vector<Pair> all;
    for (int a = 0; a < 6; ++a) {
        for (int b = 0; b < a; ++b) {
            all.push_back((a + b) % 2 == 0 ? Pair{a, b} : Pair{b, a});
        }
    }
    BlockSystem system(6);
    for (const bool symmetric : {true, false}) {
        for (const std::vector<Pair>& pairs : {chain, ring, star, all, std::vector<Pair>{}}) {
            CAPTURE(symmetric, pairs.size());
            check_solves(6, pairs, symmetric, system);
        }
    }
}

TEST_CASE("block system: chains, trees and stars get no fill") {
    for (const bool star : {false, true}) {
        BlockSystem system(40);
        system.begin(40);
        for (int i = 1; i < 40; ++i) {
            system.add_pair(star ? 0 : i - 1, i);
        }
        REQUIRE(system.find_order());
        CHECK(system.n_blocks() == 39);
    }
}

TEST_CASE(
    "block system: an order is kept while the pairs are the same, and follows from them alone") {
    BlockSystem system(4);
    const auto tell = [&](const std::vector<Pair>& pairs) {
        system.begin(4);
        for (const Pair& pair : pairs) {
            system.add_pair(pair.a, pair.b);
        }
        return system.find_order();
    };
    CHECK(tell({{0, 1}, {1, 2}, {2, 3}}));
    CHECK(tell({{3, 2}, {kGround, 3}, {0, 1}, {2, 1}}));
    CHECK(system.n_orders() == 1);
    // Fewer pairs would fit the blocks that are there, but have another order where they come first.
    CHECK(tell({{2, 1}}));
    CHECK(system.n_orders() == 2);
    CHECK(system.n_blocks() == 1);
    CHECK(tell({{0, 3}}));
    CHECK(system.n_orders() == 3);
}

TEST_CASE("block system: more fill than there is room for is told, and less fits again") {
    constexpr int kBodies = 80;  // all with all is 3160 blocks, room is for 32 a body
    BlockSystem system(kBodies);
    system.begin(kBodies);
    for (int a = 0; a < kBodies; ++a) {
        for (int b = 0; b < a; ++b) {
            system.add_pair(a, b);
        }
    }
    CHECK_FALSE(system.find_order());
    system.begin(kBodies);
    system.add_pair(0, 1);
    CHECK(system.find_order());
}

TEST_CASE("block system: a pivot that is lost is replaced and counted, the answer finite") {
    BlockSystem system(1);
    system.begin(1);
    REQUIRE(system.find_order());
    for (const bool symmetric : {true, false}) {
        system.clear(symmetric);
        system.diagonal(0).setConstant(1.0);  // of rank 1
        CHECK(system.factor() == 5);
        std::vector<Vector6> g{Vector6::Ones()};
        system.solve(g);
        CHECK(g[0].allFinite());
    }
}

}  // namespace
}  // namespace fulcrum
