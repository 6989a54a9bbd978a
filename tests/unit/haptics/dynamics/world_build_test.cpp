#include "haptics/dynamics/world.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

namespace {

WorldPlan make_plan() {
    WorldPlan plan;
    plan.bodies = {{5.0, 4.0, 0.09, 0.0}, {0.2, 0.6, 0.04, 0.0}, {0.12, 0.4, 0.04, 0.0}};
    plan.catcher.present = true;
    plan.catcher.opening_radius_m = 0.1;
    plan.catcher.depth_m = 0.12;
    plan.catcher.capacity = 3;
    return plan;
}

}  // namespace

TEST_CASE("world: plans out of range are refused") {
    CHECK(validate(make_plan()));
    WorldPlan plan = make_plan();
    plan.bodies[1].mass_kg = 0.0;
    REQUIRE_FALSE(validate(plan));
    CHECK(to_sentence(validate(plan).error()).find("of body 1") != std::string::npos);
    plan = make_plan();
    plan.bodies.resize(kMaxBodies + 1);
    CHECK_FALSE(validate(plan));
    plan = make_plan();
    plan.rate_hz = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(plan));
    plan = make_plan();
    plan.catcher.opening_radius_m = 0.0;
    CHECK_FALSE(validate(plan));
}
