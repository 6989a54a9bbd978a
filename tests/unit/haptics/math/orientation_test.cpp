#include "haptics/math/orientation.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace fulcrum {
namespace {

TEST_CASE("orientation: a right-handed corner is positive, its mirror negative, a flat one zero") {
    const Vector3 o = Vector3::Zero();
    CHECK(orientation(o, Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()) == 1);
    CHECK(orientation(o, Vector3::UnitY(), Vector3::UnitX(), Vector3::UnitZ()) == -1);
    CHECK(orientation(o, Vector3::UnitX(), Vector3::UnitY(), Vector3(3.0, -2.0, 0.0)) == 0);
}

TEST_CASE("orientation: exact where rounding is not: one step of a coordinate decides") {
    // On the plane x + y + z = 1 in numbers that are no multiples of each other, moved by one unit in the last place.
    const Vector3 a(0.1, 0.2, 0.7);
    const Vector3 b(0.5, 0.25, 0.25);
    const Vector3 c(0.125, 0.75, 0.125);
    const Vector3 middle = (a + b + c) / 3.0;
    int n_positive = 0;
    int n_negative = 0;
    for (int steps = -40; steps <= 40; ++steps) {
        Vector3 d = middle;
        for (int i = 0; i < std::abs(steps); ++i) {
            d.z() = std::nextafter(d.z(), steps > 0 ? 2.0 : -2.0);
        }
        const int sign = orientation_exact(a, b, c, d);
        // The sign follows d through the plane: it can change only once.
        if (n_positive > 0) {
            REQUIRE(sign == 1);
        }
        n_positive += sign > 0 ? 1 : 0;
        n_negative += sign < 0 ? 1 : 0;
    }
    CHECK(n_positive > 30);
    CHECK(n_negative > 30);
}

TEST_CASE("orientation: agrees with integers on a small grid, for any order of the points") {
    std::mt19937_64 random(5);
    std::uniform_int_distribution<int> coordinate(-3, 3);
    const double far = 1048576.0 + 1.0 / 1024.0;  // rounds products, not differences
    for (int round = 0; round < 20000; ++round) {
        std::array<Matrix<std::int64_t, 3, 1>, 4> exact;
        std::array<Vector3, 4> points;
        for (std::size_t i = 0; i < 4; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                const int value = coordinate(random);
                exact[i][axis] = value;
                points[i][axis] = value * std::ldexp(1.0, -30) + far;
            }
        }
        const Matrix<std::int64_t, 3, 1> u = exact[1] - exact[0];
        const Matrix<std::int64_t, 3, 1> v = exact[2] - exact[0];
        const Matrix<std::int64_t, 3, 1> w = exact[3] - exact[0];
        const std::int64_t determinant = u[0] * (v[1] * w[2] - v[2] * w[1]) +
                                         u[1] * (v[2] * w[0] - v[0] * w[2]) +
                                         u[2] * (v[0] * w[1] - v[1] * w[0]);
        const int expected = determinant > 0 ? 1 : (determinant < 0 ? -1 : 0);
        REQUIRE(orientation(points[0], points[1], points[2], points[3]) == expected);
        REQUIRE(orientation_exact(points[0], points[1], points[2], points[3]) == expected);
        REQUIRE(orientation(points[1], points[0], points[2], points[3]) == -expected);
        REQUIRE(orientation(points[3], points[0], points[1], points[2]) == -expected);
        REQUIRE(orientation(points[2], points[3], points[0], points[1]) == expected);
    }
}

TEST_CASE("orientation: the quick answer is the exact one for points coplanar to within rounding") {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto point = [&] { return Vector3(unit(random), unit(random), unit(random)); };
    for (int round = 0; round < 20000; ++round) {
        const double scale = std::pow(10.0, 6.0 * unit(random));
        const Vector3 a = scale * point();
        const Vector3 b = scale * point();
        const Vector3 c = scale * point();
        const Vector3 d = a + unit(random) * (b - a) + unit(random) * (c - a) +
                          scale * std::pow(10.0, -16.0 + 2.0 * unit(random)) * point();
        REQUIRE(orientation(a, b, c, d) == orientation_exact(a, b, c, d));
    }
}

}  // namespace
}  // namespace fulcrum
