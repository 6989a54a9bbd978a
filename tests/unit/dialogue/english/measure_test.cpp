#include "dialogue/english/measure.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("measure: what is on one scale, and what has a verb") {
    CHECK(measure_of("heavy").opposite == "light");
    CHECK(measure_of("light").opposite == "heavy");
    CHECK(measure_of("heavy").more == "more");
    CHECK(measure_of("light").more == "less");
    CHECK(measure_of("tall").noun == "height");
    CHECK(measure_of("tall").more.empty());
    CHECK(measure_of("rough").is_felt);
    CHECK_FALSE(measure_of("tall").is_felt);
    CHECK(measure_of("slippery").opposite.empty());
    CHECK(measure_of("beautiful").adjective.empty());
    // An opposite's opposite is on the same scale.
    for (const char* adjective : {"heavy", "big", "fast", "hard", "rough", "long", "high", "old"}) {
        CHECK(measure_of(measure_of(adjective).opposite).opposite == adjective);
    }
}
