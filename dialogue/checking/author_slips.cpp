#include "dialogue/checking/author_slips.h"

#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/english/verb.h"

#include <optional>

namespace fulcrum::dialogue {
namespace {

/// A word that is a verb rather than anything else.
bool is_rather_verb(const FreeWord& word) {
    return !word.closed && !word.thing && word.verb_count > word.noun_count &&
           word.verb_count > word.adjective_count;
}

/// Some word of [first, last) may be the sentence's verb.
bool has_finite_verb(const FreeSentence& sentence, int first, int last) {
    for (int i = first; i < last; ++i) {
        const bool helps = sentence.be_at(i) || is_modal(sentence.text(i)) ||
                           sentence.is(i, {"do", "does", "did", "have", "has", "had"});
        if (helps || is_rather_verb(sentence[i])) {
            return true;
        }
    }
    return false;
}

/// The plain form of a verb: "float", not "floats".
bool is_plain_verb(const FreeWord& word) {
    return is_rather_verb(word) && word.verb_plain && word.text == word.verb;
}

/// "Float" for "floats": said of the word at `i`.
FreeError other_word(const FreeSentence& sentence, int i, std::string_view text,
                     std::string right) {
    const FreeWord& word = sentence[i];
    return {ErrorCode::agreement, word.begin, word.end,
            std::string(text.substr(word.begin, word.end - word.begin)), std::move(right)};
}

/// "The wooden block float."
std::optional<FreeError> find_plain_verb(const FreeSentence& sentence, std::string_view text) {
    const int last = sentence.size() - 1;
    const bool is_whole = last >= 2 && sentence[last].end < text.size() &&
                          text[sentence[last].end] == '.' && is_determiner(sentence.text(0));
    if (!is_whole || !is_plain_verb(sentence[last]) || !sentence[last - 1].thing ||
        !sentence[last - 1].singular.empty() || has_finite_verb(sentence, 0, last)) {
        return std::nullopt;
    }
    return other_word(sentence, last, text, third_person(sentence.text(last)));
}

/// "Lifts the block."
std::optional<FreeError> find_missing_subject(const FreeSentence& sentence, std::string_view text) {
    const FreeWord& first = sentence[0];
    const bool has_object = sentence.is(
        1, {"the", "a", "an", "it", "them", "him", "her", "my", "your", "its", "their"});
    const bool is_told = !first.closed && first.verb_in_s && !first.verb.empty() &&
                         first.text != first.verb && !sentence.asks();
    if (!is_told || !has_object || has_finite_verb(sentence, 2, sentence.size())) {
        return std::nullopt;
    }
    std::string right = first.verb;
    if (first.capital) {
        right[0] = static_cast<char>(right[0] - 'a' + 'A');
    }
    return other_word(sentence, 0, text, std::move(right));
}

/// "Which one are light?"; but "Which one are you?" and "Which sheep are white?"
std::optional<FreeError> find_which_one_are(const FreeSentence& sentence, std::string_view text) {
    for (int i = 0; i + 3 < sentence.size(); ++i) {
        const FreeWord& noun = sentence[i + 1];
        const FreeWord& next = sentence[i + 3];
        const bool is_one = noun.text == "one" || (noun.singular_noun() && noun.singular.empty());
        const bool describes = !next.adjective.empty() &&
                               (next.adjective_count > next.noun_count || sentence.ends_at(i + 3));
        if (sentence.is(i, {"which"}) && is_one && sentence.is(i + 2, {"are", "were"}) &&
            (describes || next.text == "more")) {
            return other_word(sentence, i + 2, text, sentence.text(i + 2) == "are" ? "is" : "was");
        }
    }
    return std::nullopt;
}

/// A question whose word is followed by a plain verb, what it is about, and nothing else: "Where float the block?"
bool asks_without_do(const FreeSentence& sentence) {
    const NounPhrase about = noun_phrase_at(sentence, 2);
    return sentence.asks() && is_plain_verb(sentence[1]) &&
           is_central_determiner(sentence.text(2)) && about.first < about.last &&
           about.last == sentence.size();
}

/// "What is made the block?"
bool asks_what_is_made(const FreeSentence& sentence) {
    const NounPhrase about = noun_phrase_at(sentence, 3);
    return sentence.asks() && sentence.is(0, {"what"}) && sentence.be_at(1) &&
           sentence.is(2, {"made"}) && is_central_determiner(sentence.text(3)) &&
           about.first < about.last && about.last == sentence.size();
}

std::optional<FreeError> find_missing_do(const FreeSentence& sentence) {
    if (!sentence.is(0, {"where", "when", "how"}) || !asks_without_do(sentence)) {
        return std::nullopt;
    }
    const bool is_one = noun_phrase_at(sentence, 2).number == Number::singular;
    return FreeError{ErrorCode::missing_verb, sentence[1].begin, sentence[1].begin, "",
                     is_one ? "does" : "do"};
}

}  // namespace

std::vector<FreeError> find_author_slips(const std::vector<FreeSentence>& sentences,
                                         std::string_view text) {
    std::vector<FreeError> slips;
    for (const FreeSentence& sentence : sentences) {
        auto slip = find_plain_verb(sentence, text);
        slip = slip ? slip : find_missing_subject(sentence, text);
        slip = slip ? slip : find_which_one_are(sentence, text);
        slip = slip ? slip : find_missing_do(sentence);
        if (slip) {
            slips.push_back(std::move(*slip));
        }
    }
    return slips;
}

std::string find_doubtful_question(const std::vector<FreeSentence>& sentences,
                                   std::string_view text) {
    for (const FreeSentence& sentence : sentences) {
        if ((sentence.is(0, {"why"}) && asks_without_do(sentence)) || asks_what_is_made(sentence)) {
            const std::size_t begin = sentence[0].begin;
            return std::string(text.substr(begin, sentence[sentence.size() - 1].end - begin));
        }
    }
    return {};
}

}  // namespace fulcrum::dialogue
