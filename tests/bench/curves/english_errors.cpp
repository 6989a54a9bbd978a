#include "tests/bench/curves/english_errors.h"

#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/reading.h"
#include "dialogue/english/making.h"

#include <array>
#include <string_view>
#include <utility>

namespace fulcrum::bench {
namespace {

using namespace fulcrum::dialogue;

/// Writes spoilt copies of one sentence.
class Spoiler {
  public:
    Spoiler(const std::string& text, const FreeSentence& sentence)
        : text_(text), sentence_(sentence) {}

    /// Words [first, last) become `wrong`; nothing: they go, with the blank behind them.
    void spoil(int first, int last, ErrorCode code, const std::string& wrong) {
        const std::size_t begin = sentence_[first].begin;
        std::size_t end = first == last ? begin : sentence_[last - 1].end;  // put before it
        if (first < last && wrong.empty() && last < sentence_.size()) {
            end = sentence_[last].begin;
        }
        std::string spoilt = text_.substr(0, begin) + wrong + text_.substr(end);
        if (begin == 0 && !spoilt.empty() && spoilt[0] >= 'a' && spoilt[0] <= 'z') {
            spoilt[0] = static_cast<char>(spoilt[0] - 'a' + 'A');
        }
        made_.push_back(
            {std::move(spoilt), std::string(errant_code(code)), begin, begin + wrong.size()});
    }
    [[nodiscard]] std::vector<ErroneousSentence> take() { return std::move(made_); }

