// The matrices that solvers of contacts factor, against dense ones: block_system.h, what pair_blocks.h adds to it, incremental_ldlt.h.
#include "haptics/constraint/block_system.h"

#include "haptics/constraint/incremental_ldlt.h"
#include "haptics/constraint/pair_blocks.h"
#include "haptics/math/plain_eigen.h"
#include "haptics/math/to_eigen.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <type_traits>
#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

struct Pair {
    int a, b;
};

bool find_order(BlockSystem& system, int n, const std::vector<Pair>& pairs) {
    system.begin(n);
    for (const Pair& pair : pairs) {
        system.add_pair(pair.a, pair.b);
    }
    return system.find_order();
}

std::vector<Pair> all_with_all(int n) {
    std::vector<Pair> all;
    for (int a = 0; a < n; ++a) {
        for (int b = 0; b < a; ++b) {
            all.push_back((a + b) % 2 == 0 ? Pair{a, b} : Pair{b, a});
        }
    }
    return all;
}

// The system's answer against that of the dense matrix, within so much of each number.
void check_solves(BlockSystem& system, const Eigen::MatrixXd& dense, double within) {
    const auto n = static_cast<int>(dense.rows()) / 6;
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(6 * n, -1.0, 2.0);
    std::vector<Vector6> g(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        g[static_cast<std::size_t>(i)] = from_eigen(right.segment<6>(6 * i));
    }
    REQUIRE(system.factor() == 0);
    system.solve(g);
    const Eigen::VectorXd expected = dense.partialPivLu().solve(right);
    for (int i = 0; i < n; ++i) {
        CHECK(find_apart(g[static_cast<std::size_t>(i)], from_eigen(expected.segment<6>(6 * i))) <=
              within);
    }
}

TEST_CASE("block system: chains, rings, stars and all with all are solved as a dense matrix is") {
    constexpr int kBodies = 6;
    constexpr double kSolved = 1.0e-11;  // of numbers about 1, condition about 100
    const std::vector<Pair> chain{{0, 1}, {1, 2}, {3, 2}, {3, 4}, {5, 4}};
    std::vector<Pair> ring = chain;
    ring.push_back({5, 0});
    const std::vector<Pair> star{{0, 1}, {0, 2}, {3, 0}, {0, 4}, {5, 0}};
    BlockSystem system(kBodies);
    for (const bool symmetric : {true, false}) {
        for (const std::vector<Pair>& pairs :
             {chain, ring, star, all_with_all(kBodies), std::vector<Pair>{}}) {
            CAPTURE(symmetric, pairs.size());
            Random random(7);
            REQUIRE(find_order(system, kBodies, pairs));
            system.clear(symmetric);
            Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * kBodies, 6 * kBodies);
            for (int i = 0; i < kBodies; ++i) {
                auto block = random.matrix<Matrix6>();
                if (symmetric) {
                    block += block.transpose();
                }
                block += 20.0 * Matrix6::Identity();
                system.diagonal(i) += block;
                dense.block<6, 6>(6 * i, 6 * i) = to_eigen(block);
            }
            for (const Pair& pair : pairs) {
                const auto K = random.matrix<Matrix6>();
                const Matrix6 opposite = symmetric ? K : random.matrix<Matrix6>();
                system.add(pair.a, pair.b, K, opposite);
                dense.block<6, 6>(6 * pair.a, 6 * pair.b) += to_eigen(K);
                dense.block<6, 6>(6 * pair.b, 6 * pair.a) += to_eigen(opposite).transpose();
            }
            check_solves(system, dense, kSolved);
        }
    }
}

TEST_CASE("block system: chains, trees and stars get no fill, and too much fill is told") {
    for (const bool star : {false, true}) {
        std::vector<Pair> pairs;
        for (int i = 1; i < 40; ++i) {
            pairs.push_back({star ? 0 : i - 1, i});
        }
        BlockSystem system(40);
        REQUIRE(find_order(system, 40, pairs));
        CHECK(system.n_blocks() == 39);
    }
    constexpr int kBodies = 80;  // all with all is 3160 blocks, room is for 32 a body
    BlockSystem system(kBodies);
    CHECK_FALSE(find_order(system, kBodies, all_with_all(kBodies)));
    CHECK(find_order(system, kBodies, {{0, 1}}));
}

