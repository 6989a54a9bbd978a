// The picture beside an answer that may be chosen.
#pragma once

#include "runtime/app/places.h"
#include "runtime/lesson/answer_choices.h"
#include "runtime/scene/description.h"
#include "runtime/scene/view.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// The name of a model: that of the first thing of the scene that the answer names, else of the first word of its meaning that is
/// called as a model beside the lesson or one of the program's own ("spaceship", "Jupiter"); empty for none.
[[nodiscard]] std::string find_choice_picture(const AnswerChoice& choice,
                                              const LessonDescription& lesson, const Places& places,
                                              const std::filesystem::path& lesson_folder);

/// The pictures of the choices that are shown, found once for each question.
class ChoicePictures {
  public:
    /// True where the choices are others than the last time: then the models of `names` are to be loaded.
    [[nodiscard]] bool look(const std::vector<AnswerChoice>& choices,
                            const LessonDescription& lesson, const Places& places,
                            const std::filesystem::path& lesson_folder);
    /// Of the choices, in their order; empty for none.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    void show(View& view) const;

  private:
    std::vector<std::string> names_;
    std::string said_;  // by the choices
};

}  // namespace fulcrum::runtime
