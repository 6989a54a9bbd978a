#include "dialogue/marking/question.h"

namespace fulcrum::dialogue {

Expected<Question> compile_question(const QuestionSource& source) {
    const std::string where = "question \"" + source.id + "\"";
    if (source.id.empty()) {
        return fail("a question has no id; give it one");
    }
    if (source.prompt.empty()) {
        return fail(where + " has no prompt; write what is asked");
    }
    auto set = compile_templates({source.answers, source.lists, source.rules, source.nearly,
                                  source.subjects, source.nearly_subjects});
    if (!set) {
        return fail(where + ", " + set.error().message, set.error().column);
    }
    return Question{source.id, source.prompt, source.again,
                    std::make_shared<const TemplateSet>(std::move(*set)), source.ladder};
}

}  // namespace fulcrum::dialogue
