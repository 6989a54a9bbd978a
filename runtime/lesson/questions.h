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

}  // namespace fulcrum::runtime
