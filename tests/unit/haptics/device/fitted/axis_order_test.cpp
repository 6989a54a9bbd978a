// Signed permutations, all 48 of them: power stays, turns stay turns, and what is none is refused.
#include "haptics/device/fitted/axis_order.h"

#include "haptics/math/rotation.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRounding = 1e-12;

std::vector<std::string> all_orders() {
    std::vector<std::string> orders;
    std::string letters = "xyz";
    do {
        for (int signs = 0; signs < 8; ++signs) {
            std::string words;
            for (int i = 0; i < 3; ++i) {
                words += i > 0 ? "," : "";
                words += (signs >> i & 1) != 0 ? "-" : "";
                words += letters[static_cast<std::size_t>(i)];
            }
            orders.push_back(words);
        }
    } while (std::next_permutation(letters.begin(), letters.end()));
    return orders;
}

}  // namespace

TEST_CASE("axis order: each of the 48 is read, says itself again and is another") {
    std::set<std::string> seen;
    for (const std::string& words : all_orders()) {
        const auto order = AxisOrder::read(words);
        REQUIRE(order);
        CHECK(order->text() == words);
        CHECK((order->matrix() * order->matrix().transpose() - Matrix3::Identity()).norm() == 0.0);
        seen.insert(order->text());
    }
    CHECK(seen.size() == 48);
    CHECK(AxisOrder{}.text() == "x,y,z");
    CHECK(AxisOrder::read("+x,+y,+z")->is_plain());
}

TEST_CASE("axis order: what the person's right is stands first") {
    const auto order = AxisOrder::read("-z,y,x");
    REQUIRE(order);
    CHECK(order->turn(Vector3(1.0, 2.0, 3.0)) == Vector3(-3.0, 2.0, 1.0));
    CHECK(order->turn_back({{-3.0, 2.0, 1.0}, Vector3::Zero()}).force == Vector3(1.0, 2.0, 3.0));
}

// v_D = A v_A and w_D of the turned pose; the hand's power must be the same in both frames, mirrors included.
TEST_CASE("axis order: the power of force and torque is the same at the arm and in the scene") {
    const Vector3 velocity_A(0.3, -0.2, 0.5);
    const Vector3 turning_A(0.7, 0.4, -0.9);
    const Wrench felt_D{{1.0, -2.0, 0.5}, {0.1, 0.02, -0.07}};
    const Quaternion before_A = compute_exp(Vector3(0.2, -0.5, 0.3));
    constexpr double kStep_s = 1e-6;
    constexpr double kDifference = 1e-6;  // of a quotient over that step
    const Quaternion after_A = compute_exp(Vector3(turning_A * kStep_s)) * before_A;
    for (const std::string& words : all_orders()) {
        const AxisOrder order = *AxisOrder::read(words);
        const Wrench given_A = order.turn_back(felt_D);
        CHECK(given_A.force.norm() == Approx(felt_D.force.norm()).epsilon(kRounding));
        CHECK(given_A.torque.norm() == Approx(felt_D.torque.norm()).epsilon(kRounding));
        CHECK(given_A.force.dot(velocity_A) ==
              Approx(felt_D.force.dot(order.turn(velocity_A))).margin(kRounding));
        const Vector3 turning_D =
            compute_log(order.turn(after_A) * order.turn(before_A).conjugate()) / kStep_s;
        CHECK(given_A.torque.dot(turning_A) ==
              Approx(felt_D.torque.dot(turning_D)).margin(kDifference));
        // A turned pose is the turned vector's: A (R v) = R' (A v).
        const Vector3 v(0.4, 1.0, -2.0);
        CHECK((order.turn(Vector3(before_A * v)) - order.turn(before_A) * order.turn(v)).norm() <
              kRounding);
    }
}

TEST_CASE("axis order: a matrix is one when it is a signed permutation, and else none") {
    for (const std::string& words : all_orders()) {
        CHECK(AxisOrder::of(AxisOrder::read(words)->matrix())->text() == words);
    }
    CHECK_FALSE(AxisOrder::of(Matrix3::Zero()));
    CHECK_FALSE(AxisOrder::of(0.5 * Matrix3::Identity()));
    CHECK_FALSE(AxisOrder::of(Matrix3::Ones()));
    Matrix3 twice = Matrix3::Identity();
    twice.row(1) = twice.row(0);
    CHECK_FALSE(AxisOrder::of(twice));
    CHECK_FALSE(AxisOrder::of(Matrix3::Constant(std::nan(""))));
}

TEST_CASE("axis order: what is none is refused, with how one is written") {
    for (const char* words : {"", "x", "x,y", "x,y,z,", "x,y,z,x", "x,x,z", "x,y,w", "--x,y,z",
                              "x y z", "X,y,z", ",,", "-,y,z", "x,y,-"}) {
        const auto order = AxisOrder::read(words);
        CAPTURE(words);
        REQUIRE_FALSE(order);
        CHECK(to_sentence(order.error()).find("-x,y,z") != std::string::npos);
    }
}
