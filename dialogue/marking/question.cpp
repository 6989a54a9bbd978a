#include "dialogue/marking/question.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

bool teaches(const TemplateSet& set, Degree degree) {
    return std::any_of(set.graphs.begin(), set.graphs.end(), [&](const Graph& graph) {
        return std::any_of(graph.elements.begin(), graph.elements.end(),
                           [&](const Element& element) {
                               return element.role == Role::adjective && element.degree == degree;
                           });
    });
}

}  // namespace

Expected<Question> compile_question(const QuestionSource& source) {
    const std::string where = "question \"" + source.id + "\"";
    if (source.id.empty()) {
        return fail("a question has no id; give it one");
    }
    if (source.prompt.empty()) {
        return fail(where + " has no prompt; write what is asked");
    }
    auto set = compile_templates({source.answers, source.lists, source.rules});
    if (!set) {
        return fail(where + ", " + set.error().message, set.error().column);
    }
    Question question{source.id, source.prompt, source.hint, nullptr, false};
    question.compares_two =
        teaches(*set, Degree::comparative) && !teaches(*set, Degree::superlative);
    question.templates = std::make_shared<const TemplateSet>(std::move(*set));
    return question;
}

}  // namespace fulcrum::dialogue
