#include "haptics/dynamics/catcher.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

namespace {

WorldPlan make_plan() {
    WorldPlan plan;
    plan.bodies = {{5.0, 4.0, 0.09, 0.0}, {0.2, 0.6, 0.04, 0.0}, {0.12, 0.4, 0.04, 0.0}};
    plan.catcher.present = true;
    plan.catcher.opening_radius_m = 0.1;
    plan.catcher.depth_m = 0.12;
    return plan;
}

}  // namespace

TEST_CASE("catcher: the opening's border decides, and from below nothing is caught") {
    const Catcher catcher(make_plan().catcher);
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
