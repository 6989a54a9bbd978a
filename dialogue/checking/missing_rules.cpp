// A word that is missing in a free sentence that begins with its subject, its verb or the pronoun before it, or a pronoun said beside its noun.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

bool is_subject(const FreeSentence& sentence, int i) {
    return is_third_singular(sentence.text(i)) || is_other_person(sentence.text(i));
}

std::string be_of(std::string_view pronoun) {
    return pronoun == "i" ? "am" : (is_third_singular(pronoun) ? "is" : "are");
}

/// Behind the adjectives that begin at `i` and are all that follows, "hard, smooth and slippery", with commas or without: how many they are; 0
/// where something else follows.
int listed_adjectives(const FreeSentence& sentence, int i) {
    int count = 0;
    while (i < sentence.size()) {
        if (sentence.is(i, {"and", "but", "very", "so", "too", "really", "also"})) {
            ++i;
            continue;
        }
        const FreeWord& word = sentence[i];
        if (word.closed || word.degree != Degree::positive || !is_physical(word.text) ||
            word.adjective_count == 0) {
            return 0;
        }
        ++count;
        ++i;
    }
    return count;
}

/// there no wind; there two moons.
void find_missing_after_there(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool there =
        sentence.is(i, {"there"}) && !sentence[i].before_stop &&
        (i == 0 || sentence.is(i - 1, {"because", "but"}) || sentence[i].behind_stop);
    const bool one = sentence.is(i + 1, {"no", "a", "an"});
    if (there && sentence.is(i + 1, {"not"}) &&
        sentence.is(i + 2, {"any", "a", "an", "enough", "much"}) &&
        sentence[i + 3].noun_count > 0 && !sentence.has_verb_from(i + 3)) {
        proposals.insert(i + 1, ErrorCode::missing_verb,
                         sentence[i + 3].plural_noun() ? "are" : "is");
        return;
    }
    if (there && sentence.is(i + 1, {"more", "less", "enough"}) && sentence[i + 2].noun_count > 0 &&
        !sentence[i + 2].plural_noun() && !sentence.has_verb_from(i)) {
        proposals.insert(i + 1, ErrorCode::missing_verb, "is");
        return;
    }
    if (there && (one || sentence[i + 1].number) && sentence[i + 2].noun_count > 0) {
        const bool many = !one || (sentence.is(i + 1, {"no"}) && sentence[i + 2].plural_noun());
        proposals.insert(i + 1, ErrorCode::missing_verb, many ? "are" : "is");
    }
}

/// because no wind, because not wind; because is no wind, because is more wind.
void find_missing_there(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& noun = sentence[i + 1];
    const bool because = sentence.is(i - 1, {"because"}) && !sentence[i].behind_stop;
    const bool named = !noun.closed && noun.noun_count > 0 && !noun.mainly_adjective() &&
                       noun.degree == Degree::positive;
    const bool many = noun.plural_noun();
    if (because && sentence.is(i, {"no", "not"}) && named && sentence.ends_at(i + 1) &&
        noun.noun_count > noun.verb_count) {
        const std::string there = many ? "there are" : "there is";
        if (sentence.is(i, {"no"})) {
            proposals.insert(i, ErrorCode::missing_verb, there);
        } else if (noun.mainly_noun()) {
            proposals.replace(i, ErrorCode::missing_verb, there + " no");
        }
        return;
    }
    const FreeWord& counted = sentence[i + 2];
    const bool amount = sentence.is(i + 1, {"no", "more", "less", "enough"}) &&
                        counted.mainly_noun() && !counted.possessive && sentence.is_head(i + 2) &&
                        !is_material(counted.text);
    if (because && sentence.is(i, {"is", "are"}) && amount && !sentence.asks()) {
        proposals.insert(i, ErrorCode::missing_pronoun, "there");
    }
}

