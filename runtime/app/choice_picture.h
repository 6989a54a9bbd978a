// The picture beside an answer that may be chosen.
#pragma once

#include "runtime/app/places.h"
#include "runtime/lesson/answer_choices.h"
#include "runtime/scene/description.h"

#include <filesystem>
#include <string>

namespace fulcrum::runtime {

/// The name of a model: that of the first thing of the scene that the answer names, else of the first word of its meaning that is
/// called as a model beside the lesson or one of the program's own ("spaceship", "Jupiter"); empty for none.
[[nodiscard]] std::string find_choice_picture(const AnswerChoice& choice,
                                              const LessonDescription& lesson, const Places& places,
                                              const std::filesystem::path& lesson_folder);

}  // namespace fulcrum::runtime
