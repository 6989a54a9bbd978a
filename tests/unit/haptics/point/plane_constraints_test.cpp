#include "haptics/point/plane_constraints.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kSlack = 1.0e-13;

ConstrainedPoint solve(const Vector3& wish, const std::vector<PlaneConstraint>& planes) {
    return compute_constrained_point(wish, planes, kSlack);
}

TEST_CASE("plane constraints: a wish in front of all planes is the answer") {
    const ConstrainedPoint found =
        solve(Vector3(1.0, 2.0, 3.0), {{Vector3::UnitX(), 0.5}, {Vector3::UnitY(), 2.0}});
    CHECK(found.feasible);
    CHECK(found.n_active == 0);
    CHECK(found.position == Vector3(1.0, 2.0, 3.0));
}

TEST_CASE("plane constraints: face, edge and corner in closed form, with offsets") {
    const Vector3 wish(-1.0, -2.0, -3.0);
    const PlaneConstraint x{Vector3::UnitX(), 0.25};
    const PlaneConstraint y{Vector3::UnitY(), -0.5};
    const PlaneConstraint z{Vector3::UnitZ(), 1.0};
    CHECK((solve(wish, {x}).position - Vector3(0.25, -2.0, -3.0)).norm() < 1e-15);
    CHECK((solve(wish, {x, y}).position - Vector3(0.25, -0.5, -3.0)).norm() < 1e-15);
    const ConstrainedPoint corner = solve(wish, {x, y, z});
    CHECK((corner.position - Vector3(0.25, -0.5, 1.0)).norm() < 1e-15);
    CHECK(corner.n_active == 3);
    CHECK(corner.multiplier[0] == Approx(1.25).epsilon(1e-14));
    CHECK(corner.multiplier[1] == Approx(1.5).epsilon(1e-14));
    CHECK(corner.multiplier[2] == Approx(4.0).epsilon(1e-14));
}

TEST_CASE("plane constraints: an oblique valley in closed form") {
    // Two planes through the z axis, each at 30 degrees from the horizontal: the wish below the line ends on it.
    const PlaneConstraint left{Vector3(0.5, std::sqrt(0.75), 0.0), 0.0};
    const PlaneConstraint right{Vector3(-0.5, std::sqrt(0.75), 0.0), 0.0};
    const ConstrainedPoint on_line = solve(Vector3(0.1, -1.0, 0.7), {left, right});
    CHECK((on_line.position - Vector3(0.0, 0.0, 0.7)).norm() < 1e-15);
    CHECK(on_line.n_active == 2);
    // Far enough aside one plane alone holds it: the foot of the perpendicular.
    const Vector3 aside(2.0, -0.1, 0.7);
    const ConstrainedPoint on_right = solve(aside, {left, right});
    CHECK(on_right.n_active == 1);
    CHECK(on_right.active[0] == 1);
    CHECK((on_right.position - (aside - right.normal.dot(aside) * right.normal)).norm() < 1e-15);
}

TEST_CASE("plane constraints: the answer satisfies the conditions of optimality, at random") {
    std::mt19937_64 random(41);
    std::normal_distribution<double> normal;
    std::array<int, 4> n_with_active{};
    for (int round = 0; round < 20000; ++round) {
        std::vector<PlaneConstraint> planes(1 + static_cast<std::size_t>(round) % kMaxPlanes);
        for (PlaneConstraint& plane : planes) {
            plane.normal = Vector3(normal(random), normal(random), normal(random)).normalized();
            plane.offset_m = -std::abs(normal(random));  // so the origin is allowed
        }
        const Vector3 wish = 5.0 * Vector3(normal(random), normal(random), normal(random));
        const ConstrainedPoint found = solve(wish, planes);
        REQUIRE(found.feasible);
        Vector3 rebuilt = wish;
        for (std::size_t i = 0; i < static_cast<std::size_t>(found.n_active); ++i) {
            const PlaneConstraint& plane = planes[static_cast<std::size_t>(found.active[i])];
            REQUIRE(found.multiplier[i] >= -1e-9);
            REQUIRE(plane.normal.dot(found.position) == Approx(plane.offset_m).margin(1e-9));
            rebuilt += found.multiplier[i] * plane.normal;
        }
        // Nearly parallel planes have large multipliers that cancel: their rounding grows with them.
        const double largest = *std::max_element(found.multiplier.begin(), found.multiplier.end());
        REQUIRE((rebuilt - found.position).norm() <= 1e-12 * (1.0 + std::abs(largest)));
        for (const PlaneConstraint& plane : planes) {
            REQUIRE(plane.normal.dot(found.position) >= plane.offset_m - 1e-9);
        }
        ++n_with_active[static_cast<std::size_t>(found.n_active)];
    }
    for (const int n : n_with_active) {
        CHECK(n > 500);
    }
}

