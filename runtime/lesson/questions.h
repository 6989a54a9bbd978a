// A lesson's questions, compiled for the conversation.
#pragma once

#include "dialogue/marking/question.h"
#include "haptics/base/error.h"
#include "runtime/scene/description.h"

#include <map>
#include <string>

namespace fulcrum::runtime {

/// Compiles every question; {thing} and {other}, where no list explains them, mean the nouns of the lesson's bodies. An error names the
/// line of the question and the column of the template.
[[nodiscard]] Expected<std::map<std::string, dialogue::Question>> compile_questions(
    const LessonDescription& lesson);

/// Adds the lists that need not be given: {thing} and {other}, the nouns of the scene's bodies.
void add_things_of_the_scene(const LessonDescription& lesson, dialogue::NamedLists& lists);

/// What is wrong with a template, with the letter where: "question "heavier", answer 1, letter 9: there is no list …".
[[nodiscard]] std::string with_letter(const dialogue::Error& error);

/// Whoever stands beside the learner knows best how errors are to be told: that ladder holds for all questions. An empty one
/// changes nothing.
void choose_feedback(LessonDescription& lesson, const dialogue::FeedbackLadder& ladder);

}  // namespace fulcrum::runtime
