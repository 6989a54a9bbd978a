// The pictures beside answers that may be chosen: of what parts them.
#pragma once

#include "runtime/app/places.h"
#include "runtime/lesson/answer_choices.h"
#include "runtime/scene/description.h"
#include "runtime/scene/view.h"

#include <filesystem>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A model, and what it is made of.
struct ChoicePicture {
    std::string model;   ///< its name; empty: none
    std::string look{};  ///< as a ViewBody's

    [[nodiscard]] bool operator==(const ChoicePicture&) const = default;
};

/// Of a word that an answer says: the thing of the scene that is called so, else a model beside the lesson or one of the program's own
/// ("spaceship", "Jupiter").
[[nodiscard]] ChoicePicture find_word_picture(const std::string& word,
                                              const LessonDescription& lesson, const Places& places,
                                              const std::filesystem::path& lesson_folder);

/// Of answers that are offered together: each shows the first word that not all of them say and that has a picture. Empty ones where one has
/// none, or two have the same: a picture that does not part them says nothing.
[[nodiscard]] std::vector<ChoicePicture> find_choice_pictures(
    const std::vector<AnswerChoice>& choices, const LessonDescription& lesson, const Places& places,
    const std::filesystem::path& lesson_folder);

/// The pictures of the choices that are shown, found once for each question.
class ChoicePictures {
  public:
    /// True where the choices are others than the last time: then the `models` are to be loaded.
    [[nodiscard]] bool look(const std::vector<AnswerChoice>& choices,
                            const LessonDescription& lesson, const Places& places,
                            const std::filesystem::path& lesson_folder);
    /// Their names.
    [[nodiscard]] std::vector<std::string> models() const;
    void show(View& view) const;

  private:
    std::vector<ChoicePicture> pictures_;  // in the choices' order
    std::string said_;                     // by the choices
};

}  // namespace fulcrum::runtime