TEST_CASE("plane constraints: planes a millionth of a radian apart keep the position exact") {
    for (const double angle : {1e-2, 1e-4, 1e-6}) {
        const PlaneConstraint left{Vector3(std::sin(angle), std::cos(angle), 0.0), 0.0};
        const PlaneConstraint right{Vector3(-std::sin(angle), std::cos(angle), 0.0), 0.0};
        const Vector3 wish(0.01 * angle, -1.0, 0.3);
        const ConstrainedPoint found =
            compute_constrained_point(wish, std::array{left, right}, 1e-14);
        REQUIRE(found.n_active == 2);
        // The line is known across the planes to the rounding, along them to the rounding over the angle.
        CHECK(std::abs(found.position.y()) < 1e-15);
        CHECK(std::abs(found.position.x()) < 1e-15 / angle);
        CHECK(found.position.z() == Approx(0.3).epsilon(1e-15));
    }
}

TEST_CASE("plane constraints: the same plane given twice acts once") {
    const PlaneConstraint x{Vector3::UnitX(), 0.25};
    const ConstrainedPoint found = solve(Vector3(-1.0, 0.0, 0.0), {x, x, x});
    CHECK(found.feasible);
    CHECK(found.n_active == 1);
    CHECK(found.position.x() == 0.25);
}

TEST_CASE("plane constraints: a gap that is closed has no answer") {
    const ConstrainedPoint found =
        solve(Vector3(0.3, 0.2, 0.1), {{Vector3::UnitX(), 1.0}, {-Vector3::UnitX(), 1.0}});
    CHECK_FALSE(found.feasible);
    CHECK(found.position == Vector3::Zero());
}

TEST_CASE("plane constraints: in a groove of a millionth of a radian both walls hold it exactly") {
    constexpr double kAngle_rad = 1.0e-6;
    const Quaternion turn(AngleAxis(0.7, Vector3(0.3, -0.5, 0.8).normalized()));
    const std::array walls{
        PlaneConstraint{turn * Vector3(std::cos(kAngle_rad), std::sin(kAngle_rad), 0.0), 0.0},
        PlaneConstraint{turn * Vector3(-std::cos(kAngle_rad), std::sin(kAngle_rad), 0.0), 0.0}};
    const ConstrainedPoint found =
        compute_constrained_point(turn * Vector3(0.1, -1.0, 0.3), walls, kSlack);
    REQUIRE(found.n_active == 2);
    // Across the walls to the rounding, along the groove's depth to the rounding over the angle.
    for (const PlaneConstraint& wall : walls) {
        CHECK(std::abs(wall.normal.dot(found.position)) < 1e-15);
    }
    CHECK((found.position - turn * Vector3(0.0, 0.0, 0.3)).norm() < 1e-15 / kAngle_rad);
}

TEST_CASE("plane constraints: a plane that would have to pull, by a millionth, does not act") {
    // The floor lets x be; the left wall is behind the wish by 1e-6, the right one before it by half of that.
    const PlaneConstraint floor{Vector3::UnitY(), 0.0};
    const PlaneConstraint left{Vector3::UnitX(), 0.0};
    const PlaneConstraint right{-Vector3::UnitX(), -5.0e-7};
    const ConstrainedPoint found = solve(Vector3(1.0e-6, -1.0, 0.3), {floor, left, right});
    CHECK((found.position - Vector3(5.0e-7, 0.0, 0.3)).norm() < 1e-15);
    REQUIRE(found.n_active == 2);
    CHECK(found.active[1] == 2);
    CHECK(found.multiplier[1] == Approx(5.0e-7));
}

}  // namespace
}  // namespace fulcrum
