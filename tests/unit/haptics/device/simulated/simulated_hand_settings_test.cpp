#include "haptics/device/simulated/simulated_hand.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE("simulated hand: settings outside their ranges are refused") {
    CHECK(validate(SimulatedHandSettings{}));
    SimulatedHandSettings settings;
    settings.mass_kg = 0.0;
    REQUIRE_FALSE(validate(settings));
    CHECK(to_sentence(validate(settings).error()).find("mass_kg is 0") != std::string::npos);
    settings = {};
    settings.stiffness_N_per_m = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(settings));
    settings = {};
    settings.start_pose_D.orientation.coeffs() *= 2.0;
    CHECK_FALSE(validate(settings));
}
