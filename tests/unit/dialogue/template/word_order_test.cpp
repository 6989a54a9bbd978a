#include "dialogue/template/word_order.h"

#include "dialogue/marking/mark.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/wrong_sentences.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

namespace {

bool has_order(const Mark& mark) {
    return std::any_of(mark.form_errors.begin(), mark.form_errors.end(),
                       [](const FormError& error) { return error.code == ErrorCode::word_order; });
}

std::size_t arcs_of(const Question& question) {
    return question.templates->graphs.front().arcs.size();
}

}  // namespace

TEST_CASE(
    "word order: the verb at the end is understood, told as order, and said back in its place") {
    const struct {
        Question question;
        const char *said, *codes, *recast;
    } rows[] = {
        {heaviest(), "a watermelon the heaviest is", "R:WO", "A watermelon *is* the heaviest."},
        {heaviest(), "watermelon heaviest is", "M:DET R:WO M:DET",
         "A watermelon is *the heaviest*."},
        {heavier(), "apples heavier than eggs are", "R:WO", "Apples *are* heavier than eggs."},
        {feels_how(), "metal hard and smooth is", "R:WO", "Metal *is* hard and smooth."},
        {feels_how(), "metal hard feels", "R:WO", "Metal *feels* hard."},
        {moons(), "Mars two moons has", "R:WO", "Mars *has* 2 moons."},
        {moons(), "Mars two moons have", "R:WO", "Mars *has* 2 moons."},
        {weighs(), "an apple more than an egg weighs", "R:WO",
         "An apple *weighs* more than an egg."},
    };
    for (const auto& row : rows) {
        INFO(row.said);
        const Mark mark = mark_answer(row.question, row.said);
        std::string codes;
        for (const FormError& error : mark.form_errors) {
            codes += (codes.empty() ? "" : " ") + std::string(error.errant());
        }
        CHECK(mark.understood);
        CHECK(codes == row.codes);
        CHECK(mark.emphasised == row.recast);
    }
    CHECK(mark_answer(heavier(), "an apple heavier than an egg is").slot("other") == "egg");
}

TEST_CASE("word order: an error of it tells what the verb belongs before") {
    CHECK(mark_answer(heaviest(), "a watermelon the heaviest is").form_errors.at(0).phrase ==
          "is the heaviest");
    CHECK(mark_answer(heavier(), "an apple heavier is than an egg").form_errors.at(0).phrase ==
          "is heavier");
    CHECK(mark_answer(made_of_what(), "a key is of metal made").form_errors.at(0).phrase ==
          "is made of");
}

TEST_CASE("word order: a verb behind what is compared, and made behind the material") {
    const struct {
        Question question;
        const char *said, *codes, *recast;
    } rows[] = {
        {heavier(), "an apple heavier is than an egg", "R:WO",
         "An apple *is* heavier than an egg."},
        {heavier(), "apples heavier are than eggs", "R:WO", "Apples *are* heavier than eggs."},
        {compares_feel(), "metal harder is than wood", "R:WO", "Metal *is* harder than wood."},
        {spaceship_of_what(), "the spaceship is of metal made", "R:WO",
         "The spaceship is *made* of metal."},
        {spaceship_of_what(), "the spaceship of metal is made", "R:WO",
         "The spaceship *is* made of metal."},
        {spaceship_of_what(), "the spaceship is metal made", "R:WO",
         "The spaceship is *made of* metal."},
        {spaceship_of_what(), "the spaceship is metal", "", "The spaceship is metal."},
        {scissors_of_what(), "the scissors of metal made are", "?", ""},
        {scissors_of_what(), "the scissors are of metal made", "R:WO",
         "The scissors are *made* of metal."},
        // Said in both places it is one too many, in the second.
        {heavier(), "an apple is heavier is than an egg", "R:WO",
         "An apple is heavier than an egg."},
    };
    for (const auto& row : rows) {
        INFO(row.said);
        const Mark mark = mark_answer(row.question, row.said);
        std::string codes = mark.understood ? "" : "?";
        for (const FormError& error : mark.form_errors) {
            codes += (codes.empty() ? "" : " ") + std::string(error.errant());
        }
        CHECK(codes == row.codes);
        CHECK(mark.emphasised == row.recast);
    }
}

TEST_CASE("word order: another verb than the sentence's own is not taken for it") {
    CHECK_FALSE(mark_answer(feels_how(), "metal hard is feels").understood);
    CHECK_FALSE(mark_answer(heaviest(), "a watermelon the heaviest has").understood);
    CHECK_FALSE(mark_answer(heaviest(), "the heaviest is").understood);
}

TEST_CASE("word order: no sentence with other errors is told as one out of order") {
    for (const Question& question : all_questions()) {
        const TemplateSet& set = *question.templates;
        for (const Graph& graph : set.graphs) {
            if (graph.nearly) {
                continue;  // out of order, whatever else is wrong
            }
            each_wrong_sentence(
                set, graph,
                [&](const std::string& said) {
                    INFO(question.id << ": " << said);
                    CHECK_FALSE(has_order(mark_answer(question, said)));
                },
                ErrorCode::word_order);
        }
    }
}

TEST_CASE("word order: the graph grows by less than itself for each verb, and a full one stays") {
    const Question one = compiled({"one", "?", {"an egg is the <superlative:heavy>"}, {}});
    const Question none = compiled({"none", "?", {"an egg the <superlative:heavy>"}, {}});
    CHECK(arcs_of(one) < 3 * arcs_of(none));
    TemplateSet set;
    ArcWriter writer(set, 8);
    const int start = writer.add_node();
    const int verb = writer.add_node();
    const int behind = writer.add_node();
    const int end = writer.add_node();
    const int word = writer.add_element({Role::word});
    Element is{Role::verb};
    is.verb = {"is", "are", true};
    writer.add_arc(start, verb, word, {"egg", "egg", ErrorCode::none, 0, true});
    writer.add_arc(verb, behind, writer.add_element(std::move(is)),
                   {"is", "is", ErrorCode::none, 0, true});
    writer.add_arc(behind, end, word, {"here", "here", ErrorCode::none, 0, true});
    add_verb_last(writer, start, end);
    CHECK(writer.arcs().size() == 3);
}
