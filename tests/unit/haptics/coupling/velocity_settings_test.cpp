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
    const auto accepts = [](double cutoff_Hz, double noise_bound_m) {
        VelocitySettings bounds;
        bounds.cutoff_Hz = cutoff_Hz;
        bounds.noise_bound_m = noise_bound_m;
        return validate(bounds).has_value();
    };
    CHECK(accepts(1.0, 1e-9));
    CHECK(accepts(1000.0, 0.1));
    CHECK_FALSE(accepts(0.999, 1e-5));
    CHECK_FALSE(accepts(1000.1, 1e-5));
    CHECK_FALSE(accepts(80.0, 0.9e-9));
    CHECK_FALSE(accepts(80.0, 0.1001));
}
