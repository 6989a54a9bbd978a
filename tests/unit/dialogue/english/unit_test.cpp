#include "dialogue/english/unit.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("unit: newtons and seconds are units, in the plural; eggs are none") {
    CHECK(is_unit("newtons"));
    CHECK(is_unit("seconds"));
    CHECK_FALSE(is_unit("newton"));
    CHECK_FALSE(is_unit("eggs"));
    CHECK_FALSE(is_unit(""));
}
