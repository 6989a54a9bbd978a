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

}  // namespace

std::string find_choice_picture(const AnswerChoice& choice, const LessonDescription& lesson,
                                const Places& places, const std::filesystem::path& lesson_folder) {
    const std::vector<BodyDescription>& bodies = lesson.bodies;
    for (const auto& [slot, word] : choice.meaning) {
        const auto body = std::ranges::find(bodies, word, &BodyDescription::noun);
        if (body != bodies.end() && !word.empty() && body->boxes.empty()) {
            return body->model;
        }
    }
    for (const auto& [slot, word] : choice.meaning) {
        const std::string model = model_called(word);
        if (!find_model(places, lesson_folder, model).empty()) {
            return model;
        }
    }
    return {};
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
    names_.clear();
    for (const AnswerChoice& choice : choices) {
        names_.push_back(find_choice_picture(choice, lesson, places, lesson_folder));
    }
    return true;
}

void ChoicePictures::show(View& view) const {
    for (std::size_t i = 0; i < std::min(names_.size(), view.choices.size()); ++i) {
        view.choices[i].picture = names_[i];
    }
}

}  // namespace fulcrum::runtime
