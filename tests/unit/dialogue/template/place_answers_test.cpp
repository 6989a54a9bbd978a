#include "dialogue/template/place_answers.h"

#include "dialogue/marking/mark.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

Question where(std::vector<std::string> places) {
    return compiled({"where",
                     "Where is the block?",
                     {"[(it|the block) is] {place} [the] {thing}"},
                     {{"place", std::move(places)}, {"thing", {"box", "bowl"}}}});
}

}  // namespace

TEST_CASE("place answers: a place is told without its thing, of whatever that is") {
    const Question question = where({"on top of|on", "under|below", "in the middle of"});
    const struct {
        const char *said, *place, *back;
    } rows[] = {{"on top", "on top of", "On top."},
                {"it is on top", "on top of", "It is on top."},
                {"below", "under", "Below."},
                {"in the middle", "in the middle of", "In the middle."},
                {"it's under it", "under", "It is under it."}};
    for (const auto& row : rows) {
        INFO(row.said);
        const Mark mark = mark_answer(question, row.said);
        REQUIRE(mark.understood);
        CHECK(mark.claim == Claim::of_any);
        CHECK(mark.slot("place") == row.place);
        CHECK(mark.form_right());
        CHECK(mark.short_answer);
        CHECK(mark.corrected == row.back);
        REQUIRE(mark.readings.size() == 2);
        CHECK(mark.readings[1].back() == std::pair<std::string, std::string>("thing", "bowl"));
    }
    CHECK(mark_answer(question, "on the box").claim == Claim::same);
}

TEST_CASE("place answers: what needs a thing is no answer alone, nor what is no place") {
    CHECK_FALSE(mark_answer(where({"next to", "on"}), "next to").understood);
    CHECK_FALSE(mark_answer(where({"next to", "on"}), "on").understood);
    CHECK(mark_answer(where({"next to", "on"}), "next to it").claim == Claim::of_any);
    const Question colour = compiled({"q",
                                      "?",
                                      {"it is {colour} {thing}"},
                                      {{"colour", {"red", "blue"}}, {"thing", {"box", "bowl"}}}});
    CHECK_FALSE(mark_answer(colour, "it is red it").understood);
}
