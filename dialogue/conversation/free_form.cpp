// Free English in a conversation: what fits no answer, and what stands behind one; for conversation.h and turn.h.
#include "dialogue/conversation/conversation.h"
#include "dialogue/conversation/recast.h"
#include "dialogue/english/adjective.h"
#include "dialogue/english/letters.h"
#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <utility>

namespace fulcrum::dialogue {
namespace {

/// The adjective in "most tall", for its rule; empty for another error.
std::string base_of(const FreeError& error) {
    const std::vector<std::string> words = words_of(error.said);
    const bool said_more = words.size() > 1 &&
                           (words[words.size() - 2] == "more" || words[words.size() - 2] == "most");
    return error.code == ErrorCode::adjective_form && said_more ? words.back() : std::string();
}

FormError form_error_of(const FreeError& error) {
    FormError made;
    made.code = error.code;
    made.said = error.said;
    made.begin = error.begin;
    made.end = error.end;
    made.right = made.phrase = std::string(without_blanks(error.right));
    made.base = base_of(error);
    if (!made.base.empty()) {
        const auto forms = degree_forms(made.base, Degree::superlative);
        made.role = Role::adjective;
        made.degree =
            made.right.ends_with(forms.front()) ? Degree::superlative : Degree::comparative;
    }
    return made;
}

/// What was put right left out as "…".
std::string with_gaps(std::string text, std::vector<FreeError> errors) {
    std::sort(errors.begin(), errors.end(),
              [](const FreeError& a, const FreeError& b) { return a.begin > b.begin; });
    for (const FreeError& error : errors) {
        const std::string_view right = error.right;
        const std::size_t first = std::min(right.find_first_not_of(' '), right.size());
        const std::size_t last = right.find_last_not_of(' ') + 1;
        const std::string gap = first < last ? "…" : "";
        text.replace(error.begin, error.end - error.begin,
                     std::string(right.substr(0, first)) + gap +
                         std::string(right.substr(std::max(first, last))));
    }
    return text;
}

}  // namespace

std::optional<Mark> Conversation::mark_put_right(const Mark& mark) const {
    if (!form_check_ || mark.understood || !heard_well(mark.confidence) || wants_help(mark.said)) {
        return std::nullopt;
    }
    const CheckedText checked = form_check_(mark.said);
    if (checked.errors.empty() || !checked.proven) {
        return std::nullopt;
    }
    Mark right = mark_answer(*question_, checked.corrected, mark.confidence);
    if (!right.understood || !right.form_right() || !right.other_number.empty() ||
        right.turned_round) {
        return std::nullopt;
    }
    right.said = mark.said;
    right.unread.clear();  // a reason was read with all the rest
    right.unread_begin = right.said.size();
    for (const FreeError& error : checked.errors) {
        right.form_errors.push_back(form_error_of(error));
    }
    right.corrected = as_sentences(checked.corrected);
    right.emphasised = as_sentences(checked.marked);
    right.gapped = as_sentences(with_gaps(mark.said, checked.errors));
    right.emphasis = right.main_error()->phrase;
    return right;
}

bool Conversation::read_rest(Turn& turn) const {
    const Mark& mark = turn.mark;
    if (mark.unread.empty()) {
        return true;
    }
    if (!form_check_ || !mark.form_known) {
        return !mark.form_known;  // then nothing is said of the form anyway
    }
    CheckedText& checked = turn.checked;
    checked = form_check_(mark.unread);
    const bool is_good = checked.errors.empty() && checked.proven;
    if (!checked.errors.empty() && checked.proven && !asks_back(mark.corrected)) {
        const auto first = [](std::string_view text) {
            return std::string(text.substr(0, text.find_last_not_of(" .!") + 1));
        };
        turn.joined = first(mark.emphasised) + " " + first(checked.marked) + ".";
    }
    for (FreeError& error : checked.errors) {
        error.begin += mark.unread_begin;
        error.end += mark.unread_begin;
    }
    return is_good;
}

void Conversation::check_form(Turn& turn) const {
    if (form_check_ && turn.mark.form_known) {
        turn.checked = form_check_(turn.mark.said);
        turn.feedback.free_errors = turn.checked.errors;
    }
}

// A whole sentence may have errors that nobody saw; of these words it is known what belongs there.
const FreeError* find_alone(const std::vector<FreeError>& errors) {
    const auto error = std::find_if(errors.begin(), errors.end(), [](const FreeError& one) {
        return one.alone && !one.said.starts_with('\'');  // "'s" can't be told alone
    });
    return error == errors.end() ? nullptr : &*error;
}

}  // namespace fulcrum::dialogue