/// it heavy; they very heavy; it a planet; watermelon heavier than apple; sandpaper rough.
void find_missing_verb(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (is_subject(sentence, i) && sentence.clause_begins(i) && !sentence[i].before_stop) {
        int at = i + 1;
        while (sentence.is(at, {"very", "so", "too", "really", "not", "more", "also"})) {
            ++at;
        }
        const FreeWord& word = sentence[at];
        const bool adjective =
            (i == 0 && !sentence.asks() && listed_adjectives(sentence, at) > 1) ||
            (word.mainly_adjective() && word.verb_count <= 1 + word.adjective_count / 8 &&
             (sentence.ends_at(at) ||
              sentence.is(at + 1, {"and", "than", "but", "because", "to", "when", "if", "near",
                                   "far", "at", "on"}) ||
              ((is_physical(word.adjective) || is_physical(word.text)) &&
               sentence.is(at + 1, {"where", "the", "as", "like"}))));
        const NounPhrase thing = noun_phrase_at(sentence, at);
        const bool verbless = i == 0 && !sentence.has_verb_from(0) && !sentence.asks();
        const bool noun = sentence.is(at, {"a", "an", "the"}) && i == 0 && thing.last > at &&
                          (sentence.ends_at(thing.head) ||
                           (verbless && sentence.is(thing.last, {"of", "in", "from"})) ||
                           sentence.is(thing.last, {"that", "which"})) &&
                          !sentence.is(i, {"you", "i"});
        // "It the blue one".
        const bool one = i == 0 && verbless && sentence.is(at, {"the"}) && at == i + 1 &&
                         sentence[at + 1].mainly_adjective() && sentence.is(at + 2, {"one"}) &&
                         sentence.ends_at(at + 2);
        // "It Venus", "it under the red block".
        const bool place =
            verbless && sentence.is(i, {"it"}) && at == i + 1 &&
            (is_planet(sentence.text(at)) || (sentence.is(at, {"on", "under", "between", "behind",
                                                               "above", "below", "near", "next"}) &&
                                              sentence.size() > at + 2));
        const bool number = i == 0 && sentence.is(i, {"it"}) && at == i + 1 && sentence[at].number;
        if (adjective || noun || one || number || place) {
            proposals.insert(i + 1, ErrorCode::missing_verb, be_of(sentence.text(i)));
        }
        return;
    }
    find_missing_after_there(sentence, i, proposals);
    const bool joined = (sentence.joins_clauses(i - 1) && !sentence.is(i - 1, {"then", "so"})) ||
                        sentence.is(i - 1, {"where"});
    // "A bit bigger" is a whole answer.
    if ((i != 0 && !joined) ||
        (sentence.is(i, {"a"}) && sentence.is(i + 1, {"bit", "lot", "little"}))) {
        return;
    }
    NounPhrase subject = noun_phrase_at(sentence, i);
    if (is_planet(sentence.text(i))) {
        subject = {i, i + 1, i, true, true, Number::singular};
    }
    if (is_measured(sentence.text(i)) && (sentence[i + 1].degree == Degree::comparative ||
                                          sentence.is(i + 1, {"more", "less", "the"}))) {
        subject = {i, i + 1, i, false, true, Number::singular};  // "lift stronger than drag"
    }
    // "The force of the weight".
    const NounPhrase owner = noun_phrase_at(sentence, subject.last + 1);
    const bool is_owned = subject.determined && sentence.is(subject.last, {"of"}) &&
                          owner.last > owner.first && !sentence[subject.last - 1].before_stop;
    const int at = is_owned ? owner.last : subject.last;
    if (at == i || sentence[at - 1].before_stop) {
        return;
    }
    const FreeWord& word = sentence[at];
    const std::string be = subject.number == Number::plural ? "are" : "is";
    const bool compared = word.degree == Degree::comparative && sentence.is(at + 1, {"than"}) &&
                          word.adjective_count > 0 && !word.before_stop;
    const bool with_more = sentence.is(at, {"more"}) && sentence[at + 1].adjective_count > 0 &&
                           (sentence.is(at + 2, {"than", "to"}) || sentence.ends_at(at + 1));
    const bool superlative =
        sentence.is(at, {"the"}) &&
        (sentence[at + 1].degree == Degree::superlative ||
         sentence.is(at + 1, {"most", "least"})) &&
        sentence.ends_at(sentence.is(at + 1, {"most", "least"}) ? at + 2 : at + 1);
    // "Weight stronger", "wood the harder of the two".
    const bool is_bare =
        subject.last == i + 1 && (is_measured(sentence.text(i)) || is_material(sentence.text(i)));
    // "The tallest block the metal block", "the apple heavier": no word could be a verb.
    const bool named =
        i == 0 && (subject.determined || is_planet(sentence.text(0)) || is_bare) &&
        !sentence.is(0, {"no"}) &&
        // "The planets orbit the Sun".
        !(sentence[subject.head].verb_plain && sentence[subject.head - 1].plural_noun()) &&
        !sentence.asks() && subject.last < sentence.size();
    const bool equal =
        named && !sentence.has_verb_from(0) &&
        ((sentence.is(at, {"the"}) &&
          (sentence.is(at + 1, {"same", "most"}) ||
           (sentence[at + 1].degree == Degree::comparative && sentence.is(at + 2, {"of"})) ||
           sentence[at + 1].degree == Degree::superlative ||
           // "Lift the knot."
           (noun_phrase_at(sentence, at).last == sentence.size() &&
            (!is_bare || sentence.is(sentence.size() - 1, {"force"}))))) ||
         (sentence.is(at, {"a", "an"}) && sentence[subject.head - 1].degree != Degree::positive &&
          noun_phrase_at(sentence, at).last == sentence.size()) ||
         (word.degree == Degree::comparative && is_physical(word.adjective) &&
          (at + 1 == sentence.size() ||
           sentence.is(at + 1, {"on", "high", "above", "near", "at", "to", "far", "close", "now",
                                "then", "there"}))) ||
         (is_planet(sentence.text(i)) &&
          sentence.is(at, {"closer", "nearer", "farther", "further"})));
    const int one_at = sentence.is(at + 1, {"more", "most"}) ? at + 3 : at + 2;
    const bool the_one = sentence.is(at, {"the"}) &&
                         (one_at == at + 3 || sentence[at + 1].degree != Degree::positive) &&
                         sentence.is(one_at, {"one"}) &&
                         (sentence.ends_at(one_at) || sentence.is(one_at + 1, {"of"}));
    // "The drag the force that keeps it up".
    const bool explained = named && sentence.is(at, {"the"}) &&
                           noun_phrase_at(sentence, at).last > at &&
                           sentence.is(noun_phrase_at(sentence, at).last, {"that", "which"});
    const bool last =
        at + 1 >= sentence.size() || (sentence.is(at + 1, {"and"}) && at + 3 >= sentence.size());
    const bool plain = is_physical(word.text) && word.mainly_adjective() &&
                       word.degree == Degree::positive &&
                       (last || (i == 0 && sentence.is(at + 1, {"like"})));
    const bool too = sentence.is(at, {"too"}) && is_physical(sentence[at + 1].adjective) &&
                     sentence.ends_at(at + 1) && subject.determined && !sentence.has_verb_from(i);
    const bool listed = i == 0 && !sentence.asks() && listed_adjectives(sentence, at) > 1;
    // "When the wind stronger", "where my arm long".
    const bool grows = joined && subject.determined && !sentence.asks() &&
                       (word.degree == Degree::comparative ? is_physical(word.adjective)
                                                           : sentence.is(at, {"long", "short"})) &&
                       sentence.ends_at(at);
    // "When the weight more than the lift".
    const bool outweighs = sentence.is(at, {"more", "less"}) && sentence.is(at + 1, {"than"}) &&
                           is_measured(sentence[at - 1].text) && !sentence.has_verb_from(i) &&
                           !sentence.asks();
    if (outweighs || compared || with_more || equal || superlative || the_one || plain || too ||
        listed || grows || explained) {
        proposals.insert(at, ErrorCode::missing_verb, be);
    }
}

