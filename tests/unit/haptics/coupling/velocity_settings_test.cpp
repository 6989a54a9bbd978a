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
    const auto accepts_others = [](double longest_window_s, double acceleration_density) {
        VelocitySettings bounds;
        bounds.longest_window_s = longest_window_s;
        bounds.acceleration_density = acceleration_density;
        return validate(bounds).has_value();
    };
    CHECK(accepts_others(0.0002, 1e-12));
    CHECK(accepts_others(0.008, 1e6));
    CHECK_FALSE(accepts_others(0.00019, 1.0));
    CHECK_FALSE(accepts_others(0.0081, 1.0));
    CHECK_FALSE(accepts_others(0.008, 0.0));
    CHECK_FALSE(accepts_others(0.008, 1.1e6));
}
