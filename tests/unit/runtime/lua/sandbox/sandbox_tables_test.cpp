#include "tests/unit/runtime/lua/told_lessons.h"

#include <catch2/catch.hpp>

TEST_CASE("sandbox: what a lesson is told is what the tables say") {
    fulcrum::hold_tables(FULCRUM_SOURCE_DIR "/tests/unit/runtime/lua/sandbox",
                         fulcrum::runtime::test::told_lessons);
}
