#include "dialogue/marking/wording.h"

#include "dialogue/english/word_table.h"
#include "dialogue/template/sentences.h"
#include "dialogue/template/tokens.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::dialogue {
namespace {

constexpr auto kArticles = std::to_array<std::string_view>({"a", "an", "the"});
constexpr auto kPronouns = std::to_array<std::string_view>({"it", "they", "he", "she"});
constexpr auto kBe = std::to_array<std::string_view>({"is", "are", "was", "were"});
constexpr auto kHave = std::to_array<std::string_view>({"have", "has", "had"});
constexpr auto kHelping = std::to_array<std::string_view>({"is", "are", "be", "am", "do", "does"});
constexpr auto kSmall =
    std::to_array<std::string_view>({"in", "on", "at", "of", "to", "for", "from", "by", "with"});

/// A right sentence, word by word; each word with the piece that it is of.
struct RightWords {
    std::vector<std::string> words;
    std::vector<int> pieces;
};

RightWords right_words(const std::vector<Piece>& pieces) {
    RightWords right;
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i) {
        for (std::string& word : words_of(pieces[static_cast<std::size_t>(i)].right)) {
            right.words.push_back(std::move(word));
            right.pieces.push_back(i);
        }
    }
    return right;
}

/// Where two sentences differ: said [first, said_last), right [first, right_last).
struct Difference {
    std::size_t first = 0, said_last = 0, right_last = 0;
};

Difference difference(const std::vector<Token>& said, const std::vector<std::string>& right) {
    Difference apart{0, said.size(), right.size()};
    while (apart.first < said.size() && apart.first < right.size() &&
           said[apart.first].text == right[apart.first]) {
        ++apart.first;
    }
    while (apart.said_last > apart.first && apart.right_last > apart.first &&
           said[apart.said_last - 1].text == right[apart.right_last - 1]) {
        --apart.said_last;
        --apart.right_last;
    }
    return apart;
}

/// The error of a word said for another, which is `place` of the right sentence.
ErrorCode replaced(const std::string& said, const std::string& right, const Element& place) {
    if ((contains(kHave, said) && contains(kBe, right)) ||
        (contains(kBe, said) && contains(kHave, right))) {
        return ErrorCode::verb_form;
    }
    if (contains(kSmall, said) && contains(kSmall, right)) {
        return ErrorCode::wrong_preposition;
    }
    if (contains(kArticles, said) && contains(kArticles, right)) {
        return ErrorCode::wrong_determiner;
    }
    if (place.role == Role::adjective) {
        return said == place.base ? ErrorCode::adjective_form : ErrorCode::wording;
    }
    if (!alike(said, right) || said.size() < 3) {
        return ErrorCode::wording;
    }
    if (right.ends_with("ed")) {
        return ErrorCode::verb_tense;
    }
    if (said.ends_with("ing")) {
        return ErrorCode::verb_form;
    }
    return right == said + "s" || right == said + "es" ? ErrorCode::agreement : ErrorCode::wording;
}

/// A right sentence for what was said, and the one word that differs.
struct Reading {
    std::vector<Piece> pieces;
    RightWords right;
    Difference apart;
    ErrorCode code = ErrorCode::wording;
};

/// The error of leaving `word` out, first in the sentence or not.
ErrorCode left_out(const std::string& word, bool first) {
    if (contains(kArticles, word)) {
        return ErrorCode::missing_determiner;
    }
    if (contains(kBe, word)) {
        return ErrorCode::missing_verb;
    }
    return first && contains(kPronouns, word) ? ErrorCode::missing_pronoun : ErrorCode::wording;
}

/// The error of saying `word` where nothing belongs.
ErrorCode said_too_much(const std::string& word, bool first) {
    if (contains(kArticles, word)) {
        return ErrorCode::extra_determiner;
    }
    return !first && contains(kPronouns, word) ? ErrorCode::extra_pronoun : ErrorCode::wording;
}

