#include "dialogue/english/common_noun.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("common nouns: what is foremost no name is one, in any letters") {
    const auto nouns = CommonNouns::open();
    REQUIRE(nouns);
    for (const char* word : {"Apple", "apple", "EGG", "Bowl", "Wood", "Metal", "Torque"}) {
        INFO(word);
        CHECK(nouns->has(word));
    }
    for (const char* word : {"Sun", "Moon", "Earth", "Jupiter", "May", "Newton", "Archimedes",
                             "Galileo", "England", "Monday"}) {
        INFO(word);
        CHECK_FALSE(nouns->has(word));
    }
}

TEST_CASE("common nouns: what is no word is none, and a folder without WordNet is an error") {
    const auto nouns = CommonNouns::open();
    REQUIRE(nouns);
    for (const char* word : {"", " ", "xyzzy", "Apple ", "\xFF", "apple n"}) {
        CHECK_FALSE(nouns->has(word));
    }
    const auto none = CommonNouns::open("/nowhere");
    REQUIRE_FALSE(none);
    CHECK(none.error().message.find("wordnet-base") != std::string::npos);
}