TEST_CASE("block system: an order is kept while pairs are the same; lost pivots are replaced") {
    BlockSystem system(4);
    CHECK(find_order(system, 4, {{0, 1}, {1, 2}, {2, 3}}));
    CHECK(find_order(system, 4, {{3, 2}, {kGround, 3}, {0, 1}, {2, 1}}));
    CHECK(system.n_orders() == 1);
    // Fewer pairs would fit the blocks that are there, but have another order where they come first.
    CHECK(find_order(system, 4, {{2, 1}}));
    CHECK(system.n_orders() == 2);
    CHECK(system.n_blocks() == 1);
    CHECK(find_order(system, 4, {{0, 3}}));
    CHECK(system.n_orders() == 3);
    system = BlockSystem(1);
    REQUIRE(find_order(system, 1, {}));
    for (const bool symmetric : {true, false}) {
        system.clear(symmetric);
        system.diagonal(0).setConstant(1.0);  // of rank 1
        CHECK(system.factor() == 5);
        std::vector<Vector6> g{Vector6::Ones()};
        system.solve(g);
        CHECK(g[0].allFinite());
    }
}

constexpr int kBodies = 3;  // of pair blocks

// How a contact's or a row's velocity follows from all bodies' twists, by trying each.
template <class Constraint>
Eigen::MatrixXd find_jacobian(const Constraint& constraint, int n_rows) {
    Eigen::MatrixXd J(n_rows, 6 * kBodies);
    for (int column = 0; column < 6 * kBodies; ++column) {
        BodyMotion motion(kBodies);
        motion.velocity(column / 6)[column % 6] = 1.0;
        const auto velocity = compute_relative_velocity(
            constraint, motion.velocity(constraint.body_a), motion.velocity(constraint.body_b));
        if constexpr (std::is_same_v<Constraint, RowConstraint>) {
            J(0, column) = velocity;
        } else {
            J.col(column) = to_eigen(velocity);
        }
    }
    return J;
}

// Three bodies, as a problem and as the diagonal of a dense matrix.
struct Bodies {
    ContactProblem problem{{kBodies, 16, 4}};
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * kBodies, 6 * kBodies);
    BlockSystem system{kBodies};

    Bodies() {
        for (int i = 0; i < kBodies; ++i) {
            const Matrix3 inertia = ball_inertia(20.0 + i, 1.0 + 0.1 * i);
            problem.add_body(20.0 + i, inertia, Vector6::Zero());
            dense.block<3, 3>(6 * i, 6 * i) = (20.0 + i) * Eigen::Matrix3d::Identity();
            dense.block<3, 3>(6 * i + 3, 6 * i + 3) = to_eigen(inertia);
        }
        system.begin(kBodies);
    }
    void begin(bool symmetric) {
        REQUIRE(system.find_order());
        system.clear(symmetric);
        add_body_blocks(problem.bodies(), system);
    }
    void check() {
        constexpr double kSame = 1.0e-12;  // of sums of numbers about 1
        const double size = dense.partialPivLu()
                                .solve(Eigen::VectorXd::LinSpaced(6 * kBodies, -1.0, 2.0))
                                .cwiseAbs()
                                .maxCoeff();
        check_solves(system, dense, kSame * (1.0 + size) * dense.cwiseAbs().maxCoeff());
    }
};

TEST_CASE("pair blocks: contacts add J^T S J of a dense matrix, whatever touches what and where") {
    // Some of one pair share the bodies' offset and some do not; the ground is either of the two.
    const Pair pairs[] = {{0, 1}, {0, 1},       {0, 1},       {1, 2},      {1, 2},
                          {2, 1}, {kGround, 0}, {kGround, 0}, {2, kGround}};
    for (const bool symmetric : {true, false}) {
        CAPTURE(symmetric);
        Random random(11);
        Bodies bodies;
        Vector3 offset = random.in_cube();
        std::vector<Matrix3> slopes;
        for (const Pair& pair : pairs) {
            ContactConstraint c;
            c.body_a = pair.a;
            c.body_b = pair.b;
            c.arm_b = random.in_cube();
            c.arm_a = c.arm_b + offset;
            c.axes_W = make_contact_axes(random.direction());
            REQUIRE(bodies.problem.add_contact(c));
            if (bodies.problem.contacts().size() % 2 == 0) {
                offset = random.in_cube();
            }
            bodies.system.add_pair(c.body_a, c.body_b);
            auto slope = random.matrix<Matrix3>();
            if (symmetric) {
                slope *= slope.transpose();
            }
            slopes.push_back(slope);
            const Eigen::MatrixXd J = find_jacobian(c, 3);
            bodies.dense += J.transpose() * to_eigen(slope) * J;
        }
        bodies.begin(symmetric);
        const std::span<const ContactConstraint> contacts = bodies.problem.contacts();
        add_contact_blocks(contacts, bodies.system,
                           [&](std::size_t i, const Vector3& arm, PairStiffness& pair) noexcept {
                               const Matrix3& axes_W = contacts[i].axes_W;
                               pair.add(axes_W * slopes[i] * axes_W.transpose(), arm);
                           });
        bodies.check();
    }
}

