#include "haptics/device/simulated/simulated_arm.h"

#include <catch2/catch.hpp>

#include <limits>

using namespace fulcrum;

TEST_CASE("simulated arm: every setting outside its range is refused, by name") {
    CHECK(validate(SimulatedArmSettings{}));
    CHECK(validate(make_desktop_arm()));
    struct Bad {
        const char* name;
        double SimulatedArmSettings::*field;
        double low, high;
    };
    const Bad fields[] = {
        {"mass_kg", &SimulatedArmSettings::mass_kg, 0.0009, 100.1},
        {"dry_friction_N", &SimulatedArmSettings::dry_friction_N, -0.01, 10.1},
        {"damping_Ns_per_m", &SimulatedArmSettings::damping_Ns_per_m, -0.01, 1001.0},
        {"position_resolution_m", &SimulatedArmSettings::position_resolution_m, -1e-9, 0.011},
        {"delay_s", &SimulatedArmSettings::delay_s, -1e-9, 0.0201},
        {"max_force_N", &SimulatedArmSettings::max_force_N, -0.1, 101.0},
    };
    for (const Bad& bad : fields) {
        for (const double value : {bad.low, bad.high, std::numeric_limits<double>::quiet_NaN()}) {
            SimulatedArmSettings settings;
            settings.*bad.field = value;
            const auto checked = validate(settings);
            REQUIRE_FALSE(checked);
            CHECK(to_sentence(checked.error()).find(bad.name) != std::string::npos);
        }
    }
}

TEST_CASE(
    "simulated arm: a hand that is none, a spring too soft to be one and no place are refused") {
    const auto accepts = [](const HumanImpedance& human) {
        SimulatedArmSettings settings;
        settings.human = human;
        return validate(settings).has_value();
    };
    for (const HumanImpedance& preset : {kNobody, kFingertip, kArm, kPosture}) {
        CHECK(accepts(preset));
    }
    CHECK_FALSE(accepts({-0.1, 0.0, 0.0}));
    CHECK_FALSE(accepts({0.0, -0.1, 0.0}));
    CHECK_FALSE(accepts({0.0, 0.0, -1.0}));
    CHECK_FALSE(accepts({0.0, 0.0, 0.5}));
    CHECK_FALSE(accepts({0.0, 0.0, 1.1e8}));
    CHECK_FALSE(accepts({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}));
    SimulatedArmSettings settings;
    settings.start_D.y() = std::numeric_limits<double>::infinity();
    CHECK_FALSE(validate(settings));
}
