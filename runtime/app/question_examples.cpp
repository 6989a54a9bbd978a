#include "runtime/app/question_examples.h"

#include "dialogue/marking/mark_answer.h"
#include "dialogue/marking/readings.h"
#include "runtime/lesson/knowledge.h"
#include "runtime/lesson/questions.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

/// What an example is said to be.
struct Kind {
    const std::vector<std::string> QuestionExamples::*examples;
    bool is_right;        ///< in meaning
    bool has_right_form;  ///< looked at where the meaning is right
    const char* text;
};

constexpr Kind kKinds[] = {{&QuestionExamples::right, true, true, "right"},
                           {&QuestionExamples::wrong, false, true, "wrong in meaning"},
                           {&QuestionExamples::form, true, false, "right with an error of form"}};

std::string errors_of(const dialogue::Mark& mark) {
    std::string text;
    for (const dialogue::FormError& error : mark.form_errors) {
        text +=
            (text.empty() ? "" : ", ") + std::string(error.errant()) + " (\"" + error.right + "\")";
    }
    return text;
}

/// The lesson's verdict on all that the answer may mean.
Expected<bool> verdict_on(LessonRun& run, const std::string& question, dialogue::Mark& mark) {
    if (!mark.other_number.empty()) {
        return false;
    }
    std::vector<bool> verdicts;
    for (const dialogue::Slots& reading : dialogue::readings_of(mark)) {
        const auto verdict = run.aside().ask_verdict({question, reading});
        if (!verdict) {
            return verdict;
        }
        verdicts.push_back(*verdict);
    }
    return dialogue::settle(mark, verdicts);
}

/// Why the example is not what it is said to be; empty when it is.
Expected<std::string> find_difference(LessonRun& run, const dialogue::Question& question,
                                      const std::string& said, const Kind& kind) {
    dialogue::Mark mark = dialogue::mark_answer(question, said);
    if (!mark.understood) {
        return "it is not understood";
    }
    const auto verdict = verdict_on(run, question.id, mark);
    if (!verdict) {
        return tl::unexpected(verdict.error());
    }
    const bool answers = *verdict && mark.claim != dialogue::Claim::excluded;
    if (answers != kind.is_right) {
        return answers    ? "its meaning is right"
               : *verdict ? "it is true, and no answer"
                          : "its meaning is wrong";
    }
    if (kind.is_right && mark.form_right() != kind.has_right_form) {
        return mark.form_right() ? "no error of form is found" : "its form has " + errors_of(mark);
    }
    return std::string();
}

/// The same of what is asked for; `knowledge` is what it should be, `kind` how.
std::string find_difference(const Knowledge& known, const std::string& knowledge,
                            const std::string& said, bool asks, bool has_right_form) {
    const auto asked = known.find(said);
    const bool asks_for_it = asked && asked->knowledge == knowledge;
    if (asks != asks_for_it) {
        return !asked ? "it is not understood" : "it asks for \"" + asked->knowledge + "\"";
    }
    if (asks && asked->mark.form_right() != has_right_form) {
        return has_right_form ? "its form has " + errors_of(asked->mark)
                              : "no error of form is found";
    }
    return {};
}

/// Its examples that come out otherwise.
void add_unmet(const Knowledge& known, const KnowledgeDescription& described,
               std::vector<std::string>& unmet) {
    struct AskedKind {
        const std::vector<std::string>& examples;
        bool asks;
        bool has_right_form;
        const char* text;
    };
    const AskedKind kinds[] = {
        {described.examples.right, true, true, "to ask for it"},
        {described.examples.form, true, false, "to ask for it with an error of form"},
        {described.examples.other, false, true, "not to ask for it"}};
    for (const AskedKind& kind : kinds) {
        for (const std::string& said : kind.examples) {
            const std::string difference =
                find_difference(known, described.id, said, kind.asks, kind.has_right_form);
            if (!difference.empty()) {
                std::string message = "what the lesson knows as \"";
                message.append(described.id).append("\": \"").append(said);
                message.append("\" is said ").append(kind.text).append(", but ").append(difference);
                unmet.push_back(
                    to_sentence({std::move(message), "lesson.lua:" + std::to_string(described.line),
                                 "mend the ways to ask or the example"}));
            }
        }
    }
}

/// All that a learner may ask, asked once each: an error is that of the lesson's own function.
Expected<void> ask_everything(LessonRun& run, const Knowledge& known,
                              const AnswerTaker& take_answer) {
    const auto& all = run.description().knowledge;
    for (const AskingSentence& sentence : known.every_way()) {
        const auto asked = known.find(sentence.said);
        if (!asked) {
            continue;
        }
        const auto told = run.aside().ask_knowledge({asked->knowledge, asked->mark.slots});
        if (!told) {
            Error error = told.error();
            error.message = "what the lesson knows as \"" + asked->knowledge + "\", asked \"" +
                            sentence.said + "\": " + error.message;
            return tl::unexpected(std::move(error));
        }
        if (take_answer) {
            take_answer(*std::ranges::find(all, asked->knowledge, &KnowledgeDescription::id),
                        *told);
        }
    }
    return {};
}

}  // namespace

Expected<std::vector<std::string>> find_unmet_examples(LessonRun& run,
                                                       const AnswerTaker& take_answer) {
    std::vector<std::string> unmet;
    const auto questions = compile_questions(run.description());
    if (!questions) {
        return tl::unexpected(questions.error());
    }
    for (const QuestionDescription& described : run.description().questions) {
        for (const Kind& kind : kKinds) {
            for (const std::string& said : described.examples.*kind.examples) {
                const auto difference =
                    find_difference(run, questions->at(described.id), said, kind);
                if (!difference) {
                    Error error = difference.error();
                    error.message = "question \"" + described.id + "\", tried with \"" + said +
                                    "\": " + error.message;
                    return tl::unexpected(std::move(error));
                }
                if (!difference->empty()) {
                    unmet.push_back(
                        to_sentence({"question \"" + described.id + "\": \"" + said +
                                         "\" is said to be " + kind.text + ", but " + *difference,
                                     "lesson.lua:" + std::to_string(described.line),
                                     "mend the question's sentences or the example"}));
                }
            }
        }
    }
    if (const auto& known = run.session().knowledge()) {
        for (const KnowledgeDescription& described : run.description().knowledge) {
            add_unmet(*known, described, unmet);
        }
        if (const auto asked = ask_everything(run, *known, take_answer); !asked) {
            return tl::unexpected(asked.error());
        }
    }
    return unmet;
}

}  // namespace fulcrum::runtime
