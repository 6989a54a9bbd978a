#include "runtime/arms/maker_values.h"

#include <catch2/catch.hpp>

#include <limits>

namespace fulcrum::runtime {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("maker values: a place is finite and within a metre") {
    CHECK(is_place({0.9, -0.9, 0.0}));
    CHECK_FALSE(is_place({0.0, 1.1, 0.0}));
    CHECK_FALSE(is_place({0.0, 0.0, kNone}));
    CHECK_FALSE(is_place({-kInfinite, 0.0, 0.0}));
}

TEST_CASE(
    "maker values: a matrix 1e-3 off orthogonal is a turn of length 1; a mirror, a stretch and no "
    "number are none") {
    const Quaternion turn(AngleAxis(0.7, Vector3::UnitY()));
    Matrix3 R = turn.toRotationMatrix();
    R(0, 1) += 1.0e-3;
    const auto taken = turn_of(R);
    REQUIRE(taken);
    CHECK(std::abs(taken->norm() - 1.0) < 1.0e-12);
    CHECK(taken->angularDistance(turn) < 2.0e-3);
    R(0, 1) += 0.1;
    CHECK_FALSE(turn_of(R));
    Matrix3 mirror = Matrix3::Identity();
    mirror(2, 2) = -1.0;
    CHECK_FALSE(turn_of(mirror));
    Matrix3 broken = Matrix3::Identity();
    broken(1, 2) = kNone;
    CHECK_FALSE(turn_of(broken));
    CHECK_FALSE(turn_of(Matrix3::Zero()));
}

TEST_CASE(
    "maker values: no more goes to an arm than it was said to give, and nothing that is no "
    "number") {
    const DeviceTraits traits{.name = "weak", .max_force_N = 2.0, .max_torque_Nm = 0.0};
    const Wrench given = bounded({.force = {0.0, -6.0, 8.0}, .torque = {0.1, 0.0, 0.0}}, traits);
    CHECK((given.force - Vector3{0.0, -1.2, 1.6}).norm() < 1.0e-12);
    CHECK(given.torque == Vector3::Zero());
    CHECK(bounded({.force = {0.5, 0.0, 0.0}}, traits).force == Vector3{0.5, 0.0, 0.0});
    CHECK(bounded({.force = {0.5, kInfinite, 0.0}}, traits).force == Vector3::Zero());
}

}  // namespace fulcrum::runtime
