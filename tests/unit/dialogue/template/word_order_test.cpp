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
