// A noun has one determiner at most: in what is right, in what is said back, and in what counts as an error.
#include "dialogue/marking/mark.h"
#include "dialogue/template/sentences.h"
#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/wrong_sentences.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

Question moons_of_earth() {
    return compiled({"moons",
                     "How many moons does the Earth have?",
                     {"the Earth has {number} <plural:moon>"},
                     {{"number", {"no|none", "one|a|an", "two"}}}});
}

}  // namespace

TEST_CASE("determiners: of two side by side one is an error, and one is said back") {
    check_rows(moons_of_earth(),
               {{"the earth has a moon", "", "The Earth has a moon."},
                {"the earth has the a moon", "U:DET", "The Earth has *a* moon."},
                {"the earth has my a moon", "U:DET", "The Earth has *a* moon."},
                {"the earth has a a moon", "U:DET", "The Earth has *a* moon."},
                {"the the earth has a moon", "U:DET", "*The Earth* has a moon."},
                {"a the earth has the one moon", "U:DET U:DET", "*The Earth* has one moon."}});
    check_rows(
        heavier(),
        {{"an apple is heavier than the an egg", "U:DET", "An apple is heavier than *the egg*."},
         {"my the apple is heavier", "U:DET", "*The apple* is heavier."},
         {"this my apple is heavier", "U:DET", "*My apple* is heavier."},
         {"a the apple is more heavy", "U:DET R:ADJ:FORM", "The apple is *heavier*."}});
    // Where only one of them fits, that one stays.
    const Question stone = compiled({"stone",
                                     "Where must it go?",
                                     {"near (the|my|your) {goal}"},
                                     {{"goal", {"stone", "hand"}}}});
    check_rows(stone, {{"near your stone", "", "Near your stone."},
                       {"near your the stone", "U:DET", "Near *the stone*."},
                       {"near my a stone", "U:DET", "Near my *stone*."},
                       {"near stone", "M:DET", "Near *the stone*."},
                       {"near my stones", "R:NOUN:NUM", "Near my *stone*."}});
}

TEST_CASE("determiners: an adjective between a determiner and its noun lets none in") {
    const Question tail = compiled({"tail",
                                    "What does it need?",
                                    {"it needs a <comparative:long> {part}",
                                     "it needs a long {part}", "the {colour} {part} is good"},
                                    {{"part", {"tail", "wheel"}}, {"colour", {"red", "blue"}}}});
    const Question cloth = compiled({"cloth",
                                     "What does it need?",
                                     {"it needs a {weight} cloth"},
                                     {{"weight", {"light", "heavy"}}}});
    CHECK_FALSE(mark_answer(cloth, "it needs cloths").understood);
    check_rows(tail, {{"it needs a longer tail", "", "It needs a longer tail."},
                      {"the red tail is good", "", "The red tail is good."},
                      {"it needs a the longer tail", "U:DET", "It needs *a longer* tail."}});
    for (const char* wrong : {"it needs a longer the tail", "it needs a long a tail",
                              "the red my tail is good", "it needs a longer tails"}) {
        INFO(wrong);
        const Mark mark = mark_answer(tail, wrong);
        CHECK((!mark.understood || !mark.form_right()));
    }
}

TEST_CASE("determiners: behind an article it is slightly heavier, not a bit heavier") {
    const Question one =
        compiled({"one",
                  "Which one?",
                  {"it is the <comparative:heavy> one", "it is a <adjective:hard> one",
                   "{thing} is <comparative:heavy>"},
                  fruit()});
    check_rows(one, {{"it is the slightly heavier one", "", "It is the slightly heavier one."},
                     {"it is the a bit heavier one", "R:ADV", "It is *the slightly heavier* one."},
                     {"it is a a little hard one", "R:ADV", "It is *a slightly hard* one."},
                     {"the egg is a bit heavier", "", "The egg is a bit heavier."}});
}

TEST_CASE("determiners: they are settled wherever a template brings two together") {
    const TemplateSet set =
        compiled_templates({{"look at [the] [big] {thing}", "it is {number} {thing}",
                             "they told me that the {thing} is here"},
                            {{"thing", {"ball"}}, {"number", {"one|a|an"}}},
                            {}});
    const auto said_back = [&](const char* said) {
        const auto parse = match(set, said);
        return parse ? render(parse->pieces) + " " + std::to_string(parse->cost) : "?";
    };
    CHECK(said_back("look at the the ball") == "Look at the ball. 10");
    CHECK(said_back("look at the big ball") == "Look at the big ball. 0");
    CHECK(said_back("it is a the ball") == "It is a ball. 10");
    CHECK(said_back("they told me that the ball is here") ==
          "They told me that the ball is here. 0");
}

TEST_CASE("determiners: no way through a question's graphs has two side by side") {
    std::vector<Question> questions = all_questions();
    questions.push_back(moons_of_earth());
    for (const Question& question : questions) {
        for (const Graph& graph : question.templates->graphs) {
            CHECK(right_doubled_determiner(*question.templates, graph).empty());
        }
    }
}

TEST_CASE("determiners: one or two labelled errors are said back in a right sentence") {
    int n_tried = 0;
    std::vector<Question> questions = all_questions();
    questions.push_back(moons_of_earth());
    for (const Question& question : questions) {
        INFO(question.id);
        CHECK(wrong_recasts(question, n_tried) == "");
    }
    CHECK(n_tried > 2000);
}
