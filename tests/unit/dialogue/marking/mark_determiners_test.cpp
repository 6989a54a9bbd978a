// A noun has one determiner at most, in what is right and in what is said back, whatever the question.
#include "dialogue/marking/mark.h"
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