/// "is very important", "is made of metal": without "it".
void find_missing_pronoun(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool start = i == 0 || sentence.is(i - 1, {"because", "but"});
    if (!start || !sentence.is(i, {"is", "are", "was", "were"}) || sentence.asks() ||
        sentence[i].before_stop || sentence[i].possessive) {
        return;
    }
    const bool very = sentence.is(i + 1, {"very", "so", "too", "not", "really"});
    const FreeWord& word = sentence[very ? i + 2 : i + 1];
    const int at = very ? i + 2 : i + 1;
    const bool made = sentence.is(i + 1, {"made"}) && sentence.is(i + 2, {"of", "from", "out"});
    const bool adjective =
        word.mainly_adjective() &&
        (sentence.ends_at(at) || sentence.is(at + 1, {"and", "because", "to", "for", "than"}));
    const bool more = sentence.is(i + 1, {"more"}) && sentence[i + 2].adjective_count > 0 &&
                      !sentence[i + 2].mainly_noun() &&
                      sentence.is(i + 3, {"to", "than", "when", "if"});
    const bool compared = word.degree == Degree::comparative && is_physical(word.adjective) &&
                          !sentence[at + 1].mainly_noun();
    // "Is the blue one.", "Is wood.": nothing else follows.
    const NounPhrase named = noun_phrase_at(sentence, i + 1);
    const bool whole =
        i == 0 && sentence.is(i, {"is"}) &&
        ((sentence.is(i + 1, {"the", "a", "an"}) && named.last > i + 1 &&
          (named.last == sentence.size() ||
           sentence.is(named.last, {"of", "in", "from", "that", "which"}))) ||
         (sentence.size() == 2 && (is_material(sentence.text(1)) || is_planet(sentence.text(1)))));
    const bool listed = i == 0 && listed_adjectives(sentence, i + 1) > 1;
    if (made || adjective || more || compared || whole || listed) {
        const bool plural = sentence.is(i, {"are", "were"});
        proposals.insert(i, ErrorCode::missing_pronoun, plural ? "they" : "it");
    }
}

