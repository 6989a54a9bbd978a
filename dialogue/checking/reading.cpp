#include "dialogue/checking/reading.h"

#include "dialogue/checking/grammar_words.h"
#include "dialogue/english/letters.h"
#include "dialogue/english/number.h"
#include "dialogue/english/verb.h"
#include "dialogue/template/tokens.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

constexpr int kMuchMore = 3;   // times: what one calls "mainly"
constexpr int kUsualForm = 5;  // times: another entry's form rather than an entry of its own

bool has_digits(std::string_view word) {
    return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

/// How often a form stands for something: its own count, or that of the most common word it is a form of.
int count_of(const Lexicon& lexicon, std::string_view base, WordKind kind) {
    return std::max(1, lexicon.count(base, kind));
}

void read_noun(const Lexicon& lexicon, FreeWord& word) {
    word.can_be_singular = lexicon.has(word.text, WordKind::noun);
    const int own = word.can_be_singular ? count_of(lexicon, word.text, WordKind::noun) : 0;
    int of_base = 0;
    for (const std::string& base : lexicon.bases(word.text, WordKind::noun)) {
        const int count = count_of(lexicon, base, WordKind::noun);
        if (count > of_base && lexicon.has(base, WordKind::noun)) {
            of_base = count;
            word.singular = base;
        }
    }
    if (word.text == "people") {  // an entry of its own there
        word.singular = "person";
        word.can_be_singular = false;
    }
    if (of_base >= kUsualForm * own) {
        word.can_be_singular =
            false;  // "things" are some thing's plural, though an entry of their own
    }
    word.noun_count = std::max(own, of_base);
}

void read_verb(const Lexicon& lexicon, FreeWord& word) {
    if (lexicon.has(word.text, WordKind::verb)) {
        word.verb = word.text;
        word.verb_plain = true;
        word.verb_count = count_of(lexicon, word.text, WordKind::verb);
    }
    for (const std::string& base : lexicon.bases(word.text, WordKind::verb)) {
        const int count = count_of(lexicon, base, WordKind::verb);
        const bool in_s = third_person(base) == word.text;
        if (word.text.ends_with('s') && !in_s) {
            continue;  // "moones": no form of "to moon"
        }
        if (count > word.verb_count) {
            word.verb_count = count;
            word.verb = base;
            word.verb_plain = word.verb_plain && !in_s;
        }
        word.verb_in_s = word.verb_in_s || (in_s && word.verb == base);
    }
}

void read_adjective(const Lexicon& lexicon, FreeWord& word) {
    if (lexicon.has(word.text, WordKind::adjective)) {
        word.adjective = word.text;
        word.adjective_count = count_of(lexicon, word.text, WordKind::adjective);
    }
    for (const std::string& base : lexicon.bases(word.text, WordKind::adjective)) {
        for (const Degree degree : {Degree::comparative, Degree::superlative}) {
            const std::vector<std::string> forms = degree_forms(base, degree);
            const int count = count_of(lexicon, base, WordKind::adjective);
            const bool is_form = std::find(forms.begin(), forms.end(), word.text) != forms.end();
            if (is_form && (word.degree == Degree::positive || count > word.adjective_count)) {
                word.adjective = base;
                word.degree = degree;
                word.adjective_count = std::max(word.adjective_count, count);
            }
        }
    }
}

void read_adverb(const Lexicon& lexicon, FreeWord& word) {
    if (lexicon.has(word.text, WordKind::adverb)) {
        word.adverb_count = count_of(lexicon, word.text, WordKind::adverb);
    }
    if (!word.text.ends_with("ly") || word.text.size() < 5) {
        return;
    }
    const std::string stem = word.text.substr(0, word.text.size() - 2);
    for (const std::string& base : {stem, stem.substr(0, stem.size() - 1) + "y", stem + "le"}) {
        if (lexicon.has(base, WordKind::adjective)) {
            word.adverb_of = base;
            return;
        }
    }
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Decimal numbers as one word each, "9.8" and not "nine point eight": nothing is amiss between their parts.
std::vector<Token> with_decimals(std::vector<Token> tokens, std::string_view text) {
    std::vector<Token> result;
    std::size_t behind = 0;  // the last decimal
    for (Token& token : tokens) {
        if (token.begin < behind) {
            continue;  // a part of it
        }
        std::size_t end = token.begin;
        bool is_decimal = false;
        while (end < text.size() &&
               (is_digit(text[end]) || (text[end] == '.' && end > token.begin &&
                                        end + 1 < text.size() && is_digit(text[end + 1])))) {
            is_decimal = is_decimal || text[end] == '.';
            ++end;
        }
        if (is_decimal) {
            result.push_back(
                {std::string(text.substr(token.begin, end - token.begin)), token.begin, end});
            behind = end;
        } else {
            result.push_back(std::move(token));
        }
    }
    return result;
}

/// "0.5", "1.0": "metre" and "metres" are both said behind it.
bool is_at_most_one(const std::string& number) {
    const std::size_t whole = number.find_first_not_of('0');
    const std::string_view rest =
        whole == std::string::npos ? std::string_view() : std::string_view(number).substr(whole);
    return rest.empty() || rest.front() == '.' ||
           (rest.starts_with("1.") && rest.find_first_not_of('0', 2) == std::string_view::npos);
}

void read_word(const Lexicon& lexicon, FreeWord& word) {
    if (is_digit(word.text[0]) && word.text.find('.') != std::string::npos) {
        word.number = !is_at_most_one(word.text);
        word.known = true;
        return;
    }
    word.closed = is_closed_word(word.text);
    word.number = (is_number_word(word.text) || has_digits(word.text)) && word.text != "one" &&
                  word.text != "1" && word.text != "zero";
    if (word.closed || word.number || word.text.size() > 40) {
        word.known = true;
        if (word.closed) {
            read_verb(lexicon, word);  // has, does
        }
        return;
    }
    read_noun(lexicon, word);
    read_verb(lexicon, word);
    read_adjective(lexicon, word);
    read_adverb(lexicon, word);
    word.known = word.noun_count + word.verb_count + word.adjective_count + word.adverb_count > 0;
}

/// The 's of "it's" is a verb, that of "the moon's" is not.
bool is_possessive_s(const std::vector<Token>& tokens, std::size_t i, std::string_view text) {
    if (i == 0 || tokens[i].text != "is" || tokens[i].begin >= text.size() ||
        text.substr(tokens[i].begin, tokens[i].end - tokens[i].begin).size() > 4 ||
        tokens[i].begin != tokens[i - 1].end) {
        return false;
    }
    const std::string& owner = tokens[i - 1].text;
    return !is_third_singular(owner) && !is_question_word(owner) && owner != "that" &&
           owner != "there" && owner != "here" && owner != "this";
}

bool ends_sentence(std::string_view between) {
    return between.find_first_of(".?!\n") != std::string_view::npos;
}

bool is_stop(std::string_view between) {
    return between.find_first_of(",;:()\"-") != std::string_view::npos;
}

}  // namespace

bool FreeWord::mainly_noun() const {
    return !closed && !number && noun_count >= kMuchMore * (verb_count + adjective_count) &&
           noun_count > kMuchMore * adverb_count;
}

bool FreeWord::mainly_verb() const {
    return verb_count > kMuchMore * (noun_count + adjective_count);
}

bool FreeWord::mainly_adjective() const {
    return !closed && adjective_count > kMuchMore * (verb_count + noun_count) &&
           adjective_count >= adverb_count;
}

bool FreeWord::singular_noun() const {
    return mainly_noun() && can_be_singular && singular.empty() && !is_mass_noun(text) &&
           !is_collective(text);
}

bool FreeWord::plural_noun() const {
    return mainly_noun() && !singular.empty() && !can_be_singular && singular != text;
}

const FreeWord& FreeSentence::operator[](int i) const {
    static const FreeWord kNoWord{};
    return i < 0 || i >= size() ? kNoWord : words_[static_cast<std::size_t>(i)];
}

bool FreeSentence::is(int i, std::initializer_list<std::string_view> words) const {
    return std::find(words.begin(), words.end(), text(i)) != words.end();
}

bool FreeSentence::has_before(int i, std::string_view plain) const {
    return std::any_of(words_.begin(), words_.begin() + std::clamp(i, 0, size()),
                       [&](const FreeWord& word) { return word.verb == plain; });
}

bool FreeSentence::joins_clauses(int i) const {
    if (is(i, {"but", "because", "so", "if", "although", "though", "since", "then", "when"})) {
        return true;
    }
    // "As the wind gets stronger", not "as heavy as the egg", "as it is".
    const FreeWord& before = (*this)[i - 1];
    if (i == 0 && is(0, {"as"}) && is(1, {"it", "they", "we", "there"})) {
        return true;
    }
    return is(i, {"as"}) && is_central_determiner(text(i + 1)) &&
           (i == 0 || before.before_stop || before.mainly_noun() ||
            before.degree == Degree::comparative || is(i - 1, {"before"}));
}

bool FreeSentence::clause_begins(int i) const {
    if (i < 0 || i >= size()) {
        return false;
    }
    if (i == 0 || (*this)[i].behind_stop || joins_clauses(i - 1)) {
        return true;
    }
    const int teller = is(i - 1, {"that"}) ? i - 2 : i - 1;
    return teller > 0 && is_telling_verb(text(teller)) &&
           (is_other_person(text(teller - 1)) || is_third_singular(text(teller - 1)));
}

bool FreeSentence::is_head(int i) const {
    const FreeWord& next = (*this)[i + 1];
    if ((*this)[i].hyphen_behind) {
        return false;
    }
    return ends_at(i) || (next.closed && !next.possessive && next.text != "one") ||
           (next.known && next.noun_count == 0 && next.adjective_count == 0);
}

bool FreeSentence::has_verb_from(int i) const {
    for (; i < size(); ++i) {
        if (be_at(i) || is(i, {"has", "have", "does", "do"}) ||
            ((*this)[i].verb_in_s && (*this)[i].mainly_verb())) {
            return true;
        }
    }
    return false;
}

bool FreeSentence::be_at(int i) const {
    return is(i, {"is", "are", "was", "were", "am"}) && !(*this)[i].possessive;
}

namespace {

/// The one of "twenty one", with or without a hyphen: more than one.
bool ends_number(const FreeWord& word, const std::vector<FreeWord>& before) {
    if (word.text != "one" || before.empty()) {
        return false;
    }
    const bool with_and = before.back().text == "and" && before.size() > 1;
    const FreeWord& last = with_and ? before[before.size() - 2] : before.back();
    const bool hundreds = last.text == "hundred" || last.text == "thousand";
    return last.number && (with_and ? hundreds : !last.before_stop || last.hyphen_behind);
}

/// What can be counted, and is no stuff by its other name: "rock", "cloth".
bool is_thing(const FreeWord& word, std::span<const std::string> things) {
    return word.noun_count > 0 && word.can_be_singular && word.singular.empty() && !word.closed &&
           !is_material(word.text) && !is_strictly_mass(word.text) && !is_planet(word.text) &&
           std::find(things.begin(), things.end(), word.text) != things.end();
}

}  // namespace

std::vector<FreeSentence> read_sentences(const Lexicon& lexicon, std::string_view text,
                                         std::span<const std::string> things) {
    text = text.substr(0, kLongestFreeText_bytes);
    const std::vector<Token> tokens = with_decimals(tokenise(text), text);
    std::vector<FreeSentence> sentences;
    std::vector<FreeWord> words;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        FreeWord word;
        word.text = token.text;
        word.begin = token.begin;
        word.end = token.end;
        word.written = std::string(text.substr(token.begin, token.end - token.begin));
        word.capital = !word.written.empty() && word.written[0] >= 'A' && word.written[0] <= 'Z';
        word.possessive = is_possessive_s(tokens, i, text);
        read_word(lexicon, word);
        word.number = word.number || ends_number(word, words);
        word.thing = is_thing(word, things);
        const std::size_t next = i + 1 < tokens.size() ? tokens[i + 1].begin : text.size();
        const std::string_view between = text.substr(token.end, next - std::min(token.end, next));
        word.behind_stop = words.empty() || words.back().before_stop;
        const bool last = i + 1 == tokens.size() || ends_sentence(between);
        word.hyphen_behind = between == "-";
        word.before_stop = last || is_stop(between);
        words.push_back(std::move(word));
        if (last) {
            sentences.emplace_back(std::exchange(words, {}),
                                   between.find('?') != std::string_view::npos);
        }
    }
    return sentences;
}

}  // namespace fulcrum::dialogue
