#include "haptics/point/friction_problem.h"

#include "tests/support/wander.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

constexpr double kExact = 1.0e-15;
constexpr double kSolved = 1.0e-9;  // of many rounds, in metres of some tenths

FrictionPlane ground(const FrictionLaw& law, bool was_stuck = true) {
    return {.normal = Vector3::UnitY(), .law = law, .was_stuck = was_stuck};
}

TEST_CASE("friction problem: within the static circle the drag takes all of the slip") {
    std::array planes{ground({0.5, 0.3, 0.0})};
    CHECK(solve_friction({0.049, -0.1, 0.0}, planes, 1) == 0.0);
    CHECK(planes[0].stuck);
    CHECK(planes[0].push_m == 0.1);
    CHECK((planes[0].drag - Vector3(-0.049, 0.0, 0.0)).norm() <= kExact);
}

TEST_CASE("friction problem: beyond it the drag is the dynamic coefficient times the push") {
    std::array planes{ground({0.5, 0.3, 0.0})};
    solve_friction({0.03, -0.1, 0.041}, planes, 1);  // 0.0508 m away, 0.05 would hold
    CHECK_FALSE(planes[0].stuck);
    CHECK((planes[0].drag + 0.03 * Vector3(0.03, 0.0, 0.041).normalized()).norm() <= kExact);
}

TEST_CASE("friction problem: what slid is held again within the dynamic circle only") {
    std::array planes{ground({0.5, 0.3, 0.0}, false)};
    solve_friction({0.04, -0.1, 0.0}, planes, 1);
    CHECK_FALSE(planes[0].stuck);
    solve_friction({0.029, -0.1, 0.0}, planes, 1);
    CHECK(planes[0].stuck);
}

TEST_CASE("friction problem: the slip is counted from the anchor, and the push from the plane") {
    std::array planes{ground({0.5, 0.3, 0.0})};
    planes[0].point = Vector3(7.0, 0.2, -3.0);
    planes[0].anchor = Vector3(1.0, 5.0, 0.0);
    solve_friction({1.02, 0.1, 0.0}, planes, 1);
    CHECK(std::abs(planes[0].push_m - 0.1) <= kExact);
    CHECK((planes[0].drag - Vector3(-0.02, 0.0, 0.0)).norm() <= kExact);
}

TEST_CASE("friction problem: the viscous part grows with the slip left, and never turns it round") {
    for (const double beta : {0.0, 0.1, 1.0, 50.0}) {
        std::array planes{ground({0.2, 0.1, beta}, false)};
        const Vector3 hand(0.3, -0.1, 0.0);
        solve_friction(hand, planes, 1);
        const double remaining_m = hand.x() + planes[0].drag.x();
        CHECK(remaining_m > 0.0);
        CHECK(std::abs(-planes[0].drag.x() - (0.01 + beta * remaining_m)) <= 1.0e-14);
    }
}

TEST_CASE("friction problem: a hand in front of the plane is left alone") {
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

}  // namespace
}  // namespace fulcrum
