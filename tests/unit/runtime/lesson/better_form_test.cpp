#include "runtime/lesson/better_form.h"

#include <catch2/catch.hpp>

#include <algorithm>

using fulcrum::runtime::emphasise_changes;

TEST_CASE("better form: each run of other words is emphasised, and nothing else") {
    CHECK(emphasise_changes("watermelon is most heavy", "A watermelon is the heaviest.") ==
          "*A* watermelon is *the heaviest*.");
    CHECK(emphasise_changes("the apple more heavy is", "The apple is heavier.") ==
          "The apple is *heavier*.");
    CHECK(emphasise_changes("The Apple is heavier", "The apple is heavier.") ==
          "The apple is heavier.");
    // What is only left out has no place of its own.
    CHECK(emphasise_changes("it does pulls more", "It pulls more.") == "It pulls more.");
    CHECK(emphasise_changes("", "It is red.") == "*It is red*.");
    CHECK(emphasise_changes("red", "").empty());
}

TEST_CASE("better form: a short form and letters of other alphabets stay whole") {
    CHECK(emphasise_changes("it is heavier", "It isn't heavier.") == "It *isn't* heavier.");
    CHECK(emphasise_changes("it isn't heavy", "It isn't heavier.") == "It isn't *heavier*.");
    CHECK(emphasise_changes("cafe is here", "The café is here.") == "*The café* is here.");
}

TEST_CASE("better form: without the asterisks it is the right sentence") {
    for (const char* said : {"", "a a a", "the the heaviest watermelon", "isn't it it isn't"}) {
        const std::string right = "It isn't the heaviest, the watermelon isn't.";
        std::string shown = emphasise_changes(said, right);
        std::erase(shown, '*');
        CHECK(shown == right);
    }
}
