// A question with the answers it understands, ready to be asked.
//
//   auto set = compile_question({"heaviest", "Which one is the heaviest?",
//                                {"[a|an|the] {thing} is the <superlative:heavy> [one|object]"},
//                                {{"thing", {"watermelon", "apple", "banana", "egg"}}}});
//
// Thread: immutable, may be copied and shared.  Cost: compiled once, at load.
#pragma once

#include "dialogue/marking/feedback_ladder.h"
#include "dialogue/result.h"
#include "dialogue/template/compile.h"

#include <memory>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// What an author writes for one question.
struct QuestionSource {
    std::string id;                      ///< unique in its lesson
    std::string prompt;                  ///< what is asked; sentences part the lines
    std::vector<std::string> answers;    ///< templates
    NamedLists lists{};                  ///< {name} -> its words
    NamedTexts rules{};                  ///< <name> -> a template
    std::vector<std::string> nearly{};   ///< what learners say for them that is no good English
    std::string again{};                 ///< said after "Not yet."; empty: the catalogue's own line
    FeedbackLadder ladder{};             ///< of feedback on form; empty: the conversation's own
    std::vector<int> subjects{};         ///< by answer, see TemplateSource
    std::vector<int> nearly_subjects{};  ///< by `nearly`
};

/// A compiled question.
struct Question {
    std::string id;
    std::string prompt;
    std::string again;
    std::shared_ptr<const TemplateSet> templates;
    FeedbackLadder ladder{};  ///< empty: the conversation's own
};

/// Compiles a question; an error names the question, the answer or rule, and its column.
[[nodiscard]] Expected<Question> compile_question(const QuestionSource& source);

/// The two of the list between which the question asks, "the apple or the egg"; none where it asks for other things as well.
[[nodiscard]] std::vector<std::string> asked_between(const Question& question,
                                                     const WordList& list);

}  // namespace fulcrum::dialogue