  private:
    const std::string& text_;
    const FreeSentence& sentence_;
    std::vector<ErroneousSentence> made_;
};

/// more heavier, heavyer, most heaviest; than -> then.
void spoil_degree(const FreeSentence& sentence, int i, Spoiler& spoiler) {
    const FreeWord& word = sentence[i];
    if (word.degree != Degree::positive && is_physical(word.adjective)) {
        for (const LearnerForm& form : learner_forms(word.adjective, word.degree)) {
            // "Heavyest" for "heaviest"; another degree is good English for another meaning.
            if (form.slip < 3) {
                spoiler.spoil(i, i + 1, form.code, form.text);
            }
        }
        if (sentence.is(i + 1, {"than"})) {
            spoiler.spoil(i, i + 1, ErrorCode::adjective_form, word.adjective);
            spoiler.spoil(i + 1, i + 2, ErrorCode::wrong_preposition, "then");
            spoiler.spoil(i, i, ErrorCode::wrong_adverb, "very ");
        }
        if (word.degree == Degree::superlative && sentence.is(i - 1, {"the"}) && i > 1) {
            spoiler.spoil(i - 1, i, ErrorCode::missing_determiner, "");
        }
    }
}

/// "Lift is bigger than weight": good English without an article, unless it is said whose ("the weight of the line").
bool is_measured(const FreeSentence& sentence, int i) {
    return sentence.is(i, {"weight", "lift", "drag", "tension", "torque"}) &&
           !sentence.is(i + 1, {"of"});
}

void spoil_article(const FreeSentence& sentence, int i, Spoiler& spoiler) {
    if (!sentence.is(i, {"a", "an", "the"})) {
        if (is_planet(sentence.text(i)) && !is_determiner(sentence.text(i - 1))) {
            spoiler.spoil(i, i, ErrorCode::extra_determiner, "the ");
        }
        return;
    }
    if (!sentence.is(i, {"the"})) {
        spoiler.spoil(i, i + 1, ErrorCode::wrong_determiner, sentence.is(i, {"a"}) ? "an" : "a");
    }
    const FreeWord& noun = sentence[i + 1];
    if (noun.singular_noun() && !noun.capital && !is_material(noun.text) &&
        sentence.is_head(i + 1) && !is_measured(sentence, i + 1)) {
        spoiler.spoil(i, i + 1, ErrorCode::missing_determiner, "");
    }
    if (!sentence.is(i, {"the"}) && noun.mainly_adjective() && sentence[i + 2].singular_noun() &&
        sentence.ends_at(i + 2) && i > 1) {
        spoiler.spoil(i, i + 3, ErrorCode::word_order,
                      std::string(indefinite_article(sentence.text(i + 2))) + " " +
                          sentence.text(i + 2) + " " + noun.text);
    }
}

void spoil_number(const FreeSentence& sentence, int i, Spoiler& spoiler) {
    const FreeWord& word = sentence[i];
    if (!word.plural_noun() || word.singular.size() < 3) {
        return;
    }
    if (sentence[i - 1].number || sentence.is(i - 1, {"many"})) {
        spoiler.spoil(i, i + 1, ErrorCode::noun_number, word.singular);
    }
    for (const std::string& wrong : learner_plurals(word.singular)) {
        spoiler.spoil(i, i + 1, ErrorCode::noun_inflection, wrong);
    }
    if (sentence.is(i - 1, {"many"})) {
        spoiler.spoil(i - 1, i, ErrorCode::wrong_determiner, "much");
    }
}

void spoil_verb(const FreeSentence& sentence, int i, Spoiler& spoiler) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kPairs = {
        {{"is", "are"}, {"has", "have"}, {"does", "do"}, {"was", "were"}}};
    const FreeWord& verb = sentence[i];
    const bool subject_before =
        i > 0 && (sentence[i - 1].noun_count > 0 || is_planet(sentence.text(i - 1)) ||
                  is_third_singular(sentence.text(i - 1)) ||
                  sentence.is(i - 1, {"they", "there", "you", "we", "i"}));
    if (sentence.asks() || !subject_before || verb.possessive) {
        return;
    }
    for (const auto& [one, many] : kPairs) {
        if (verb.text == one || verb.text == many) {
            spoiler.spoil(i, i + 1, ErrorCode::agreement,
                          std::string(verb.text == one ? many : one));
        }
    }
    if (verb.verb_in_s && verb.mainly_verb() && !verb.closed) {
        spoiler.spoil(i, i + 1, ErrorCode::agreement, verb.verb);
    }
    const bool predicate = sentence[i + 1].mainly_adjective() ||
                           sentence.is(i + 1, {"made", "the", "very", "more"}) ||
                           sentence[i + 1].degree != Degree::positive;
    if (sentence.be_at(i) && predicate) {
        spoiler.spoil(i, i + 1, ErrorCode::missing_verb, "");
    }
    if (is_third_singular(sentence.text(i - 1)) && sentence.be_at(i) && i == 1 && predicate) {
        spoiler.spoil(0, 1, ErrorCode::missing_pronoun, "");
    }
    if (sentence.be_at(i) && sentence[i - 1].noun_count > 0 &&
        is_physical(sentence[i + 1].adjective)) {
        spoiler.spoil(i, i, ErrorCode::extra_pronoun, verb.text == "are" ? "they " : "it ");
    }
}

void spoil_making(const FreeSentence& sentence, int i, Spoiler& spoiler) {
    if (!sentence.is(i, {"made"}) || !sentence.is(i + 1, {"of"}) ||
        !is_material(sentence.text(i + 2))) {
        return;
    }
    spoiler.spoil(i + 1, i + 2, ErrorCode::wrong_preposition, "by");
    spoiler.spoil(i + 1, i + 2, ErrorCode::missing_preposition, "");
    spoiler.spoil(i + 2, i + 2, ErrorCode::extra_determiner, "a ");
    if (sentence.be_at(i - 1)) {
        for (const LearnerVerb& wrong : learner_participles()) {
            spoiler.spoil(i, i + 1, wrong.code, wrong.text);
        }
        spoiler.spoil(i - 1, i + 1, ErrorCode::verb_voice, "makes");
    }
}

void spoil_adjective(const FreeSentence& sentence, int i, Spoiler& spoiler) {
    const FreeWord& word = sentence[i];
    const bool linked = sentence.be_at(i - 1) || is_linking_verb(sentence[i - 1].verb);
    if (!linked || word.degree != Degree::positive || !is_physical(word.text) ||
        !sentence.ends_at(i) || i < 2) {
        return;
    }
    for (const LearnerForm& form : learner_forms(word.text, Degree::positive)) {
        if (form.code == ErrorCode::morphology && form.text.find(' ') == std::string::npos) {
            spoiler.spoil(i, i + 1, form.code, form.text);
        }
    }
    spoiler.spoil(i, i, ErrorCode::extra_determiner, "a ");
    if (!sentence.be_at(i - 1)) {
        spoiler.spoil(i, i, ErrorCode::extra_preposition, "like ");
    }
}

}  // namespace

std::vector<ErroneousSentence> spoil(const Lexicon& lexicon, const std::string& text) {
    const std::vector<FreeSentence> sentences = read_sentences(lexicon, text);
    if (sentences.size() != 1) {
        return {};
    }
    const FreeSentence& sentence = sentences.front();
    Spoiler spoiler(text, sentence);
    for (int i = 0; i < sentence.size(); ++i) {
        spoil_degree(sentence, i, spoiler);
        spoil_article(sentence, i, spoiler);
        spoil_number(sentence, i, spoiler);
        spoil_verb(sentence, i, spoiler);
        spoil_making(sentence, i, spoiler);
        spoil_adjective(sentence, i, spoiler);
    }
    return spoiler.take();
}

}  // namespace fulcrum::bench
