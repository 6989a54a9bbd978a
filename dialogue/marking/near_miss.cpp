#include "dialogue/marking/near_miss.h"

#include "dialogue/english/letters.h"
#include "dialogue/english/number.h"
#include "dialogue/english/opposite.h"
#include "dialogue/english/word_table.h"
#include "dialogue/template/matcher.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <optional>

namespace fulcrum::dialogue {
namespace {

/// Bytes [begin, end) of an utterance.
struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// "Weighs less" for "weighs more", where that is said for "lighter" and "heavier"; empty where it isn't.
std::string turned_weight(std::string said, const Element& adjective) {
    constexpr std::array<std::array<std::string_view, 2>, 2> kTurns = {
        {{"weighs less", "weighs more"}, {"weighs the least", "weighs the most"}}};
    const bool compares = adjective.degree != Degree::positive;
    if (!compares || (adjective.base != "heavy" && adjective.base != "light")) {
        return {};
    }
    const std::array<std::string_view, 2>& turn =
        kTurns[adjective.degree == Degree::comparative ? 0 : 1];
    const std::size_t from = adjective.base == "heavy" ? 0 : 1;
    const std::size_t at = said.find(turn[from]);
    return at == std::string::npos ? std::string()
                                   : said.replace(at, turn[from].size(), turn[1 - from]);
}

/// The form of this adjective's opposite in `said` with which the answer would fit if it were turned round; or empty.
std::string opposite_in(const TemplateSet& set, const std::string& said, const Element& adjective,
                        const std::string& asked) {
    const std::string turned = turned_weight(said, adjective);
    if (!turned.empty() && match(set, turned)) {
        return degree_forms(adjective.base == "heavy" ? "light" : "heavy", adjective.degree)
            .front();
    }
    for (const std::string_view opposite : opposites_of(adjective.base)) {
        for (const std::string& form : degree_forms(opposite, adjective.degree)) {
            const std::size_t at = said.find(form);
            if (at != std::string::npos &&
                match(set, std::string(said).replace(at, form.size(), asked))) {
                return form;
            }
        }
    }
    return {};
}

/// Looks whether the answer fits once an opposite is turned round: "the egg is lighter" where "heavier" is asked. Whether
/// that is true isn't known here, and it says nothing about what was asked.
bool find_opposite(const TemplateSet& set, std::string_view text, Mark& mark) {
    const std::string said = lower_case(text);
    const std::vector<std::string> words = words_of(text);
    if (contains(words, "not")) {
        return false;  // "the egg is not lighter" tells of neither
    }
    for (const Graph& graph : set.graphs) {
        for (const Element& element : graph.elements) {
            if (element.role != Role::adjective || element.slot != kNone) {
                continue;  // a list's adjectives are the learner's choice
            }
            const std::string asked = degree_forms(element.base, element.degree).front();
            if (const std::string form = opposite_in(set, said, element, asked); !form.empty()) {
                const char* the = element.degree == Degree::superlative ? "the " : "";
                mark.opposite_said = the + form;
                mark.opposite_of = the + asked;
                return true;
            }
        }
    }
    return false;
}

bool is_number(std::string_view text) {
    const std::vector<std::string> words = words_of(text);
    return !words.empty() && std::all_of(words.begin(), words.end(), [](const std::string& word) {
        return is_number_word(word) || word == "and";
    });
}

/// The first number in `text`; a whole one, one with a point in it, or one below zero.
std::optional<Span> number_in(std::string_view text) {
    std::optional<Span> number;
    for (const Token& token : tokenise(text)) {
        const bool is_digits = token.text.find_first_not_of("0123456789") == std::string::npos;
        if (token.text == "minus" && !number) {
            number = Span{token.begin, token.end};
        } else if (is_digits || is_number_word(token.text)) {
            number = Span{number ? number->begin : token.begin, token.end};
        } else if (number && token.text != "and" && token.text != "point") {
            break;
        }
    }
    return number;
}

/// The utterance with other words in the places `spans`, which are in order.
std::string with_instead(std::string_view text, const std::vector<Span>& spans,
                         std::string_view words) {
    std::string changed;
    std::size_t at = 0;
    for (const Span& span : spans) {
        changed.append(text.substr(at, span.begin - at)).append(words);
        at = span.end;
    }
    return changed.append(text.substr(at));
}

/// Would the answer fit with a number of the list instead of its own? Then it is a number, only not one of those.
bool find_other_number(const TemplateSet& set, std::string_view text, Mark& mark) {
    const std::optional<Span> number = number_in(text);
    if (!number) {
        return false;
    }
    for (const WordList& list : set.lists) {
        // The last is no "one" where there are several, so that a plural behind it is right.
        const auto item = std::find_if(
            list.items.rbegin(), list.items.rend(),
            [](const ListItem& entry) { return is_number(entry.spoken.front().text); });
        if (item != list.items.rend() &&
            match(set, with_instead(text, {*number}, item->spoken.front().text))) {
            mark.understood = true;
            mark.other_number =
                std::string(text.substr(number->begin, number->end - number->begin));
            return true;
        }
    }
    return false;
}

constexpr std::array<std::string_view, 5> kPointing = {"this", "that", "these", "those", "it"};
constexpr std::array<std::string_view, 6> kPointedAt = {"one",    "ones",     "thing",
                                                        "things", "material", "materials"};

/// Where a thing is pointed at: "this one", or "this" alone when `bare`.
std::vector<Span> pointings(std::string_view text, bool bare) {
    const std::vector<Token> tokens = tokenise(text);
    std::vector<Span> spans;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        if (!contains(kPointing, tokens[i].text)) {
            continue;
        }
        if (i + 1 < tokens.size() && contains(kPointedAt, tokens[i + 1].text)) {
            spans.push_back({tokens[i].begin, tokens[i + 1].end});
        } else if (bare) {
            spans.push_back({tokens[i].begin, tokens[i].end});
        }
    }
    return spans;
}

/// Would the answer fit with a word of a list where it only points?
bool find_pointing(const TemplateSet& set, std::string_view text, Mark& mark) {
    for (const bool bare : {false, true}) {
        const std::vector<Span> spans = pointings(text, bare);
        if (spans.empty()) {
            continue;
        }
        for (const WordList& list : set.lists) {
            const std::string& noun = list.items.front().spoken.front().text;
            if (match(set, with_instead(text, spans, noun)) ||
                match(set, with_instead(text, spans, "the " + noun))) {
                mark.pointed_with = std::string(
                    text.substr(spans.front().begin, spans.front().end - spans.front().begin));
                return true;
            }
        }
    }
    return false;
}

}  // namespace

void find_near_miss(const TemplateSet& set, std::string_view text, Mark& mark) {
    text = text.substr(0, kLongestUtterance_bytes);
    if (!find_opposite(set, text, mark) && !find_other_number(set, text, mark)) {
        find_pointing(set, text, mark);
    }
}

}  // namespace fulcrum::dialogue
