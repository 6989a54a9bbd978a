#include "dialogue/marking/wording.h"

#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

Question why_question() {
    QuestionSource source{"why",
                          "Why did it come down?",
                          {"[because] there is no {nothing}", "[because] the {nothing} stopped",
                           "the {nothing} holds it up", "[because] it needs {nothing}"},
                          {{"nothing", {"wind", "lift"}}}};
    source.nearly = {"[because] the {nothing} (stop|stops|is stop|gone away)",
                     "[because] (there|it) have no {nothing}", "the {nothing} it holds it up",
                     "(have|has) no {nothing}", "needs {nothing}"};
    auto question = compile_question(source);
    REQUIRE(question);
    return std::move(*question);
}

}  // namespace

TEST_CASE(
    "wording: what is one word away from a right answer is said back as that, and its error told") {
    check_rows(why_question(),
               {{"the wind stop", "R:VERB:TENSE", "The wind *stopped*."},
                {"because the wind stops", "R:VERB:TENSE", "Because the wind *stopped*."},
                {"the wind is stop", "R:VERB:FORM", "The wind *stopped*."},
                {"there have no wind", "R:VERB:FORM", "There *is* no wind."},
                {"the lift it holds it up", "U:PRON", "The lift holds it up."},
                {"needs wind", "M:PRON", "*It* needs wind."}});
}

TEST_CASE("wording: what goes another way is said back whole, with the words that fit") {
    check_rows(why_question(),
               {{"have no wind", "R:OTHER", "*There is no wind*."},
                {"because the wind gone away", "R:OTHER", "*Because there is no wind*."}});
    QuestionSource source{"harder",
                          "Which one is harder to turn?",
                          {"{planet} is <comparative:hard> [to turn] [than {other}]"},
                          {{"planet", {"Jupiter", "Mars"}}, {"other", {"Jupiter", "Mars"}}}};
    source.nearly = {"{planet} is hard [to turn]", "{planet} is harder to turning"};
    const auto harder = compile_question(source);
    REQUIRE(harder);
    // What was said and may be said is kept.
    check_rows(*harder,
               {{"Jupiter is hard to turn", "R:ADJ:FORM", "Jupiter is *harder* to turn."},
                {"Jupiter is hard", "R:ADJ:FORM", "Jupiter is *harder*."},
                {"Jupiter is harder to turning", "R:VERB:FORM", "Jupiter is harder to *turn*."}});
}
