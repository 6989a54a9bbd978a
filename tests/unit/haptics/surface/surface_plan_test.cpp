#include "haptics/surface/surface_plan.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE("surface plan: a plan that asks for nothing is good, and each part is checked") {
    CHECK(validate(SurfacePlan{}));
    SurfacePlan texture;
    texture.texture.gain = -1.0;
    CHECK_FALSE(validate(texture));
    SurfacePlan transient;
    transient.transient.pulse_s = 1.0;
    CHECK_FALSE(validate(transient));
    SurfacePlan shading;
    shading.shading.crease_angle_deg = 181.0;
    REQUIRE_FALSE(validate(shading));
    CHECK(to_sentence(validate(shading).error()).find("0 to 180") != std::string::npos);
}

TEST_CASE("surface plan: a crease angle is 0 to 180 degrees") {
    CHECK(validate(ShadingSettings{true, 0.0}));
    CHECK(validate(ShadingSettings{true, 180.0}));
    CHECK_FALSE(validate(ShadingSettings{true, -0.1}));
    CHECK_FALSE(validate(ShadingSettings{true, std::numeric_limits<double>::quiet_NaN()}));
}
