#include "dialogue/marking/said_parts.h"

#include "dialogue/marking/readings.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <string_view>
#include <vector>

using namespace fulcrum::dialogue;

TEST_CASE("said parts: each sentence has its own mark, its errors where they stand in the whole") {
    const std::string_view said = "The apple. It is more heavy.";
    const auto parts = read_parts(heavier(), said, said_sentences(said, false));
    REQUIRE(parts);
    REQUIRE(parts->size() == 2);
    CHECK(parts->front().mark.form_errors.empty());
    REQUIRE(!parts->back().mark.form_errors.empty());
    const FormError& error = parts->back().mark.form_errors.front();
    CHECK(said.substr(error.begin, error.end - error.begin).find("more") == 0);
    CHECK(parts->back().mark.slots == Slots{{"thing", "apple"}});
}

TEST_CASE("said parts: what says nothing is left out, what nobody understands spoils all") {
    const auto parts_of = [](std::string_view said) {
        return read_parts(heavier(), said, said_sentences(said, true));
    };
    CHECK(parts_of("I think so. The apple.")->size() == 1);
    CHECK(parts_of("No, the apple!")->size() == 1);
    CHECK(!parts_of("The apple. Bananas sing."));
    CHECK(!parts_of("The apple. Then the egg."));
    CHECK(read_parts(heavier(), "", {})->empty());
}

TEST_CASE("said parts: what is ruled out is claimed to be wrong, and alone it is no answer") {
    const Mark apple = mark_sentence(heavier(), "the apple");
    const Mark egg = mark_sentence(heavier(), "the egg");
    const auto joined = joined_mark({{apple, false}, {egg, true}}, apple);
    REQUIRE(joined);
    CHECK(joined->claim == Claim::every);
    CHECK(joined->readings == std::vector<Slots>{apple.slots, egg.slots});
    CHECK(joined->denied == std::vector<bool>{false, true});
    CHECK(joined_mark({{apple, false}, {apple, false}}, apple)->claim == Claim::same);
    CHECK(!joined_mark({{egg, true}}, apple));
}