/// the rock it is hard; the lift it pulls the kite.
void find_said_twice(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (i != 0 && (!sentence.joins_clauses(i - 1) || sentence.is(i - 1, {"then", "so"}))) {
        return;
    }
    const NounPhrase subject = noun_phrase_at(sentence, i);
    const int at = subject.last;
    if (at > i && sentence.is(at, {"it", "they"}) && !sentence[at - 1].before_stop &&
        !sentence.asks() &&
        (is_material(sentence.text(i)) || is_central_determiner(sentence.text(i)) ||
         sentence.is(i, {"this", "that"})) &&
        !is_time_or_amount(sentence[subject.head].text)) {
        const FreeWord& verb = sentence[at + 1];
        const bool acts = verb.verb_in_s && !verb.closed && verb.verb_count > verb.noun_count &&
                          !sentence.ends_at(at + 1) && !sentence.has_verb_from(at + 2);
        const bool is = sentence.be_at(at + 1) && !sentence.has_verb_from(at + 2) &&
                        (is_physical(sentence[at + 2].adjective) ||
                         sentence.is(at + 2, {"more", "between", "under", "on", "not"}));
        if (acts || is) {
            proposals.replace(at, ErrorCode::extra_pronoun, "");
            return;
        }
    }
    if (i != 0) {
        return;
    }
    if (at == 0 || sentence[at - 1].before_stop || is_time_or_amount(sentence[subject.head].text)) {
        return;
    }
    const bool again = sentence.is(at, {"it", "they", "he", "she"}) && sentence.be_at(at + 1);
    const int first = sentence.is(at + 2, {"a", "an", "the", "very", "made"}) ? at + 3 : at + 2;
    const FreeWord& word = sentence[first];
    const bool whole =
        sentence.is(at + 2, {"made"}) ||
        ((word.adjective_count > 0 && word.mainly_adjective()) || word.degree != Degree::positive);
    if (again && whole && !sentence.asks()) {
        proposals.replace(at, ErrorCode::extra_pronoun, "");
    }
}

}  // namespace

void find_missing_words(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_missing_verb(sentence, i, proposals);
        find_missing_pronoun(sentence, i, proposals);
        find_said_twice(sentence, i, proposals);
        find_missing_there(sentence, i, proposals);
    }
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
