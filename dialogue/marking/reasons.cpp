#include "dialogue/marking/reasons.h"

#include "dialogue/marking/said_parts.h"
#include "dialogue/template/hearing.h"
#include "dialogue/template/tokens.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {
namespace {

/// The clause of a reason that was let pass, behind "because"; with what was answered in place of its pronoun: "it is lighter", "the apple is
/// lighter", "apple is lighter". None of "so that it flies".
std::vector<std::string> clauses_of_reason(const Mark& whole) {
    const std::vector<Token> words = tokenise(whole.unread);
    if (words.size() < 2 || !begins_reason(words.front().text)) {
        return {};
    }
    const std::string clause = whole.unread.substr(words[1].begin);
    std::vector<std::string> clauses = {clause};
    const auto pronoun = find_pronoun(clause);
    const std::string value = whole.slots.size() == 1 ? whole.slots.front().second : "";
    // Not where it only follows from what was said: of "the egg is not heavier" that is the apple.
    const std::string answer =
        words_between_blanks(std::string_view(whole.said).substr(0, whole.unread_begin));
    const bool is_said = answer.find(words_between_blanks(value)) != std::string::npos;
    if (pronoun && !value.empty() && is_said) {
        for (const std::string& noun : {"the " + value, value}) {
            clauses.push_back(clause);
            clauses.back().replace(pronoun->begin, pronoun->end - pronoun->begin, noun);
        }
    }
    return clauses;
}

}  // namespace

std::optional<Mark> mark_with_reason(const Question& question, const Mark& whole) {
    if (whole.claim != Claim::same) {
        return std::nullopt;
    }
    for (const std::string& clause : clauses_of_reason(whole)) {
        auto parts = read_parts(question, clause, {{0, clause.size()}});
        if (!parts || parts->empty()) {
            continue;
        }
        parts->insert(parts->begin(), {whole, false});
        auto joined = joined_mark(std::move(*parts), whole);
        if (!joined || joined->claim != Claim::every) {
            return std::nullopt;
        }
        Mark mark = whole;
        mark.claim = Claim::reasoned;
        mark.readings = std::move(joined->readings);
        mark.denied = std::move(joined->denied);
        return mark;
    }
    return std::nullopt;
}

}  // namespace fulcrum::dialogue
