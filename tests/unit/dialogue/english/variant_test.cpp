#include "dialogue/english/variant.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE(
    "variant: British and American spellings lead to each other, also in plurals and phrases") {
    CHECK(other_spelling("tyre") == "tire");
    CHECK(other_spelling("tire") == "tyre");
    CHECK(other_spelling("Tyres") == "tires");
    CHECK(other_spelling("car tyre") == "car tire");
    CHECK(other_spelling("grey ball") == "gray ball");
    CHECK(other_spelling("aluminum") == "aluminium");
    CHECK(other_spelling("towards") == "toward");
    CHECK(other_spelling("toward") == "towards");
    for (const char* word : {"colour", "metre", "fibre", "jewellery", "doughnuts", "upwards"}) {
        INFO(word);
        CHECK(other_spelling(other_spelling(word)) == word);
    }
}

TEST_CASE("variant: a word with one spelling has no other") {
    for (const char* word : {"", "s", " ", "tired", "entire", "metal", "watermelon", "-"}) {
        INFO(word);
        CHECK(other_spelling(word).empty());
    }
}
