// What holds for the English of every question that a lesson or the bank asks.
#include "dialogue/marking/question_review.h"
#include "tests/lessons/lesson_questions.h"
#include "tests/unit/dialogue/wrong_sentences.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::dialogue;
using test::questions_of;

namespace {

constexpr const char* kLessons[] = {"gravity", "textures", "solar-system", "lever",
                                    "kite",    "stacks",   "maze-park"};

}  // namespace

TEST_CASE("lessons' English: no right sentence of a question has two determiners side by side") {
    for (const char* lesson : kLessons) {
        for (const auto& [id, question] : questions_of(lesson)) {
            INFO(lesson << ", " << id);
            for (const Graph& graph : question.templates->graphs) {
                // What is nearly an answer is never right.
                CHECK(
                    (graph.nearly || right_doubled_determiner(*question.templates, graph).empty()));
            }
            for (const SaidBack& back : said_back(question)) {
                CHECK(doubled_determiner(back.sentence).empty());
            }
        }
    }
}

TEST_CASE("lessons' English: one or two labelled errors are said back in a right sentence") {
    int n_tried = 0;
    for (const char* lesson : kLessons) {
        for (const auto& [id, question] : questions_of(lesson)) {
            INFO(lesson << ", " << id);
            CHECK(wrong_recasts(question, n_tried) == "");
        }
    }
    CHECK(n_tried > 20'000);
}
