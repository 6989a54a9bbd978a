#include "dialogue/english/opposite.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

TEST_CASE("opposite: goes both ways, and a word without one has none") {
    using Words = std::vector<std::string_view>;
    CHECK(opposites_of("heavy") == Words{"light"});
    CHECK(opposites_of("light") == Words{"heavy"});
    CHECK(opposites_of("expensive") == Words{"cheap"});
    CHECK(opposites_of("hard") == Words{"soft", "easy"});
    CHECK(opposites_of("easy") == Words{"difficult", "hard"});
    CHECK(opposites_of("wooden").empty());
    CHECK(opposites_of("").empty());
    for (const char* word : {"big", "long", "hot", "thick", "strong", "rough", "near", "stiff",
                             "bumpy", "sticky", "slippery", "hard", "easy"}) {
        for (const std::string_view opposite : opposites_of(word)) {
            INFO(word << ' ' << opposite);
            const Words back = opposites_of(opposite);
            CHECK(std::find(back.begin(), back.end(), word) != back.end());
        }
    }
}
