#include "haptics/constraint/pair_blocks.h"

#include "haptics/math/to_eigen.h"
#include "tests/support/contact_scenes.h"

#include <catch2/catch.hpp>

#include <Eigen/Dense>
#include <random>
#include <type_traits>
#include <vector>

namespace fulcrum {
namespace {

using namespace contact_scenes;

constexpr double kSame = 1.0e-12;  // of sums of numbers about 1
constexpr int kBodies = 3;

struct Numbers {
    std::mt19937 engine{11};
    std::uniform_real_distribution<double> number{-1.0, 1.0};
    Vector3 vector() {
        const double x = number(engine);
        const double y = number(engine);
        return {x, y, number(engine)};
    }
    Vector6 twist() {
        Vector6 both;
        both.head<3>() = vector();
        both.tail<3>() = vector();
        return both;
    }
    Matrix3 matrix() {
        Matrix3 all;
        all << vector(), vector(), vector();
        return all;
    }
};

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

// The system's answer against that of the dense matrix.
void check_matrix(BlockSystem& system, const Eigen::MatrixXd& dense) {
    const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(6 * kBodies, -1.0, 2.0);
    std::vector<Vector6> g(kBodies);
    for (int i = 0; i < kBodies; ++i) {
        g[static_cast<std::size_t>(i)] = from_eigen(right.segment<6>(6 * i));
    }
    REQUIRE(system.factor() == 0);
    system.solve(g);
    const Eigen::VectorXd expected = dense.partialPivLu().solve(right);
    for (int i = 0; i < kBodies; ++i) {
        const Vector6& found = g[static_cast<std::size_t>(i)];
        CHECK((found - from_eigen(expected.segment<6>(6 * i))).cwiseAbs().maxCoeff() <=
              kSame * (1.0 + expected.cwiseAbs().maxCoeff()) * dense.cwiseAbs().maxCoeff());
    }
}

ContactProblem make_bodies() {
    ContactProblem problem({kBodies, 16, 4});
    for (int i = 0; i < kBodies; ++i) {
        problem.add_body(20.0 + i, ball_inertia(20.0 + i, 1.0 + 0.1 * i), Vector6::Zero());
    }
    return problem;
}

Eigen::MatrixXd make_dense_bodies(const ContactProblem& problem) {
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * kBodies, 6 * kBodies);
    for (int i = 0; i < kBodies; ++i) {
        const ConstrainedBody& body = problem.bodies()[static_cast<std::size_t>(i)];
        dense.block<3, 3>(6 * i, 6 * i) = body.mass_kg * Eigen::Matrix3d::Identity();
        dense.block<3, 3>(6 * i + 3, 6 * i + 3) = to_eigen(body.inertia_W);
    }
    return dense;
}

TEST_CASE("pair blocks: contacts add J^T S J of a dense matrix, whatever touches what and where") {
    for (const bool symmetric : {true, false}) {
        CAPTURE(symmetric);
        Numbers numbers;
        ContactProblem problem = make_bodies();
        // Some of one pair share the bodies' offset and some do not; the ground is either of the two.
        const int pairs[][2] = {{0, 1}, {0, 1},       {0, 1},       {1, 2},      {1, 2},
                                {2, 1}, {kGround, 0}, {kGround, 0}, {2, kGround}};
        Vector3 offset = numbers.vector();
        for (const auto& pair : pairs) {
            ContactConstraint c;
            c.body_a = pair[0];
            c.body_b = pair[1];
            c.arm_b = numbers.vector();
            c.arm_a = c.arm_b + offset;
            c.axes_W = make_contact_axes(compute_direction(numbers.vector()));
            REQUIRE(problem.add_contact(c));
            if (problem.contacts().size() % 2 == 0) {
                offset = numbers.vector();
            }
        }
        BlockSystem system(kBodies);
        system.begin(kBodies);
        Eigen::MatrixXd dense = make_dense_bodies(problem);
        std::vector<Matrix3> slopes;
        for (const ContactConstraint& c : problem.contacts()) {
            system.add_pair(c.body_a, c.body_b);
            Matrix3 slope = numbers.matrix();
            if (symmetric) {
                slope *= slope.transpose();
            }
            slopes.push_back(slope);
            const Eigen::MatrixXd J = find_jacobian(c, 3);
            dense += J.transpose() * to_eigen(slope) * J;
        }
        REQUIRE(system.find_order());
        system.clear(symmetric);
        add_body_blocks(problem.bodies(), system);
        const std::span<const ContactConstraint> contacts = problem.contacts();
        add_contact_blocks(contacts, system,
                           [&](std::size_t i, const Vector3& arm, PairStiffness& pair) noexcept {
                               const Matrix3& axes_W = contacts[i].axes_W;
                               pair.add(axes_W * slopes[i] * axes_W.transpose(), arm);
                           });
        check_matrix(system, dense);
    }
}

TEST_CASE("pair blocks: what is alike in all directions adds what its matrix would") {
    constexpr double kStiff = 3.0;
    Numbers numbers;
    PairStiffness known;
    PairStiffness any;
    for (int i = 0; i < 3; ++i) {
        const Vector3 arm = numbers.vector();
        known.add(kStiff, arm);
        any.add(Matrix3(kStiff * Matrix3::Identity()), arm);
    }
    CHECK((known.matrix() - any.matrix()).cwiseAbs().maxCoeff() <= kSame);
}

TEST_CASE("pair blocks: rows add their stiffness, between bodies and against the ground") {
    Numbers numbers;
    ContactProblem problem = make_bodies();
    const int pairs[][2] = {{0, 1}, {2, 0}, {kGround, 1}, {2, kGround}};
    BlockSystem system(kBodies);
    system.begin(kBodies);
    Eigen::MatrixXd dense = make_dense_bodies(problem);
    for (const auto& pair : pairs) {
        RowConstraint row;
        row.body_a = pair[0];
        row.body_b = pair[1];
        row.jacobian_a = numbers.twist();
        row.jacobian_b = numbers.twist();
        row.most = 1.0;
        REQUIRE(problem.add_row(row));
        system.add_pair(row.body_a, row.body_b);
        const Eigen::MatrixXd J = find_jacobian(row, 1);
        dense += 2.5 * J.transpose() * J;
    }
    REQUIRE(system.find_order());
    system.clear(true);
    add_body_blocks(problem.bodies(), system);
    for (const RowConstraint& row : problem.rows()) {
        add_row_blocks(row, 2.5, system);
    }
    check_matrix(system, dense);
}

}  // namespace
}  // namespace fulcrum
