#include "haptics/surface/transient_settings.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE("transient settings: each number is accepted at its bounds and refused just past them") {
    struct Bounds {
        double TransientSettings::*field;
        double low, high;
    };
    const Bounds all[] = {
        {&TransientSettings::force_Ns_per_m, 0.0, 100.0},
        {&TransientSettings::acceleration_per_s, 0.0, 1.0e4},
        {&TransientSettings::frequency_Hz, 5.0, 1000.0},
        {&TransientSettings::decay_per_s, 5.0, 2000.0},
        {&TransientSettings::pulse_s, 0.001, 0.1},
        {&TransientSettings::max_force_N, 0.1, 10.0},
        {&TransientSettings::energy_share, 0.0, 1.0},
    };
    for (const Bounds& bounds : all) {
        const auto accepts = [&bounds](double value) {
            TransientSettings settings;
            settings.*bounds.field = value;
            return validate(settings).has_value();
        };
        CHECK(accepts(bounds.low));
        CHECK(accepts(bounds.high));
        CHECK_FALSE(accepts(bounds.low - 1.0e-6));
        CHECK_FALSE(accepts(bounds.high * 1.001));
        CHECK_FALSE(accepts(std::numeric_limits<double>::quiet_NaN()));
    }
}

TEST_CASE("transient settings: without a kind there is none") {
    TransientSettings settings;
    CHECK_FALSE(settings.any());
    settings.kind = TransientKind::fixed_pulse;
    CHECK(settings.any());
}
