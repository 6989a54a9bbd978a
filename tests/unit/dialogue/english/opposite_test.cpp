#include "dialogue/english/opposite.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("opposite: goes both ways, and a word without one has none") {
    CHECK(opposite_of("heavy") == "light");
    CHECK(opposite_of("light") == "heavy");
    CHECK(opposite_of("expensive") == "cheap");
    CHECK(opposite_of("wooden").empty());
    CHECK(opposite_of("").empty());
    for (const char* word : {"big", "long", "hot", "thick", "strong", "rough", "near", "stiff",
                             "bumpy", "sticky", "slippery"}) {
        INFO(word);
        CHECK(opposite_of(opposite_of(word)) == word);
    }
}
