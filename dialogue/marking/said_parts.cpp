#include "dialogue/marking/said_parts.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/word_table.h"
#include "dialogue/marking/mark_sentence.h"
#include "dialogue/marking/other_degree.h"
#include "dialogue/marking/readings.h"
#include "dialogue/template/hearing.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr auto kAsksYesOrNo =
    std::to_array<std::string_view>({"is", "are", "was", "were", "do", "does", "did", "can",
                                     "could", "has", "have", "will", "would", "should", "must"});
constexpr auto kAnsweringVerbs =
    std::to_array<std::string_view>({"is", "are", "does", "do", "has", "have", "can", "will"});

std::vector<std::string> words_in(std::string_view text, const SaidSpan& span) {
    return words_of(text.substr(span.begin, span.end - span.begin));
}

/// All of `slots` is said by `others` too.
bool says_all_of(const Slots& others, const Slots& slots) {
    return std::ranges::all_of(
        slots, [&](const auto& slot) { return std::ranges::find(others, slot) != others.end(); });
}

/// The question may be answered by "no".
bool asks_yes_or_no(const Question& question) {
    if (mark_sentence(question, "no").understood) {
        return true;
    }
    const std::vector<SaidSpan> sentences = said_sentences(question.prompt, true);
    return std::ranges::any_of(sentences, [&](const SaidSpan& span) {
        const std::vector<std::string> words = words_in(question.prompt, span);
        return contains(kAsksYesOrNo, words.front());
    });
}

/// Reads one answer, sentence by sentence.
class SaidReader {
  public:
    SaidReader(const Question& question, std::string_view text)
        : question_(question), text_(text) {}

