#include "haptics/coupling/passivity.h"

#include <catch2/catch.hpp>

#include <limits>
#include <string>

using namespace fulcrum;

TEST_CASE("passivity settings: the ranges named at each field, and nothing else") {
    struct Field {
        double PassivitySettings::*value;
        double low, high;
        const char* name;
    };
    const Field fields[] = {
        {&PassivitySettings::handle_mass_kg, 0.001, 10.0, "handle_mass_kg"},
        {&PassivitySettings::handle_inertia_kg_m2, 1e-8, 1.0, "handle_inertia_kg_m2"},
        {&PassivitySettings::headroom_J, 0.0, 0.01, "headroom_J"},
        {&PassivitySettings::memory_s, 0.01, 10.0, "memory_s"},
    };
    CHECK(validate(PassivitySettings{}));
    CHECK(PassivitySettings{}.on);
    for (const Field& field : fields) {
        for (const double good : {field.low, field.high}) {
            PassivitySettings settings;
            settings.*field.value = good;
            CHECK(validate(settings));
        }
        for (const double bad : {field.low * 0.999 - 1e-9, field.high * 1.001,
                                 std::numeric_limits<double>::quiet_NaN()}) {
            PassivitySettings settings;
            settings.*field.value = bad;
            REQUIRE_FALSE(validate(settings));
            CHECK(to_sentence(validate(settings).error()).find(field.name) != std::string::npos);
        }
    }
}
