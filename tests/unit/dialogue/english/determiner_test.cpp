#include "dialogue/english/determiner.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("determiner: of these a noun has one, of others it may have more") {
    for (const char* sole : {"a", "an", "the", "this", "those", "my", "its"}) {
        INFO(sole);
        CHECK(is_sole_determiner(sole));
    }
    // "All the moons", "the two moons", "the other moon"; and no determiners at all.
    for (const char* other : {"all", "both", "two", "other", "one", "it", "moon", "", "The"}) {
        INFO(other);
        CHECK_FALSE(is_sole_determiner(other));
    }
}
