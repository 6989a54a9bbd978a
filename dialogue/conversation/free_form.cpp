// Free English in a conversation: what fits no answer, and what stands behind one.
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

/// The word of `text` at the byte `at`, or behind the blanks there.
std::string word_at(std::string_view text, std::size_t at) {
    const std::size_t first = std::min(text.find_first_not_of(' ', at), text.size());
    text.remove_prefix(first);
    return std::string(text.substr(0, text.find_first_of(" ,.;:?!")));
}

/// A checked text with its capitals and its end.
std::string as_sentences(const std::string& text) {
    const std::string sentences = sentences_case(text);
    const bool has_end =
        !sentences.empty() && std::string_view(".?!").find(sentences.back()) != std::string::npos;
    return sentences + (has_end ? "" : ".");
}

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

Conversation::Rest Conversation::read_rest(const Mark& mark) const {
    Rest rest;
    if (mark.unread.empty()) {
        return rest;
    }
    if (!form_check_ || !mark.form_known) {
        rest.good = !mark.form_known;  // then nothing is said of the form anyway
        return rest;
    }
    rest.checked = form_check_(mark.unread);
    rest.good = rest.checked.errors.empty() && rest.checked.proven;
    if (!rest.checked.errors.empty() && rest.checked.proven && !asks_back(mark.corrected)) {
        const auto first = [](std::string_view text) {
            return std::string(text.substr(0, text.find_last_not_of(" .!") + 1));
        };
        rest.joined = first(mark.emphasised) + " " + first(rest.checked.marked) + ".";
    }
    for (FreeError& error : rest.checked.errors) {
        error.begin += mark.unread_begin;
        error.end += mark.unread_begin;
    }
    return rest;
}

// Of what nobody understood nothing is praised; an error that is sure is told.
Feedback Conversation::respond_to_rest(const Mark& mark, const Rest& rest) {
    if (!rest.joined.empty()) {
        Feedback feedback =
            say(FeedbackKind::recast, recast_key(mark), {{"sentence", rest.joined}});
        feedback.free_errors = rest.checked.errors;
        return feedback;
    }
    Feedback words;
    const bool told = show_good_words(mark.said, rest.checked.errors, words);
    Feedback feedback = say(told ? FeedbackKind::recast : FeedbackKind::praise,
                            "feedback.praise_short", {{"sentence", mark.corrected}});
    if (told) {
        feedback.text.append(" ").append(without_blanks(words.text));
        feedback.keys.push_back(words.keys.front());
    }
    feedback.free_errors = rest.checked.errors;
    return feedback;
}

void Conversation::show_good_english(const Mark& mark, Feedback& feedback) const {
    if (!form_check_ || !mark.form_known) {
        return;
    }
    CheckedText checked = form_check_(mark.said);
    if (checked.errors.empty()) {
        return;
    }
    if (checked.proven) {
        put_before(feedback, "feedback.free_form", {{"sentence", as_sentences(checked.marked)}});
    } else {
        show_good_words(mark.said, checked.errors, feedback);
    }
    feedback.free_errors = std::move(checked.errors);
}

// A whole sentence may have errors that nobody saw; of these words it is known what belongs there.
bool Conversation::show_good_words(std::string_view text, const std::vector<FreeError>& errors,
                                   Feedback& feedback) const {
    const auto error = std::find_if(errors.begin(), errors.end(), [](const FreeError& one) {
        return one.alone && !one.said.starts_with('\'');  // "'s" can't be told alone
    });
    if (error == errors.end()) {
        return false;
    }
    const std::string said(without_blanks(error->said));
    const std::string right(without_blanks(error->right));
    const std::string next = word_at(text, right.empty() ? error->end : error->begin);
    const bool is_determiner = error->code == ErrorCode::extra_determiner;
    if (right.empty() && is_determiner && !next.empty()) {
        put_before(feedback, "feedback.free_words", {{"right", next}, {"said", said + " " + next}});
    } else if (right.empty()) {
        put_before(feedback, "feedback.free_extra", {{"said", said}});
    } else if (said.empty()) {
        put_before(feedback, "feedback.free_missing", {{"right", right}, {"next", next}});
    } else {
        put_before(feedback, "feedback.free_words", {{"right", right}, {"said", said}});
    }
    return true;
}

void Conversation::put_before(Feedback& feedback, const char* key, CatalogueSlots slots) const {
    slots.emplace_back("then", feedback.text);
    feedback.text = catalogue_->say(key, slots);
    feedback.keys.emplace_back(key);
}

}  // namespace fulcrum::dialogue
