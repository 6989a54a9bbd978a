#include "dialogue/marking/readings.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

TEST_CASE("readings: most answers have one, which is what they say") {
    Mark mark = mark_answer(heaviest(), "the egg is the heaviest");
    REQUIRE(readings_of(mark).size() == 1);
    CHECK(readings_of(mark)[0] == mark.slots);
    CHECK(settle(mark, {true}));
    CHECK_FALSE(settle(mark, {false}));
    CHECK_FALSE(settle(mark, {}));
}

TEST_CASE("readings: what is denied is true where the same is wrong") {
    Mark mark = mark_answer(heaviest(), "the egg is not the heaviest");
    REQUIRE(readings_of(mark).size() == 1);
    CHECK(settle(mark, {false}));
    CHECK_FALSE(settle(mark, {true}));
    CHECK(mark.slot("thing") == "egg");
    // "Rock is not soft" where metal is asked for: nothing that can be said of rock is right.
    Mark feels = mark_answer(feels_how(), "metal is not hard");
    const std::size_t n = readings_of(feels).size();
    REQUIRE(n > 2);
    CHECK(readings_of(feels)[0] == feels.slots);
    std::vector<bool> verdicts(n, false);
    CHECK_FALSE(settle(feels, verdicts));
    verdicts[1] = true;
    CHECK(settle(feels, verdicts));
    verdicts[0] = true;
    CHECK_FALSE(settle(feels, verdicts));
}

TEST_CASE("readings: that there is no difference is true where nothing is right") {
    Mark mark = mark_answer(heaviest(), "they weigh the same");
    REQUIRE(readings_of(mark).size() == 4);
    CHECK(settle(mark, {false, false, false, false}));
    CHECK_FALSE(settle(mark, {true, false, false, false}));
    CHECK(mark.slot("thing") == "apple");  // one that is not right, for the lesson
}

TEST_CASE(
    "readings: no difference of two that are named is no answer whichever of them comes first") {
    // By weight: the lesson's verdict, as a lesson gives it.
    const std::vector<std::string> by_weight{"egg", "banana", "apple", "watermelon"};
    const auto at = [&](std::string_view thing) {
        return std::ranges::find(by_weight, thing) - by_weight.begin();
    };
    const auto is_true = [&](const std::string& said) {
        INFO(said);
        Mark mark = mark_answer(heavier(), said);
        REQUIRE(mark.understood);
        std::vector<bool> verdicts;
        for (const Slots& reading : readings_of(mark)) {
            Mark asked;
            asked.slots = reading;
            verdicts.push_back(at(asked.slot("thing")) > at(asked.slot("other")));
        }
        return settle(mark, verdicts);
    };
    for (const char* said :
         {"the egg is as heavy as the apple", "the apple is as heavy as the egg",
          "the egg is just as heavy as the apple", "the egg weighs the same as the apple",
          "the egg weighs as much as the apple", "the egg and the apple weigh the same",
          "the egg has the same weight as the apple", "the egg and the apple have the same weight",
          "the egg and the apple are equally heavy", "the apple and the egg are the same weight"}) {
        CHECK_FALSE(is_true(said));
    }
    CHECK(is_true("the egg is not as heavy as the apple"));
}

TEST_CASE(
    "readings: of several sentences each is to be right, and what is ruled out is to be wrong") {
    Mark mark = mark_answer(heaviest(), "the egg, not the apple");
    REQUIRE(readings_of(mark).size() == 2);
    CHECK(settle(mark, {true, false}));
    CHECK_FALSE(settle(mark, {true, true}));
    CHECK_FALSE(settle(mark, {false, false}));
    CHECK_FALSE(settle(mark, {true}));
    CHECK(mark.understood);
    // What is told of something else beside the answer need not be wrong.
    Mark both = mark_answer(heavier(), "The egg is heavier, the apple is heavier.");
    REQUIRE(readings_of(both).size() == 2);
    CHECK_FALSE(settle(both, {true, false}));
    CHECK_FALSE(both.understood);
    both = mark_answer(heavier(), "The egg is heavier, the apple is heavier.");
    CHECK_FALSE(settle(both, {false, false}));
    CHECK(both.understood);
}
