#include "runtime/lesson/question_notes.h"

#include "dialogue/marking/question_review.h"
#include "dialogue/speech/sphinx/pronunciation.h"
#include "runtime/lesson/knowledge.h"
#include "runtime/lesson/questions.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <set>

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

std::string tell_unheard(const std::vector<std::string>& words) {
    return "nobody can hear " + listed(words) +
           "; write other words beside, as in \"bike|bicycle\".";
}

/// Of what a learner may ask: sentences that ask for something else first, words without pronunciation.
void add_knowledge_notes(const LessonDescription& lesson,
                         const std::function<bool(std::string_view)>& can_be_heard,
                         std::vector<std::string>& notes) {
    const dialogue::Catalogue no_words;
    const auto compiled = Knowledge::compile(lesson, no_words);
    if (!compiled || !*compiled) {
        return;
    }
    const Knowledge& knowledge = **compiled;
    const auto line_of = [&](const std::string& id) {
        const auto described = std::ranges::find(lesson.knowledge, id, &KnowledgeDescription::id);
        return "lesson.lua:" + std::to_string(described->line) + ": ";
    };
    std::set<std::string> told;
    for (const AskingSentence& sentence : knowledge.every_way()) {
        const auto asked = knowledge.find(sentence.said);
        if ((asked && asked->knowledge == sentence.knowledge) ||
            !told.insert(sentence.knowledge).second) {
            continue;
        }
        notes.push_back(
            line_of(sentence.knowledge) + "\"" + sentence.said + "\" asks for \"" +
            sentence.knowledge + "\", but " +
            (asked ? "\"" + asked->knowledge + "\" takes it first." : "nobody understands it."));
    }
    const auto unheard = dialogue::unheard_words(knowledge.question(), can_be_heard);
    if (!unheard.empty()) {
        notes.push_back(line_of(lesson.knowledge.front().id) +
                        "what a learner may ask: " + tell_unheard(unheard));
    }
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
    const auto can_be_heard = [&](std::string_view word) {
        return sounds.empty() || dialogue::pronounce(word, look_up).has_value();
    };
    for (const QuestionDescription& described : lesson.questions) {
        const dialogue::Question& question = questions->at(described.id);
        const std::string head = "lesson.lua:" + std::to_string(described.line) + ": question \"" +
                                 described.id + "\": ";
        for (const std::string& found : dialogue::review_question(question)) {
            notes.push_back(head + found + ".");
        }
        const auto unheard = dialogue::unheard_words(question, can_be_heard);
        if (!unheard.empty()) {
            notes.push_back(head + tell_unheard(unheard));
        }
        if (described.again.empty()) {
            notes.push_back(head + "it has no `again`, so after a wrong answer no hint is given.");
        }
    }
    add_knowledge_notes(lesson, can_be_heard, notes);
    return notes;
}

}  // namespace fulcrum::runtime
