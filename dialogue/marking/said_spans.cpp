#include "dialogue/marking/said_spans.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/number.h"
#include "dialogue/english/word_table.h"
#include "dialogue/template/hearing.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr auto kShortened = std::to_array<std::string_view>(
    {"mr", "mrs", "ms", "dr", "prof", "st", "vs", "approx", "e.g", "i.e"});
constexpr auto kForThing =
    std::to_array<std::string_view>({"it", "they", "he", "she", "this", "that", "these", "those"});
constexpr auto kVerbs = std::to_array<std::string_view>(
    {"is", "are", "has", "have", "weighs", "weigh", "feels", "feel", "does", "do"});
constexpr auto kNoItems = std::to_array<std::string_view>(
    {"not", "no", "none", "never", "nothing", "wrong", "or", "but", "is", "are", "was", "has"});

bool is_space(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\n' || letter == '\r';
}

bool is_digit_at(std::string_view text, std::size_t at) {
    return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

/// The word of letters and points that ends before `at`.
std::string_view word_before(std::string_view text, std::size_t at) {
    std::size_t first = at;
    while (first > 0 && !is_space(text[first - 1])) {
        --first;
    }
    return text.substr(first, at - first);
}

bool ends_sentence(std::string_view text, std::size_t at) {
    constexpr std::string_view kEnds = "!?;:\n";
    if (kEnds.find(text[at]) != std::string_view::npos) {
        return text[at] != ':' || !is_digit_at(text, at + 1);
    }
    const bool parts = at + 1 >= text.size() || is_space(text[at + 1]) || text[at + 1] == '.';
    return text[at] == '.' && parts && !contains(kShortened, lower_case(word_before(text, at)));
}

/// "And the egg is lighter": a clause, and no other word of a list.
bool has_verb(std::string_view text) {
    const std::string_view clause = text.substr(0, text.find_first_of(",.;:!?"));
    return std::ranges::any_of(words_of(clause),
                               [](const std::string& word) { return contains(kVerbs, word); });
}

/// One word or two with an article: "Mercury", "the solar wind".
bool is_item(const std::vector<std::string>& words) {
    constexpr std::size_t kMostWords_item = 3;
    return !words.empty() && words.size() <= kMostWords_item &&
           std::ranges::none_of(words, [](const std::string& word) {
               return contains(kNoItems, word) || is_number_word(word);
           });
}

/// How many bytes of `text` at `at` part two clauses; 0 for none.
std::size_t clause_end(std::string_view text, std::size_t at) {
    if (text[at] == ',') {
        return is_digit_at(text, at + 1) ? 0 : 1;
    }
    if (!is_space(text[at])) {
        return 0;
    }
    const std::string next = lower_case(text.substr(at + 1, kLongestUtterance_bytes));
    const bool joins = next.starts_with("and ") && !next.starts_with("and not ") && has_verb(next);
    return joins || next.starts_with("but ") ? 4 : 0;
}

}  // namespace

std::vector<SaidSpan> said_sentences(std::string_view text, bool clauses) {
    std::vector<SaidSpan> spans;
    const auto add = [&](std::size_t begin, std::size_t end) {
        const std::vector<Token> words = tokenise(text.substr(begin, end - begin));
        if (words.empty()) {
            return;
        }
        const bool joins = words.front().text == "and" || words.front().text == "but";
        if (!spans.empty() && begins_reason(words.front().text)) {
            spans.back().end = end;
        } else if (!spans.empty() && joins && words.size() > 1) {
            spans.push_back({begin + words[1].begin, end});
        } else {
            spans.push_back({begin, end});
        }
    };
    std::size_t begin = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::size_t gap = ends_sentence(text, at) ? 1 : clauses ? clause_end(text, at) : 0;
        if (gap > 0) {
            add(begin, at);
            begin = at + gap;
            at += gap - 1;
        }
    }
    add(begin, text.size());
    return spans;
}

std::optional<SaidSpan> find_pronoun(std::string_view text) {
    for (const Token& token : tokenise(text)) {
        if (contains(kForThing, token.text)) {
            return SaidSpan{token.begin, token.end};
        }
    }
    return std::nullopt;
}

bool has_sentence_end(std::string_view text) {
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (ends_sentence(text, at)) {
            return true;
        }
    }
    return false;
}

std::optional<SaidList> list_behind(std::string_view text) {
    const std::size_t colon = text.find(':');
    const std::size_t before = colon != std::string_view::npos ? colon : text.find(',');
    if (before == std::string_view::npos) {
        return std::nullopt;
    }
    SaidList list{before, {}};
    std::size_t begin = before + 1;
    const auto add = [&](std::size_t end) {
        if (!words_of(text.substr(begin, end - begin)).empty()) {
            list.items.push_back({begin, end});
        }
    };
    for (std::size_t at = begin; at < text.size(); ++at) {
        const bool joins = lower_case(text.substr(at, 5)) == " and ";
        if (text[at] == ',' || joins) {
            add(at);
            begin = at + (joins ? 5 : 1);
        }
    }
    add(text.size());
    const std::size_t least = colon != std::string_view::npos ? 1 : 2;
    const bool is_list =
        list.items.size() >= least && std::ranges::all_of(list.items, [&](const SaidSpan& item) {
            const auto said = text.substr(item.begin, item.end - item.begin);
            return is_item(words_of(said)) && said.find(':') == std::string::npos;
        });
    return is_list ? std::optional<SaidList>(std::move(list)) : std::nullopt;
}

}  // namespace fulcrum::dialogue
