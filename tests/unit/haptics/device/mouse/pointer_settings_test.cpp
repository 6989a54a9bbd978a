#include "haptics/device/mouse/pointer_device.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE("pointer: settings outside their ranges are refused with the name and the range") {
    CHECK(validate(PointerSettings{}));
    PointerSettings settings;
    settings.natural_rad_per_s = 1.0;
    REQUIRE_FALSE(validate(settings));
    CHECK(to_sentence(validate(settings).error()).find("natural_rad_per_s is 1") !=
          std::string::npos);
    settings = {};
    settings.max_speed_m_per_s = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(settings));
    settings = {};
    settings.sag_m_per_N = 0.06;
    CHECK_FALSE(validate(settings));
    settings = {};
    settings.slow_per_N = -0.1;
    CHECK_FALSE(validate(settings));
    settings = {};
    settings.half_extent_D.z() = 0.0;
    CHECK_FALSE(validate(settings));
}