    /// False where one of the sentences is not understood.
    bool read(const std::vector<SaidSpan>& spans) {
        for (const SaidSpan& span : spans) {
            const bool is_first = parts_.empty();
            const bool passes = (is_first && (is_mere_no(span) || asks_back(span))) || take(span) ||
                                is_frame(of(span));
            if (!passes) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] std::vector<SaidPart>& parts() { return parts_; }

  private:
    [[nodiscard]] std::string_view of(const SaidSpan& span) const {
        return text_.substr(span.begin, span.end - span.begin);
    }

    /// "No, the apple is heavier!" where nobody asked for yes or no.
    [[nodiscard]] bool is_mere_no(const SaidSpan& span) const {
        return words_in(text_, span) == std::vector<std::string>{"no"} &&
               !asks_yes_or_no(question_);
    }

    /// "The spaceship? It is made of metal.": words of the question, as one does to think. Where it offers one or the other they answer.
    [[nodiscard]] bool asks_back(const SaidSpan& span) const {
        const std::string prompt = words_between_blanks(question_.prompt);
        const std::string words = words_between_blanks(of(span));
        return span.end < text_.size() && text_[span.end] == '?' &&
               prompt.find(words) != std::string::npos &&
               prompt.find(" or ") == std::string::npos &&
               words.find(" not ") == std::string::npos && words.find(" no ") == std::string::npos;
    }

    bool take(const SaidSpan& span) {
        const std::vector<std::string> words = words_in(text_, span);
        if (!parts_.empty() && words.front() == "then") {
            return false;  // "the apple, then the egg": an order
        }
        return keep(mark_sentence(question_, of(span)), span.begin, false) || take_denied(span) ||
               take_answering_verb(span) || take_pronoun(span) || take_opposite(span);
    }

    /// Keeps what is understood, with its errors where they stand in the whole answer.
    bool keep(Mark mark, std::size_t begin, bool denied) {
        if (!mark.understood || mark.turned_round || !mark.other_number.empty() ||
            says_other_degree(mark)) {
            return false;
        }
        for (FormError& error : mark.form_errors) {
            error.begin += begin;
            error.end += begin;
        }
        mark.unread_begin += begin;
        parts_.push_back({std::move(mark), denied});
        return true;
    }

    /// "Not the egg", "not nine".
    bool take_denied(const SaidSpan& span) {
        const std::vector<Token> tokens = tokenise(of(span));
        if (tokens.size() < 2 || tokens.front().text != "not") {
            return false;
        }
        const std::size_t behind = span.begin + tokens.front().end;
        Mark mark = mark_sentence(question_, text_.substr(behind, span.end - behind));
        const bool is_other_number = mark.understood && !mark.other_number.empty();
        return is_other_number ||
               (mark.claim == Claim::same && keep(std::move(mark), behind, true));
    }

    /// "The apple is heavier, the egg is lighter": so it is not the egg that is heavier. Nothing else is "the lightest".
    bool take_opposite(const SaidSpan& span) {
        std::string said = lower_case(of(span));
        const Mark mark = mark_sentence(question_, said);
        const std::size_t at = said.find(mark.opposite_said);
        if (mark.opposite_said.empty() || mark.opposite_said.starts_with("the ") ||
            at == std::string::npos) {
            return false;
        }
        Mark turned =
            mark_sentence(question_, said.replace(at, mark.opposite_said.size(), mark.opposite_of));
        return turned.claim == Claim::same && turned.form_right() &&
               keep(std::move(turned), span.begin, true);
    }

    /// "The egg is not heavier, the apple is."
    bool take_answering_verb(const SaidSpan& span) {
        const std::vector<Token> tokens = tokenise(of(span));
        if (tokens.size() < 2 || !contains(kAnsweringVerbs, tokens.back().text)) {
            return false;
        }
        Mark mark = mark_sentence(question_, of(span).substr(0, tokens.back().begin));
        return mark.short_answer && keep(std::move(mark), span.begin, false);
    }

    /// "The apple. It is heavier.": of what was named before.
    bool take_pronoun(const SaidSpan& span) {
        const auto named = std::ranges::find_if(parts_, [](const SaidPart& part) {
            return !part.denied && part.mark.claim == Claim::same && part.mark.slots.size() == 1;
        });
        const std::optional<SaidSpan> pronoun = find_pronoun(of(span));
        if (named == parts_.end() || !pronoun) {
            return false;
        }
        const std::string value = named->mark.slots.front().second;
        for (const std::string& noun : {"the " + value, value}) {
            std::string said(of(span));
            said.replace(pronoun->begin, pronoun->end - pronoun->begin, noun);
            Mark mark = mark_sentence(question_, said);
            const std::size_t behind = pronoun->begin + noun.size();
            const bool noun_is_right =
                std::ranges::none_of(mark.form_errors, [&](const FormError& error) {
                    return error.begin <= behind && error.end >= pronoun->begin;
                });
            if (!mark.understood || !noun_is_right) {
                continue;
            }
            const auto place_said = [&](std::size_t& at) {
                at = at >= behind ? at - behind + pronoun->end : at;
            };
            for (FormError& error : mark.form_errors) {
                place_said(error.begin);
                place_said(error.end);
            }
            place_said(mark.unread_begin);
            return keep(std::move(mark), span.begin, false);
        }
        return false;
    }

    const Question& question_;
    std::string_view text_;
    std::vector<SaidPart> parts_;
};

/// What is denied in a sentence of its own, "it is not soft", is ruled out; a place of something, "on top", is said by the sentence
/// with that thing as well. False for what cannot stand beside other sentences.
bool settle_claims(std::vector<SaidPart>& parts) {
    for (SaidPart& part : parts) {
        if (part.mark.claim == Claim::contrary || part.mark.claim == Claim::excluded) {
            part.denied = true;
            part.mark.claim = Claim::same;
        }
    }
    const auto is_said = [](const SaidPart& part) {
        return !part.denied && part.mark.claim == Claim::same;
    };
    std::vector<SaidPart> whole;
    std::ranges::copy_if(parts, std::back_inserter(whole), is_said);
    std::erase_if(parts, [&](const SaidPart& part) {
        return part.mark.claim == Claim::of_any &&
               std::ranges::any_of(whole, [&](const SaidPart& other) {
                   return says_all_of(other.mark.slots, part.mark.slots);
               });
    });
    return !whole.empty() && std::ranges::all_of(parts, [](const SaidPart& part) {
        return part.mark.claim == Claim::same;
    });
}

/// The meanings that have to be right, and those that have to be wrong, each once.
void gather_readings(const std::vector<SaidPart>& parts, Mark& mark) {
    mark.readings.clear();
    for (const bool denied : {false, true}) {
        for (const SaidPart& part : parts) {
            const Slots& slots = part.mark.slots;
            const bool said_more = std::ranges::any_of(parts, [&](const SaidPart& other) {
                const bool earlier = &other < &part || other.mark.slots != slots;
                return &other != &part && other.denied == denied && earlier &&
                       says_all_of(other.mark.slots, slots);
            });
            if (part.denied == denied && (denied || !said_more)) {
                mark.readings.push_back(slots);
                mark.denied.push_back(denied);
            }
        }
    }
    mark.claim = Claim::every;
    if (mark.readings.size() == 1) {
        mark.slots = mark.readings.front();
        mark.claim = Claim::same;
        mark.readings.clear();
        mark.denied.clear();
    }
}

/// The sentence that is said back: the first with an error, else the first whole one.
const SaidPart& shown_of(const std::vector<SaidPart>& parts) {
    const auto with_error = std::ranges::find_if(
        parts, [](const SaidPart& part) { return !part.mark.form_errors.empty(); });
    if (with_error != parts.end()) {
        return *with_error;
    }
    const auto is_shown = [](const SaidPart& part) { return !part.denied; };
    const auto whole = std::ranges::find_if(
        parts, [&](const SaidPart& part) { return is_shown(part) && !part.mark.short_answer; });
    return whole != parts.end() ? *whole : *std::ranges::find_if(parts, is_shown);
}

}  // namespace

std::optional<std::vector<SaidPart>> read_parts(const Question& question, std::string_view text,
                                                const std::vector<SaidSpan>& spans) {
    SaidReader reader(question, text);
    return reader.read(spans) ? std::optional(std::move(reader.parts())) : std::nullopt;
}

std::optional<Mark> joined_mark(std::vector<SaidPart> parts, const Mark& whole) {
    if (!settle_claims(parts)) {
        return std::nullopt;
    }
    Mark mark = shown_of(parts).mark;
    mark.said = whole.said;
    mark.confidence = whole.confidence;
    mark.form_errors.clear();
    mark.short_answer = true;
    mark.unread_begin = whole.said.size();
    for (const SaidPart& part : parts) {
        mark.form_errors.insert(mark.form_errors.end(), part.mark.form_errors.begin(),
                                part.mark.form_errors.end());
        mark.short_answer = mark.short_answer && part.mark.short_answer;
        if (!part.mark.unread.empty()) {
            mark.unread_begin = std::min(mark.unread_begin, part.mark.unread_begin);
        }
    }
    mark.unread = whole.said.substr(mark.unread_begin);
    gather_readings(parts, mark);
    return mark;
}

}  // namespace fulcrum::dialogue
