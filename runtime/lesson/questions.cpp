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

dialogue::NamedLists lists_of(const QuestionDescription& question,
                              const std::vector<std::string>& nouns) {
    dialogue::NamedLists lists = question.lists;
    for (const std::string name : kThingsOfTheScene) {
        const bool given = std::any_of(lists.begin(), lists.end(),
                                       [&](const auto& list) { return list.first == name; });
        if (!given && !nouns.empty()) {
            lists.emplace_back(name, nouns);
        }
    }
    return lists;
}

}  // namespace

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
        source.lists = lists_of(question, nouns);
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
            const std::string column =
                result.error().column > 0
                    ? " (column " + std::to_string(result.error().column) + ")"
                    : "";
            return fail(result.error().message + column, where,
                        "mend the question \"" + question.id + "\"");
        }
        if (!compiled.emplace(question.id, std::move(*result)).second) {
            return fail("two questions are called \"" + question.id + "\"", where,
                        "give each a name of its own");
        }
    }
    return compiled;
}

}  // namespace fulcrum::runtime
