#include "haptics/dynamics/world.h"
#include "tests/unit/haptics/dynamics/world_fixture.h"

#include <catch2/catch.hpp>

#include <functional>
#include <limits>

using namespace fulcrum;

TEST_CASE("world: plans out of range are refused") {
    CHECK(validate(make_world_plan()));
    WorldPlan plan = make_world_plan();
    plan.bodies[1].mass_kg = 0.0;
    REQUIRE_FALSE(validate(plan));
    CHECK(to_sentence(validate(plan).error()).find("of body 1") != std::string::npos);
    plan = make_world_plan();
    plan.bodies.resize(kMaxBodies + 1);
    CHECK_FALSE(validate(plan));
    plan = make_world_plan();
    plan.rate_hz = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(plan));
    plan = make_world_plan();
    plan.catcher.opening_radius_m = 0.0;
    CHECK_FALSE(validate(plan));
}

TEST_CASE("world: each range of a plan is refused just outside and accepted at its ends") {
    const auto check = [](double low, double high,
                          const std::function<void(WorldPlan&, double)>& set) {
        const auto accepted = [&set](double value) {
            WorldPlan plan = make_world_plan();
            set(plan, value);
            return validate(plan).has_value();
        };
        CHECK(accepted(low));
        CHECK(accepted(high));
        CHECK_FALSE(accepted(high * 1.001));
        CHECK_FALSE(accepted(low > 0.0 ? low * 0.999 : low * 1.001 - 1e-9));
        CHECK_FALSE(accepted(std::numeric_limits<double>::quiet_NaN()));
    };
    check(100.0, 1000.0, [](WorldPlan& plan, double x) { plan.rate_hz = x; });
    check(-1000.0, 1000.0, [](WorldPlan& plan, double x) { plan.ground_height_m = x; });
    check(0.001, 10.0, [](WorldPlan& plan, double x) { plan.catcher.opening_radius_m = x; });
    check(0.0, 10.0, [](WorldPlan& plan, double x) { plan.catcher.depth_m = x; });
    check(1e-6, 1e4, [](WorldPlan& plan, double x) { plan.bodies[1].mass_kg = x; });
    check(0.0, 1e4, [](WorldPlan& plan, double x) { plan.bodies[1].felt_mass_kg = x; });
    check(0.001, 10.0, [](WorldPlan& plan, double x) { plan.bodies[1].radius_m = x; });
    check(0.0, 10.0, [](WorldPlan& plan, double x) { plan.bodies[1].drag_area_m2 = x; });
    WorldPlan plan = make_world_plan();
    plan.gravity_W = Vector3(60.0, -80.0, 0.0);
    plan.catcher.rim_centre_T = Vector3(6.0, 0.0, 8.0);
    CHECK(validate(plan));
    plan.gravity_W *= 1.001;
    CHECK_FALSE(validate(plan));
    plan = make_world_plan();
    plan.catcher.rim_centre_T = Vector3(6.01, 0.0, 8.0);
    CHECK_FALSE(validate(plan));
}
