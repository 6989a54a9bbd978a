#include "haptics/dynamics/rigid_world.h"

#include <catch2/catch.hpp>

#include <memory>
#include <utility>

namespace fulcrum {
namespace {

TEST_CASE(
    "rigid world: while one end of a plank is pushed out of the ground the other falls freely") {
    constexpr double kHalf_m = 0.1;
    constexpr double kThick_m = 0.01;
    RigidWorldPlan plan;
    const double tilt = 1.25e-3;  // one end 0.1 mm deep, the other 0.15 mm high
    plan.bodies = {
        {.role = BodyRole::ground},
        {.shape = BoxShape{{kHalf_m, kThick_m, 0.02}},
         .pose_W = {{0.0, kThick_m + 2.5e-5, 0.0}, Quaternion(AngleAxis(tilt, Vector3::UnitZ()))}}};
    auto made = RigidWorld::create(plan);
    REQUIRE(made);
    RigidWorld& world = **made;
    const auto height_m = [&](double x) {
        return (world.shape_pose_W(1) * Vector3(x, -kThick_m, 0.0)).y();
    };
    const double deep_m = height_m(-kHalf_m);
    const double high_m = height_m(kHalf_m);
    REQUIRE(deep_m < -9.0e-5);
    REQUIRE(high_m > 1.4e-4);
    for (int i = 0; i < 4; ++i) {
        world.step(1.0e-3);
    }
    // A rod about its end: the far one falls by 3/2 g t^2 / 2; the push, which turns the plank too, only adds to it.
    const double fall_m = 0.5 * 1.5 * 9.81 * 16.0e-6;
    CHECK(height_m(-kHalf_m) > deep_m);
    CHECK(height_m(kHalf_m) < high_m - 0.9 * fall_m);
    for (int i = 0; i < 400; ++i) {
        world.step(1.0e-3);
    }
    CHECK(height_m(-kHalf_m) == Approx(0.0).margin(5.0e-6));
    CHECK(height_m(kHalf_m) == Approx(0.0).margin(5.0e-6));
}

}  // namespace
}  // namespace fulcrum
