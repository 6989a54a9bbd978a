#include "dialogue/marking/mark_answer.h"

#include "dialogue/english/number.h"
#include "dialogue/marking/mark_sentence.h"
#include "dialogue/marking/reasons.h"
#include "dialogue/marking/said_parts.h"
#include "dialogue/marking/said_spans.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kMostSentences_said = 5;  // of one answer

/// The first sentence names another thing than all of it read as one: "The egg. It is not as heavy as the apple."
bool contradicts(const std::vector<SaidPart>& parts, const Mark& whole) {
    const bool names =
        !parts.empty() && !parts.front().denied && parts.front().mark.claim == Claim::same;
    return names && std::ranges::any_of(parts.front().mark.slots, [&](const auto& slot) {
               const std::string_view said = whole.slot(slot.first);
               return !said.empty() && said != slot.second;
           });
}

/// A word is missing between two clauses: "the egg is not heavier, *than* the apple is".
bool misses_at_comma(const Mark& mark) {
    return std::ranges::any_of(mark.form_errors, [&](const FormError& error) {
        const std::string before = mark.said.substr(0, error.begin);
        const std::size_t last = before.find_last_not_of(' ');
        return error.code == ErrorCode::missing_preposition && last != std::string::npos &&
               before[last] == ',';
    });
}

/// "There are four: lift, drag, weight and tension": as many names as were counted, none of which is an answer itself.
std::optional<Mark> mark_before_list(const Question& question, const Mark& whole) {
    const std::optional<SaidList> list = list_behind(whole.said);
    if (!list) {
        return std::nullopt;
    }
    Mark mark = mark_sentence(question, whole.said.substr(0, list->begin), whole.confidence);
    const std::vector<std::string> counted = number_words(static_cast<long>(list->items.size()));
    const bool as_many = mark.understood && mark.claim == Claim::same &&
                         std::ranges::any_of(mark.slots, [&](const auto& slot) {
                             return words_of(slot.second) == counted;
                         });
    const bool is_answer = std::ranges::any_of(list->items, [&](const SaidSpan& item) {
        return mark_sentence(question, whole.said.substr(item.begin, item.end - item.begin))
            .understood;
    });
    if (!as_many || is_answer) {
        return std::nullopt;
    }
    mark.said = whole.said;
    mark.short_answer = true;  // nobody looked at the names
    return mark;
}

/// The same answer as `whole`, sentence by sentence, where that is understood better than `whole`; else none.
std::optional<Mark> mark_sentences(const Question& question, const Mark& whole) {
    for (const bool clauses : {false, true}) {
        const bool wanted =
            !clauses || !whole.understood || !whole.other_number.empty() || misses_at_comma(whole);
        const std::vector<SaidSpan> spans =
            wanted ? said_sentences(whole.said, clauses) : std::vector<SaidSpan>{};
        if (spans.size() < 2 || spans.size() > kMostSentences_said) {
            continue;
        }
        auto parts = read_parts(question, whole.said, spans);
        if (!parts) {
            continue;
        }
        const bool differs = contradicts(*parts, whole);
        auto mark = joined_mark(std::move(*parts), whole);
        const bool is_better =
            mark && (!whole.understood || !whole.other_number.empty() || !whole.unread.empty() ||
                     differs || mark->form_errors.size() < whole.form_errors.size());
        if (is_better) {
            return mark;
        }
    }
    return whole.understood ? mark_with_reason(question, whole) : mark_before_list(question, whole);
}

}  // namespace

Mark mark_answer(const Question& question, std::string_view text, double confidence) {
    Mark whole = mark_sentence(question, text, confidence);
    std::optional<Mark> by_sentences = mark_sentences(question, whole);
    return by_sentences ? std::move(*by_sentences) : std::move(whole);
}

}  // namespace fulcrum::dialogue
