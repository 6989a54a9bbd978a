#include "haptics/dynamics/catcher.h"

#include "tests/unit/haptics/dynamics/world_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace fulcrum;

TEST_CASE("catcher: the opening's border decides, and from below nothing is caught") {
    const Catcher catcher(make_world_plan().catcher);
    CHECK(catcher.compute_reach_m(0.04) == Approx(0.09));
    CHECK(catcher.compute_reach_m(1.0) == Approx(0.05));
    const auto inside = [&](double x, double from_y, double to_y) {
        return catcher.compute_crossing(Vector3(x, from_y, 0), Vector3(x, to_y, 0), 0.04).inside;
    };
    CHECK(inside(0.089, 0.01, -0.01));
    CHECK_FALSE(inside(0.091, 0.01, -0.01));
    CHECK_FALSE(inside(0.0, -0.01, 0.01));
    CHECK_FALSE(inside(0.0, -0.01, -0.02));
    CHECK_FALSE(inside(0.0, 0.02, 0.01));
    CHECK(inside(0.0, 0.0, -0.01));
    const Crossing slanted =
        catcher.compute_crossing(Vector3(0.2, 0.03, 0.0), Vector3(-0.2, -0.01, 0.0), 0.04);
    CHECK(slanted.share == Approx(0.75));
    CHECK(slanted.radius_m == Approx(0.1));
}

TEST_CASE("catcher: the seeds of a sunflower, each as low as the floor and its neighbours allow") {
    const Catcher catcher(make_world_plan().catcher);
    std::vector<RigidBody> bodies(2, make_rigid_body(make_world_plan().bodies[1]));
    const double aside_m = 0.6 * (0.1 - 0.04);
    const Vector3 first_T = catcher.compute_resting_place(0.04, bodies);
    CHECK((first_T - Vector3(aside_m, -0.12 + 0.04, 0.0)).norm() < 1e-15);
    bodies[0].where = BodyWhere::held;
    bodies[0].resting_place_T = first_T;
    // Turned on by the golden angle, leaning on the first: the centres are two radii apart.
    constexpr double kGoldenAngle_rad = 2.399963229728653;
    const double across_m = 2.0 * aside_m * std::sin(0.5 * kGoldenAngle_rad);
    const Vector3 second_T = catcher.compute_resting_place(0.04, bodies);
    const Vector3 expected_T(aside_m * std::cos(kGoldenAngle_rad),
                             first_T.y() + std::sqrt(0.08 * 0.08 - across_m * across_m),
                             aside_m * std::sin(kGoldenAngle_rad));
    CHECK((second_T - expected_T).norm() < 1e-12);
    // One that fills the opening lies in the middle, upon both.
    CHECK(catcher.compute_resting_place(0.1, bodies).head<1>()[0] == Approx(0.0).margin(1e-15));
}
