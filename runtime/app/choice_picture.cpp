#include "runtime/app/choice_picture.h"

#include <algorithm>
#include <cctype>

namespace fulcrum::runtime {
namespace {

/// "the Sun" is shown as the model "sun".
std::string model_called(std::string word) {
    std::ranges::transform(word, word.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return word.starts_with("the ") ? word.substr(4) : word;
}

// A ball or a box is told from another by what it is made of.
ChoicePicture picture_of(const BodyDescription& body, const LessonDescription& lesson) {
    ChoicePicture picture{body.model};
    if (body.material != kNoMaterial) {
        picture.look = lesson.materials[static_cast<std::size_t>(body.material)].look;
    }
    return picture;
}

bool is_common(const std::pair<std::string, std::string>& word,
               const std::vector<AnswerChoice>& choices) {
    return std::ranges::all_of(choices, [&](const AnswerChoice& choice) {
        return std::ranges::find(choice.meaning, word) != choice.meaning.end();
    });
}

}  // namespace

ChoicePicture find_word_picture(const std::string& word, const LessonDescription& lesson,
                                const Places& places, const std::filesystem::path& lesson_folder) {
    const auto body = std::ranges::find(lesson.bodies, word, &BodyDescription::noun);
    if (body != lesson.bodies.end() && !word.empty() && body->boxes.empty()) {
        return picture_of(*body, lesson);
    }
    const std::string model = model_called(word);
    return {find_model(places, lesson_folder, model).empty() ? std::string() : model};
}

std::vector<ChoicePicture> find_choice_pictures(const std::vector<AnswerChoice>& choices,
                                                const LessonDescription& lesson,
                                                const Places& places,
                                                const std::filesystem::path& lesson_folder) {
    std::vector<ChoicePicture> pictures;
    for (const AnswerChoice& choice : choices) {
        ChoicePicture& picture = pictures.emplace_back();
        for (const auto& word : choice.meaning) {
            if (picture.model.empty() && !is_common(word, choices)) {
                picture = find_word_picture(word.second, lesson, places, lesson_folder);
            }
        }
    }
    const bool is_one_alike = std::ranges::any_of(pictures, [&](const ChoicePicture& picture) {
        return std::ranges::count(pictures, picture) > 1;
    });
    const bool lacks_one = std::ranges::any_of(
        pictures, [](const ChoicePicture& picture) { return picture.model.empty(); });
    return is_one_alike || lacks_one ? std::vector<ChoicePicture>(choices.size()) : pictures;
}

bool ChoicePictures::look(const std::vector<AnswerChoice>& choices, const LessonDescription& lesson,
                          const Places& places, const std::filesystem::path& lesson_folder) {
    std::string said;
    for (const AnswerChoice& choice : choices) {
        said += choice.said + '\n';
    }
    if (said == said_) {
        return false;
    }
    said_ = std::move(said);
    pictures_ = find_choice_pictures(choices, lesson, places, lesson_folder);
    return true;
}

std::vector<std::string> ChoicePictures::models() const {
    std::vector<std::string> names;
    for (const ChoicePicture& picture : pictures_) {
        if (!picture.model.empty()) {
            names.push_back(picture.model);
        }
    }
    return names;
}

void ChoicePictures::show(View& view) const {
    for (std::size_t i = 0; i < std::min(pictures_.size(), view.choices.size()); ++i) {
        view.choices[i].picture = pictures_[i].model;
        view.choices[i].look = pictures_[i].look;
    }
}

}  // namespace fulcrum::runtime
