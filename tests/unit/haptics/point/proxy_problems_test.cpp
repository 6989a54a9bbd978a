#include "haptics/point/friction_problem.h"
#include "haptics/point/plane_constraints.h"
#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kSlack = 1.0e-13;

ConstrainedPoint solve(const Vector3& wish, const std::vector<PlaneConstraint>& planes) {
    return compute_constrained_point(wish, planes, kSlack);
}

constexpr double kExact = 1.0e-15;
constexpr double kSolved = 1.0e-9;  // of many rounds, in metres of some tenths

FrictionPlane ground(const FrictionLaw& law, bool was_stuck = true) {
    return {.normal = Vector3::UnitY(), .law = law, .was_stuck = was_stuck};
}

// How far a solution is from the laws at the head of friction_problem.h, metres.
double find_violation(const Vector3& hand, const std::vector<FrictionPlane>& planes) {
    Vector3 x = hand;
    for (const FrictionPlane& plane : planes) {
        x += plane.push_m * plane.normal + plane.drag;
    }
    double worst = 0.0;
    for (const FrictionPlane& plane : planes) {
        const double gap = plane.normal.dot(x - plane.point);
        const Vector3 away = x - plane.anchor;
        const Vector3 slip = away - plane.normal.dot(away) * plane.normal;
        worst = std::max({worst, -gap, -plane.push_m, std::min(gap, plane.push_m),
                          std::abs(plane.drag.dot(plane.normal))});
        const double circle_m = plane.push_m * (plane.was_stuck ? plane.law.static_coefficient
                                                                : plane.law.dynamic_coefficient);
        if (plane.push_m > 0.0 && (plane.stuck || slip.norm() <= kSolved)) {
            worst = std::max({worst, slip.norm(), plane.drag.norm() - circle_m});
        } else if (plane.push_m > 0.0) {
            const Vector3 right = -(plane.law.dynamic_coefficient * plane.push_m +
                                    plane.law.viscous_ratio * slip.norm()) *
                                  slip.normalized();
            worst = std::max(worst, (plane.drag - right).norm());
        } else {
            worst = std::max(worst, plane.drag.norm());
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("plane constraints: free, face, edge, corner and oblique valley in closed form") {
    const ConstrainedPoint found =
        solve(Vector3(1.0, 2.0, 3.0), {{Vector3::UnitX(), 0.5}, {Vector3::UnitY(), 2.0}});
    CHECK(found.feasible);
    CHECK(found.n_active == 0);
    CHECK(found.position == Vector3(1.0, 2.0, 3.0));
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

TEST_CASE("plane constraints: a plane given twice acts once, a closed gap has no answer") {
    const PlaneConstraint x{Vector3::UnitX(), 0.25};
    const ConstrainedPoint found = solve(Vector3(-1.0, 0.0, 0.0), {x, x, x});
    CHECK(found.feasible);
    CHECK(found.n_active == 1);
    CHECK(found.position.x() == 0.25);
    const ConstrainedPoint closed =
        solve(Vector3(0.3, 0.2, 0.1), {{Vector3::UnitX(), 1.0}, {-Vector3::UnitX(), 1.0}});
    CHECK_FALSE(closed.feasible);
    CHECK(closed.position == Vector3::Zero());
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

TEST_CASE("friction problem: sticks in the static circle, slides, held again in the dynamic") {
    std::array planes{ground({0.5, 0.3, 0.0})};
    CHECK(solve_friction({0.049, -0.1, 0.0}, planes, 1) == 0.0);
    CHECK(planes[0].stuck);
    CHECK(planes[0].push_m == 0.1);
    CHECK((planes[0].drag - Vector3(-0.049, 0.0, 0.0)).norm() <= kExact);
    planes = std::array{ground({0.5, 0.3, 0.0})};
    solve_friction({0.03, -0.1, 0.041}, planes, 1);  // 0.0508 m away, 0.05 would hold
    CHECK_FALSE(planes[0].stuck);
    CHECK((planes[0].drag + 0.03 * Vector3(0.03, 0.0, 0.041).normalized()).norm() <= kExact);
    planes = std::array{ground({0.5, 0.3, 0.0}, false)};
    solve_friction({0.04, -0.1, 0.0}, planes, 1);
    CHECK_FALSE(planes[0].stuck);
    solve_friction({0.029, -0.1, 0.0}, planes, 1);
    CHECK(planes[0].stuck);
    planes = std::array{ground({0.5, 0.3, 0.0})};
    planes[0].point = Vector3(7.0, 0.2, -3.0);
    planes[0].anchor = Vector3(1.0, 5.0, 0.0);
    solve_friction({1.02, 0.1, 0.0}, planes, 1);
    CHECK(std::abs(planes[0].push_m - 0.1) <= kExact);
    CHECK((planes[0].drag - Vector3(-0.02, 0.0, 0.0)).norm() <= kExact);
}

TEST_CASE(
    "friction problem: viscosity grows with the slip and never turns it; in front all is free") {
    for (const double beta : {0.0, 0.1, 1.0, 50.0}) {
        std::array planes{ground({0.2, 0.1, beta}, false)};
        const Vector3 hand(0.3, -0.1, 0.0);
        solve_friction(hand, planes, 1);
        const double remaining_m = hand.x() + planes[0].drag.x();
        CHECK(remaining_m > 0.0);
        CHECK(std::abs(-planes[0].drag.x() - (0.01 + beta * remaining_m)) <= 1.0e-14);
    }
    std::array planes{ground({5.0, 5.0, 10.0})};
    CHECK(solve_friction({0.3, 0.001, 0.0}, planes, 16) == 0.0);
    CHECK(planes[0].push_m == 0.0);
    CHECK(planes[0].drag == Vector3::Zero());
}

TEST_CASE("friction problem: along a right-angled corner the drags of both planes add") {
    // Floor and wall meet along z, of one dynamic coefficient; the hand is 0.1 m under one and 0.05 m behind the other.
    const FrictionLaw law{0.2, 0.2, 0.0};
    std::array planes{ground(law, false),
                      FrictionPlane{.normal = Vector3::UnitX(), .law = law, .was_stuck = false}};
    CHECK(solve_friction({-0.05, -0.1, 0.4}, planes, 200) <= 1.0e-12);
    CHECK(std::abs(planes[0].drag.z() + planes[1].drag.z() + 0.2 * 0.15) <= kSolved);
    CHECK(std::abs(planes[0].drag.x()) + std::abs(planes[1].drag.y()) <= kSolved);
}

TEST_CASE("friction problem: whatever two or three planes hold, each law holds for each of them") {
    Random random(5);
    int n_solved = 0;
    int n_stuck = 0;
    int n_sliding = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        std::vector<FrictionPlane> planes;
        const Vector3 anchor = 0.05 * random.vector();
        const std::size_t count = trial % 2 == 0 ? 2 : 3;
        while (planes.size() < count) {
            const Vector3 normal = random.direction();
            // Not nearly the same plane twice, nor the two sides of one.
            const bool apart = std::ranges::all_of(planes, [&](const FrictionPlane& other) {
                return std::abs(normal.dot(other.normal)) <= 0.5;
            });
            if (apart) {
                const double dynamic = 0.4 * std::abs(random.uniform());
                planes.push_back(
                    {.normal = normal,
                     .point = anchor,
                     .anchor = trial % 4 < 2 ? anchor : Vector3(0.05 * random.vector()),
                     .law = {dynamic * 1.5, dynamic, trial % 3 == 0 ? 0.3 : 0.0},
                     .was_stuck = trial % 5 == 0});
            }
        }
        // Near the anchor, behind all planes, or anywhere.
        Vector3 hand = 0.3 * random.vector();
        if (trial % 4 < 2) {
            hand = anchor + 0.01 * random.vector();
            for (const FrictionPlane& plane : planes) {
                hand -= 0.1 * plane.normal;
            }
        }
        const double left = solve_friction(hand, planes, 200);
        // A plane on the border of its circle may go to and fro; that is what `left` is for.
        if (left <= 1.0e-12) {
            ++n_solved;
            REQUIRE(find_violation(hand, planes) <= kSolved);
            for (const FrictionPlane& plane : planes) {
                n_stuck += plane.push_m > 0.0 && plane.stuck ? 1 : 0;
                n_sliding += plane.push_m > 0.0 && !plane.stuck ? 1 : 0;
            }
        }
    }
    CAPTURE(n_solved, n_stuck, n_sliding);
    CHECK(n_solved > 2800);
    CHECK(n_stuck > 50);
    CHECK(n_sliding > 1000);
}

TEST_CASE("friction problem: in a groove a light touch is held alike wherever the groove lies") {
    const auto touch = [](const Vector3& bottom, double depth_m, double slope) {
        std::array planes{FrictionPlane{.normal = {std::sin(slope), std::cos(slope), 0.0}},
                          FrictionPlane{.normal = {-std::sin(slope), std::cos(slope), 0.0}}};
        for (FrictionPlane& plane : planes) {
            plane.point = plane.anchor = bottom;
            plane.law = {0.5, 0.3, 0.0};
        }
        solve_friction(bottom + depth_m * Vector3(0.1, -1.0, 0.3), planes, 16);
        return planes;
    };
    for (const double slope : {0.2, 0.5, 0.9, 1.3}) {
        const auto here = touch(Vector3::Zero(), 1.0, slope);
        REQUIRE(here[0].push_m + here[1].push_m > 0.5);
        for (const double far_m : {0.3, 1.0, 10.0}) {
            for (const double depth_m : {1.0e-2, 1.0e-3, 1.0e-4, 1.0e-5, 1.0e-6}) {
                const auto there = touch(far_m * Vector3(0.7, -0.31, 0.43), depth_m, slope);
                INFO("slope " << slope << ", " << depth_m << " m deep, " << far_m << " m away");
                // Of the depth: what rounding leaves of the place, times what friction makes of it.
                const double rounding = 1.0e-13 * far_m / depth_m;
                for (std::size_t i = 0; i < 2; ++i) {
                    CHECK(std::abs(there[i].push_m / depth_m - here[i].push_m) <= rounding);
                    CHECK((there[i].drag / depth_m - here[i].drag).norm() <= rounding);
                }
            }
        }
    }
}

TEST_CASE("friction problem: a law is taken over the coupling's stiffness and the loop's period") {
    const FrictionLaw law = make_friction_law({0.6, 0.4, 2.0}, 500.0, 0.001);
    CHECK(law.static_coefficient == 0.6);
    CHECK(law.dynamic_coefficient == 0.4);
    CHECK(law.viscous_ratio == 4.0);
    CHECK(make_friction_law({0.6, 0.4, 2.0}, 0.0, 0.001).viscous_ratio == 0.0);
}
