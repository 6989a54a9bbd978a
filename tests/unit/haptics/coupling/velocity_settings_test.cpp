#include "haptics/coupling/velocity_estimator.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE("velocity: settings outside their ranges are refused") {
    CHECK(validate(VelocitySettings{}));
    VelocitySettings settings;
    settings.cutoff_Hz = 0.5;
    CHECK_FALSE(validate(settings));
    settings = {};
    settings.noise_bound_m = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(settings));
}
