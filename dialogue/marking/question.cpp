#include "dialogue/marking/question.h"

#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace fulcrum::dialogue {

Expected<Question> compile_question(const QuestionSource& source) {
    const std::string where = "question \"" + source.id + "\"";
    if (source.id.empty()) {
        return fail("a question has no id; give it one");
    }
    if (source.prompt.empty()) {
        return fail(where + " has no prompt; write what is asked");
    }
    auto set = compile_templates({source.answers, source.lists, source.rules, source.nearly,
                                  source.subjects, source.nearly_subjects});
    if (!set) {
        return fail(where + ", " + set.error().message, set.error().column);
    }
    return Question{source.id, source.prompt, source.again,
                    std::make_shared<const TemplateSet>(std::move(*set)), source.ladder};
}

namespace {

/// "The top or at the bottom": nothing but little words stands between the two.
bool joined_by_or(const std::string& prompt, const std::string& one, const std::string& other) {
    constexpr std::array<std::string_view, 9> kLittle = {"a",  "an", "the",  "at",  "in",
                                                         "on", "to", "near", "from"};
    const std::string first = words_between_blanks(one) + "or ";
    const std::size_t at = prompt.find(first);
    if (at == std::string::npos) {
        return false;
    }
    std::string_view rest = std::string_view(prompt).substr(at + first.size());
    const std::string wanted = words_between_blanks(other).substr(1);
    while (!rest.starts_with(wanted)) {
        const std::string_view word = rest.substr(0, rest.find(' '));
        if (std::ranges::find(kLittle, word) == kLittle.end()) {
            return false;
        }
        rest.remove_prefix(word.size() + 1);
    }
    return true;
}

}  // namespace

std::vector<std::string> asked_between(const Question& question, const WordList& list) {
    const std::string prompt = words_between_blanks(question.prompt);
    std::vector<std::string> named;
    for (const ListItem& item : list.items) {
        if (prompt.find(words_between_blanks(item.value)) != std::string::npos) {
            named.push_back(item.value);
        }
    }
    if (named.size() != 2) {
        return {};
    }
    const bool between =
        joined_by_or(prompt, named[0], named[1]) || joined_by_or(prompt, named[1], named[0]);
    return between ? named : std::vector<std::string>{};
}

}  // namespace fulcrum::dialogue
