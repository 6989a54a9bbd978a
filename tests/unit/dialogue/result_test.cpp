#include "dialogue/result.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("dialogue result: a failure carries its message and place") {
    const Expected<int> failed = fail("the list is empty; give it a word", 7, 3);
    REQUIRE_FALSE(failed);
    CHECK(failed.error().message == "the list is empty; give it a word");
    CHECK(failed.error().column == 7);
    CHECK(failed.error().line == 3);
    CHECK(concat({"a", "", "bc"}) == "abc");
    CHECK(concat({}).empty());
}
