#include "dialogue/template/resolve_articles.h"

#include "dialogue/english/determiner.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/noun.h"
#include "dialogue/english/number.h"
#include "dialogue/template/phrases.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {
namespace {

/// "The heavier *one*": a noun that the article belongs to.
bool carries_article(const Piece& piece) {
    constexpr std::array<std::string_view, 12> kNever = {"near", "above", "below", "under",
                                                         "over", "high",  "here",  "there",
                                                         "now",  "then",  "when",  "if"};
    return piece.element.role == Role::noun || piece.element.role == Role::adjective ||
           (piece.element.role == Role::word &&
            std::find(kNever.begin(), kNever.end(), piece.right) == kNever.end());
}

/// "Easier near the hinge", "lighter on the Moon": behind it no noun is left out that "the" would belong to.
bool is_place(const Piece& piece) {
    const std::vector<std::string> words = words_of(piece.right);
    const bool is_word = piece.element.slot != kNone || piece.element.role == Role::word;
    const bool said = is_word && !words.empty() && !is_number_word(words.front()) &&
                      understand_noun(piece.right).noun_class == NounClass::no_noun;
    return said ||
           (piece.element.role == Role::preposition && piece.right != "of" && piece.right != "to");
}

}  // namespace

int before(const std::vector<Piece>& pieces, int at) {
    for (int i = at - 1; i >= 0; --i) {
        if (!pieces[static_cast<std::size_t>(i)].right.empty()) {
            return i;
        }
    }
    return kNone;
}

int after(const std::vector<Piece>& pieces, int at) {
    for (int i = at + 1; i < static_cast<int>(pieces.size()); ++i) {
        if (!pieces[static_cast<std::size_t>(i)].right.empty()) {
            return i;
        }
    }
    return kNone;
}

void part_determiners(std::vector<Piece>& pieces, int at) {
    const int last = before(pieces, at);
    if (last == kNone) {
        return;
    }
    Piece& first = pieces[static_cast<std::size_t>(last)];
    Piece& second = pieces[static_cast<std::size_t>(at)];
    const std::vector<std::string> words = words_of(first.right);
    const bool noun = first.element.role == Role::noun && first.element.slot == kNone;
    if (noun || !is_sole_determiner(words.back()) ||
        !is_sole_determiner(words_of(second.right).front()) ||
        (first.element.role == Role::word && words.back() == "that")) {
        return;
    }
    const bool second_goes = second.element.role == Role::determiner;
    if (!second_goes && first.element.role != Role::determiner) {
        return;
    }
    Piece& extra = second_goes ? second : first;
    extra.right.clear();
    extra.code = extra.said.empty() ? ErrorCode::none : ErrorCode::extra_determiner;
    extra.cost = extra.said.empty() ? 0 : kSlipCost;
}

void drop_the(std::vector<Piece>& pieces, int adjective) {
    const int the = before(pieces, adjective);
    const int next = after(pieces, adjective);
    if (the == kNone) {
        return;
    }
    Piece& article = pieces[static_cast<std::size_t>(the)];
    const bool optional = article.element.role == Role::determiner &&
                          article.code == ErrorCode::none && article.right == "the" &&
                          article.element.target;
    const bool than = next != kNone && pieces[static_cast<std::size_t>(next)].right == "than";
    const bool alone = next == kNone || !carries_article(pieces[static_cast<std::size_t>(next)]);
    const bool place = next != kNone && is_place(pieces[static_cast<std::size_t>(next)]);
    const bool other_form =
        pieces[static_cast<std::size_t>(adjective)].code == ErrorCode::adjective_form;
    if (optional && other_form && !than && (alone || place)) {
        article.right.clear();
    } else if (optional && (than || place)) {
        article.right.clear();
        article.code = ErrorCode::extra_determiner;
        article.cost = kSlipCost;
    }
}

void allow_bare_nearest(std::vector<Piece>& pieces, int adjective) {
    constexpr std::array<std::string_view, 3> kPlaces = {"near", "close", "far"};
    const std::string& base = pieces[static_cast<std::size_t>(adjective)].element.base;
    const int the = before(pieces, adjective);
    const auto next = static_cast<std::size_t>(adjective) + 1;
    if (the == kNone || next >= pieces.size() || pieces[next].element.role != Role::preposition ||
        std::find(kPlaces.begin(), kPlaces.end(), base) == kPlaces.end()) {
        return;
    }
    Piece& article = pieces[static_cast<std::size_t>(the)];
    if (article.element.role == Role::determiner && article.right == "the" &&
        article.code == ErrorCode::missing_determiner) {
        article.right.clear();
        article.code = ErrorCode::none;
        article.cost = 0;
    }
}

void sound(std::vector<Piece>& pieces, int at) {
    Piece& article = pieces[static_cast<std::size_t>(at)];
    const int next = after(pieces, at);
    if ((article.right != "a" && article.right != "an") || next == kNone) {
        return;
    }
    const Piece& word = pieces[static_cast<std::size_t>(next)];
    if (word.element.role == Role::noun || both_articles(word.right)) {
        return;  // settled by the noun's own branch
    }
    article.right = std::string(indefinite_article(word.right));
    const std::string said = lower_case(article.said);
    if (said == "a" || said == "an") {
        article.code = said == article.right ? ErrorCode::none : ErrorCode::wrong_determiner;
        article.cost = said == article.right ? 0 : kSlipCost;
    }
}

}  // namespace fulcrum::dialogue
