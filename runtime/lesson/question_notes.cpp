#include "runtime/lesson/question_notes.h"

#include "dialogue/marking/question_review.h"
#include "dialogue/speech/sphinx/pronunciation.h"
#include "runtime/lesson/questions.h"

#include <fstream>
#include <map>
#include <optional>

namespace fulcrum::runtime {
namespace {

/// The dictionary of sounds: word -> sounds.
std::map<std::string, std::string, std::less<>> read_sounds(const std::string& path) {
    std::map<std::string, std::string, std::less<>> sounds;
    std::ifstream file(path);
    std::string line;
    while (std::getline(file, line)) {
        if (const std::size_t space = line.find(' '); space != std::string::npos) {
            sounds.emplace(line.substr(0, space), line.substr(space + 1));
        }
    }
    return sounds;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "\"" : ", \"") + word + "\"";
    }
    return text;
}

}  // namespace

std::vector<std::string> question_notes(const LessonDescription& lesson,
                                        const std::string& heard_words) {
    std::vector<std::string> notes;
    const auto questions = compile_questions(lesson);
    if (!questions) {
        return notes;
    }
    const auto sounds = read_sounds(heard_words);
    const dialogue::LookUp look_up = [&](std::string_view word) -> std::optional<std::string> {
        const auto found = sounds.find(word);
        return found == sounds.end() ? std::nullopt : std::optional<std::string>(found->second);
    };
    for (const QuestionDescription& described : lesson.questions) {
        const dialogue::Question& question = questions->at(described.id);
        const std::string head = "lesson.lua:" + std::to_string(described.line) + ": question \"" +
                                 described.id + "\": ";
        for (const std::string& found : dialogue::review_question(question)) {
            notes.push_back(head + found + ".");
        }
        const auto unheard = dialogue::unheard_words(question, [&](std::string_view word) {
            return sounds.empty() || dialogue::pronounce(word, look_up).has_value();
        });
        if (!unheard.empty()) {
            notes.push_back(head + "nobody can hear " + listed(unheard) +
                            "; write other words beside, as in \"bike|bicycle\".");
        }
        if (described.again.empty()) {
            notes.push_back(head + "it has no `again`, so after a wrong answer no hint is given.");
        }
    }
    return notes;
}

}  // namespace fulcrum::runtime