TEST_CASE("pair blocks: what is alike in all directions adds what its matrix would") {
    constexpr double kStiff = 3.0;
    Random random(11);
    PairStiffness known;
    PairStiffness any;
    for (int i = 0; i < 3; ++i) {
        const Vector3 arm = random.in_cube();
        known.add(kStiff, arm);
        any.add(Matrix3(kStiff * Matrix3::Identity()), arm);
    }
    CHECK((known.matrix() - any.matrix()).cwiseAbs().maxCoeff() <= 1.0e-12);
}

TEST_CASE("pair blocks: rows add their stiffness, between bodies and against the ground") {
    Random random(11);
    Bodies bodies;
    for (const Pair& pair : {Pair{0, 1}, Pair{2, 0}, Pair{kGround, 1}, Pair{2, kGround}}) {
        const Vector6 along_a = moving(random.in_cube(), random.in_cube());
        const RowConstraint row =
            tie(pair.a, along_a, pair.b, moving(random.in_cube(), random.in_cube()));
        REQUIRE(bodies.problem.add_row(row));
        bodies.system.add_pair(pair.a, pair.b);
        const Eigen::MatrixXd J = find_jacobian(row, 1);
        bodies.dense += 2.5 * J.transpose() * J;
    }
    bodies.begin(true);
    for (const RowConstraint& row : bodies.problem.rows()) {
        add_row_blocks(row, 2.5, bodies.system);
    }
    bodies.check();
}

TEST_CASE("incremental ldlt: rows join and leave in any order, and it solves as one made anew") {
    constexpr double kSolved = 1.0e-10;  // of numbers about 1, condition about 1000
    for (const int band : {2, 5, 40}) {
        CAPTURE(band);
        // A positive definite matrix as a chain makes it: zero beyond the band.
        Random random(3);
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(40, 40);
        for (int i = 0; i < 40; ++i) {
            for (int j = std::max(0, i - band); j < i; ++j) {
                A(i, j) = A(j, i) = random.uniform();
            }
            A(i, i) = 2.0 * band;
        }
        IncrementalLdlt factor(40);
        std::vector<int> rows;
        for (int k = 0; k < 80; ++k) {
            const int row = k < 20 ? 2 * k : static_cast<int>(random.integer() % 40U);
            const auto at = std::find(rows.begin(), rows.end(), row);
            if (at == rows.end()) {
                std::vector<double> entries;
                for (const int other : rows) {
                    entries.push_back(A(row, other));
                }
                REQUIRE(factor.append(entries, A(row, row)));
                rows.push_back(row);
            } else {
                factor.remove(static_cast<std::size_t>(at - rows.begin()));
                rows.erase(at);
            }
            if (k < 19) {
                continue;
            }
            REQUIRE(factor.size() == rows.size());
            const Eigen::MatrixXd part = A(rows, rows);
            const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(part.rows(), -1.0, 1.0);
            std::vector<double> x(right.begin(), right.end());
            factor.solve(x);
            const Eigen::Map<const Eigen::VectorXd> found(x.data(), part.rows());
            CHECK((part * found - right).cwiseAbs().maxCoeff() <= kSolved);
        }
    }
}

TEST_CASE("incremental ldlt: a row that follows from others is mended and told, a full one too") {
    IncrementalLdlt factor(2);
    CHECK(factor.append({}, 1.0));
    const std::vector<double> same{1.0};
    CHECK_FALSE(factor.append(same, 1.0));
    std::vector<double> x{1.0, 1.0};
    factor.solve(x);
    CHECK(std::abs(x[0] + x[1] - 1.0) <= 1.0e-10);
    const std::vector<double> more{0.0, 0.0};
    CHECK_FALSE(factor.append(more, 1.0));
    CHECK(factor.size() == 2);
}

}  // namespace
}  // namespace fulcrum