/// The error where a sentence differs from the right one in one place; `wording` where that isn't one of a word.
ErrorCode error_there(const std::vector<Token>& said, const Reading& reading) {
    const Difference& apart = reading.apart;
    const std::size_t n_said = apart.said_last - apart.first;
    const std::size_t n_right = apart.right_last - apart.first;
    if (n_said == 0 && n_right == 1) {
        return left_out(reading.right.words[apart.first], apart.first == 0);
    }
    if (n_said == 1 && n_right == 0) {
        return said_too_much(said[apart.first].text, apart.first == 0);
    }
    if (n_said == 1 && n_right == 1) {
        const int piece = reading.right.pieces[apart.first];
        return replaced(said[apart.first].text, reading.right.words[apart.first],
                        reading.pieces[static_cast<std::size_t>(piece)].element);
    }
    const bool helped = n_said == 2 && n_right == 1 && contains(kHelping, said[apart.first].text) &&
                        alike(said[apart.first + 1].text, reading.right.words[apart.first]);
    return helped ? ErrorCode::verb_form : ErrorCode::wording;
}

/// The words of what was said.
std::vector<std::string> texts_of(const std::vector<Token>& said) {
    std::vector<std::string> words;
    words.reserve(said.size());
    for (const Token& token : said) {
        words.push_back(token.text);
    }
    return words;
}

/// The same words in another order; articles go with the template.
bool is_reordered(std::vector<std::string> words, std::vector<std::string> right) {
    const auto is_article_too = [](const std::string& word) { return contains(kArticles, word); };
    std::erase_if(words, is_article_too);
    std::erase_if(right, is_article_too);
    std::sort(words.begin(), words.end());
    std::sort(right.begin(), right.end());
    return words == right;
}

/// Of the answers that mean the same the one that one word is away; the first one where none is.
Reading nearest(const TemplateSet& set, const Parse& parse, const std::vector<Token>& said) {
    const std::vector<std::string> words = texts_of(said);
    std::optional<Reading> first;
    for (const int answer : set.graphs[static_cast<std::size_t>(parse.graph)].answers) {
        Reading reading;
        reading.pieces = canonical_pieces(set, answer, parse.slots, words);
        reading.right = right_words(reading.pieces);
        reading.apart = difference(said, reading.right.words);
        reading.code = error_there(said, reading);
        if (reading.code != ErrorCode::wording) {
            return reading;
        }
        if (is_reordered(words, reading.right.words)) {
            reading.code = ErrorCode::word_order;
            return reading;
        }
        first = first ? std::move(first) : std::move(reading);
    }
    return std::move(*first);
}

bool is_of_whole(const Reading& reading) {
    return reading.code == ErrorCode::wording || reading.code == ErrorCode::word_order;
}

/// The pieces of the words in which the right sentence differs; of one too many, the word behind it.
PieceRange shown(const Reading& reading) {
    const std::vector<int>& places = reading.right.pieces;
    if (is_of_whole(reading) || places.empty()) {
        return {0, static_cast<int>(reading.pieces.size())};
    }
    const std::size_t first = std::min(reading.apart.first, places.size() - 1);
    const std::size_t last = std::max(reading.apart.right_last, first + 1) - 1;
    return {places[first], places[std::min(last, places.size() - 1)] + 1};
}

}  // namespace

void mark_wording(const TemplateSet& set, const Parse& parse, Mark& mark) {
    const std::string_view text = std::string_view(mark.said).substr(0, parse.unread);
    const std::vector<Token> said = tokenise(text);
    const Reading reading = nearest(set, parse, said);
    const PieceRange range = shown(reading);
    mark.corrected = render(reading.pieces);
    mark.gapped =
        reading.code == ErrorCode::wording ? mark.corrected : render(reading.pieces, range, true);
    mark.emphasis = render_phrase(reading.pieces, range);
    mark.emphasised = render(reading.pieces, range);
    FormError error;
    error.code = reading.code;
    error.target = true;
    error.phrase = mark.emphasis;
    if (is_of_whole(reading)) {
        error.said = mark.said;
        error.end = mark.said.size();
        error.right = mark.emphasis;
    } else {
        const Difference& apart = reading.apart;
        error.begin = apart.first < said.size() ? said[apart.first].begin : text.size();
        error.end = apart.said_last > apart.first ? said[apart.said_last - 1].end : error.begin;
        error.said = mark.said.substr(error.begin, error.end - error.begin);
        if (reading.code == ErrorCode::adjective_form) {
            const Element& place = reading.pieces[static_cast<std::size_t>(range.last - 1)].element;
            error.role = place.role;
            error.base = place.base;
            error.degree = place.degree;
        }
        for (std::size_t i = apart.first; i < apart.right_last; ++i) {
            error.right += (error.right.empty() ? "" : " ") + reading.right.words[i];
        }
    }
    mark.form_errors.push_back(std::move(error));
}

}  // namespace fulcrum::dialogue
