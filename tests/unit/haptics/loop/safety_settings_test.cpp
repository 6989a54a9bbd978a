#include "haptics/loop/safety.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

using namespace fulcrum;

TEST_CASE("safety: settings outside their ranges are refused with the name and the range") {
    CHECK(validate(SafetySettings{}));
    SafetySettings strong;
    strong.max_force_N = 10.1;
    const auto refused = validate(strong);
    REQUIRE_FALSE(refused);
    CHECK(to_sentence(refused.error()).find("max_force_N is 10.1") != std::string::npos);
    CHECK(to_sentence(refused.error()).find("0.5 to 10") != std::string::npos);
    // The gate itself does not believe them either.
    CHECK(SafetyGate(strong).max_force_N() == kHardForceCap_N);
}

TEST_CASE("safety: each setting is accepted at its bounds and refused just past them") {
    struct Bound {
        double SafetySettings::*field;
        double low, high;
    };
    const Bound bounds[] = {{&SafetySettings::max_force_N, 0.5, 10.0},
                            {&SafetySettings::max_torque_Nm, 0.0, 1.0},
                            {&SafetySettings::max_slew_N_per_s, 10.0, 5000.0},
                            {&SafetySettings::engage_below_N, 0.01, 1.0},
                            {&SafetySettings::soft_start_N_per_s, 0.5, 50.0},
                            {&SafetySettings::soft_start_s, 0.0, 10.0},
                            {&SafetySettings::fade_s, 0.01, 0.5},
                            {&SafetySettings::command_timeout_s, 0.02, 1.0},
                            {&SafetySettings::device_timeout_s, 0.002, 0.1},
                            {&SafetySettings::max_hand_speed_m_per_s, 0.1, 100.0}};
    for (const Bound& bound : bounds) {
        const auto accepts = [&](double value) {
            SafetySettings settings;
            settings.*bound.field = value;
            return validate(settings).has_value();
        };
        CHECK(accepts(bound.low));
        CHECK(accepts(bound.high));
        CHECK_FALSE(accepts(bound.low - 1e-6));
        CHECK_FALSE(accepts(bound.high + 1e-6));
        for (const double bad : {kNan, -1.0, 1e9}) {
            CHECK_FALSE(accepts(bad));
        }
    }
    for (const int cycles : {0, 1, 1000, 1001}) {
        SafetySettings settings;
        settings.engage_cycles = cycles;
        CHECK(validate(settings).has_value() == (cycles >= 1 && cycles <= 1000));
    }
}
