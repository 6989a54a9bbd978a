#include "runtime/lesson/questions.h"

#include <algorithm>
#include <array>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kLongestSlot_bytes = 48;  // as a message to the lesson may hold

std::vector<std::string> nouns_of(const LessonDescription& lesson) {
    std::vector<std::string> nouns;
    for (const BodyDescription& body : lesson.bodies) {
        if (!body.noun.empty() && std::find(nouns.begin(), nouns.end(), body.noun) == nouns.end()) {
            nouns.push_back(body.noun);
        }
    }
    return nouns;
}

/// The lists that the teacher need not give: they mean the things of the scene.
constexpr std::array<const char*, 2> kThingsOfTheScene = {"thing", "other"};

void add_nouns(const std::vector<std::string>& nouns, dialogue::NamedLists& lists) {
    for (const std::string name : kThingsOfTheScene) {
        const bool given = std::any_of(lists.begin(), lists.end(),
                                       [&](const auto& list) { return list.first == name; });
        if (!given && !nouns.empty()) {
            lists.emplace_back(name, nouns);
        }
    }
}

bool stands_in(const std::vector<std::string>& templates, const std::string& part) {
    return std::ranges::any_of(
        templates, [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

/// A list or rule of the teacher's own that no sentence has, as it would stand there: it was forgotten.
std::string unused_part(const QuestionDescription& question) {
    std::vector<std::string> templates = question.answers;
    for (const auto& [name, rule] : question.rules) {
        templates.push_back(rule);
    }
    for (const auto& [name, words] : question.lists) {
        if (!stands_in(templates, '{' + name + '}') && !stands_in(templates, '{' + name + ':')) {
            return '{' + name + '}';
        }
    }
    templates.insert(templates.end(), question.nearly.begin(), question.nearly.end());
    for (const auto& [name, rule] : question.rules) {
        if (!stands_in(templates, '<' + name + '>')) {
            return '<' + name + '>';
        }
    }
    return {};
}

}  // namespace

void add_things_of_the_scene(const LessonDescription& lesson, dialogue::NamedLists& lists) {
    add_nouns(nouns_of(lesson), lists);
}

std::string with_letter(const dialogue::Error& error) {
    std::string message = error.message;
    if (const std::size_t colon = message.find(": ");
        error.column > 0 && colon != std::string::npos) {
        message.insert(colon, ", letter " + std::to_string(error.column));
    }
    return message;
}

void choose_feedback(LessonDescription& lesson, const dialogue::FeedbackLadder& ladder) {
    if (ladder.empty()) {
        return;
    }
    lesson.feedback = ladder;
    for (QuestionDescription& question : lesson.questions) {
        question.feedback.clear();
    }
}

Expected<std::map<std::string, dialogue::Question>> compile_questions(
    const LessonDescription& lesson) {
    std::map<std::string, dialogue::Question> compiled;
    const std::vector<std::string> nouns = nouns_of(lesson);
    for (const QuestionDescription& question : lesson.questions) {
        dialogue::QuestionSource source;
        source.id = question.id;
        source.prompt = question.prompt;
        source.answers = question.answers;
        source.nearly = question.nearly;
        source.again = question.again;
        source.lists = question.lists;
        source.rules = question.rules;
        source.ladder = question.feedback.empty() ? lesson.feedback : question.feedback;
        add_nouns(nouns, source.lists);
        for (const auto& [name, words] : source.lists) {
            if (name.size() > kLongestSlot_bytes) {
                return fail("the name {" + name + "} is too long",
                            "lesson.lua:" + std::to_string(question.line),
                            "use at most 48 letters");
            }
        }
        auto result = dialogue::compile_question(source);
        const std::string where = "lesson.lua:" + std::to_string(question.line);
        if (!result) {
            return fail(with_letter(result.error()), where, {});
        }
        if (const std::string unused = unused_part(question); !unused.empty()) {
            return fail("question \"" + question.id + "\": no sentence has " + unused, where,
                        "write " + unused + " where its words belong, or take it out");
        }
        if (!compiled.emplace(question.id, std::move(*result)).second) {
            return fail("two questions are called \"" + question.id + "\"", where,
                        "give each a name of its own");
        }
    }
    return compiled;
}

}  // namespace fulcrum::runtime
