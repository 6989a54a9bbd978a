// A word that is missing in a free sentence, its verb or the pronoun before it, or a pronoun said beside its noun.
#include "dialogue/checking/grammar_words.h"
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

/// A finite verb stands at `i` or behind it.
bool has_verb_from(const FreeSentence& sentence, int i) {
    for (; i < sentence.size(); ++i) {
        if (sentence.be_at(i) || sentence.is(i, {"has", "have", "does", "do"}) ||
            (sentence[i].verb_in_s && sentence[i].mainly_verb())) {
            return true;
        }
    }
    return false;
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
        sentence[i + 3].noun_count > 0 && !has_verb_from(sentence, i + 3)) {
        proposals.insert(i + 1, ErrorCode::missing_verb,
                         sentence[i + 3].plural_noun() ? "are" : "is");
        return;
    }
    if (there && sentence.is(i + 1, {"more", "less", "enough"}) && sentence[i + 2].noun_count > 0 &&
        !sentence[i + 2].plural_noun() && !has_verb_from(sentence, i)) {
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
                                   "far", "at", "on"})));
        const NounPhrase thing = noun_phrase_at(sentence, at);
        const bool verbless = i == 0 && !has_verb_from(sentence, 0) && !sentence.asks();
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
    const bool joined = sentence.joins_clauses(i - 1) && !sentence.is(i - 1, {"then", "so"});
    // "A bit bigger" is a whole answer.
    if ((i != 0 && !joined) ||
        (sentence.is(i, {"a"}) && sentence.is(i + 1, {"bit", "lot", "little"}))) {
        return;
    }
    NounPhrase subject = noun_phrase_at(sentence, i);
    if (is_planet(sentence.text(i))) {
        subject = {i, i + 1, i, true, true, Number::singular};
    }
    if (is_measured(sentence.text(i)) && sentence[i + 1].degree == Degree::comparative) {
        subject = {i, i + 1, i, false, true, Number::singular};  // "lift stronger than drag"
    }
    const int at = subject.last;
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
    // "The tallest block the metal block", "the apple heavier": no word could be a verb.
    const bool named =
        i == 0 && (subject.determined || is_planet(sentence.text(0))) && !sentence.is(0, {"no"}) &&
        // "The planets orbit the Sun".
        !(sentence[subject.head].verb_plain && sentence[subject.head - 1].plural_noun()) &&
        !sentence.asks() && subject.last < sentence.size();
    const bool equal =
        named && !has_verb_from(sentence, 0) &&
        ((sentence.is(at, {"the"}) && (sentence.is(at + 1, {"same", "most"}) ||
                                       (sentence[at + 1].degree == Degree::comparative &&
                                        sentence.is(at + 2, {"of"})) ||
                                       sentence[at + 1].degree == Degree::superlative ||
                                       noun_phrase_at(sentence, at).last == sentence.size())) ||
         (sentence.is(at, {"a", "an"}) && sentence[subject.head - 1].degree != Degree::positive &&
          noun_phrase_at(sentence, at).last == sentence.size()) ||
         (word.degree == Degree::comparative && is_physical(word.adjective) &&
          (at + 1 == sentence.size() ||
           sentence.is(at + 1, {"on", "high", "above", "near", "at", "to"}))));
    const bool the_one = sentence.is(at, {"the"}) && sentence[at + 1].degree != Degree::positive &&
                         sentence.is(at + 2, {"one"}) &&
                         (sentence.ends_at(at + 2) || sentence.is(at + 3, {"of"}));
    // "The drag the force that keeps it up".
    const bool explained = named && sentence.is(at, {"the"}) &&
                           noun_phrase_at(sentence, at).last > at &&
                           sentence.is(noun_phrase_at(sentence, at).last, {"that", "which"});
    const bool last =
        at + 1 >= sentence.size() || (sentence.is(at + 1, {"and"}) && at + 3 >= sentence.size());
    const bool plain = is_physical(word.text) && word.mainly_adjective() &&
                       word.degree == Degree::positive && last;
    const bool too = sentence.is(at, {"too"}) && is_physical(sentence[at + 1].adjective) &&
                     sentence.ends_at(at + 1) && subject.determined && !has_verb_from(sentence, i);
    const bool listed = i == 0 && !sentence.asks() && listed_adjectives(sentence, at) > 1;
    // "When the wind stronger".
    const bool grows = joined && subject.determined && word.degree == Degree::comparative &&
                       is_physical(word.adjective) && sentence.ends_at(at) && !sentence.asks();
    // "When the weight more than the lift".
    const bool outweighs = sentence.is(at, {"more", "less"}) && sentence.is(at + 1, {"than"}) &&
                           is_measured(sentence[at - 1].text) && !has_verb_from(sentence, i) &&
                           !sentence.asks();
    if (outweighs || compared || with_more || equal || superlative || the_one || plain || too || listed ||
        grows || explained) {
        proposals.insert(at, ErrorCode::missing_verb, be);
    }
}

/// The apple and the egg the same; metal and wood alike; none heavier.
void find_missing_between(const FreeSentence& sentence, Proposals& proposals) {
    const bool none_compared =
        sentence.is(0, {"none"}) &&
        ((sentence[1].degree == Degree::comparative && sentence.ends_at(1)) ||
         (sentence.is(1, {"the"}) && sentence[2].degree == Degree::superlative &&
          sentence.ends_at(2)));
    if (none_compared && !sentence.asks()) {
        proposals.insert(1, ErrorCode::missing_verb, "is");
        return;
    }
    const auto name_at = [&](int first) {
        return is_planet(sentence.text(first)) ? first + 1 : noun_phrase_at(sentence, first).last;
    };
    const int first = name_at(0);
    const int second = name_at(first + 1);
    const bool alike =
        (sentence.is(second, {"the"}) && sentence.is(second + 1, {"same"})) ||
        (sentence.is(second, {"alike", "identical", "equal"}) && sentence.ends_at(second));
    if (first > 0 && sentence.is(first, {"and"}) && second > first + 1 && alike &&
        !sentence[second - 1].before_stop && !has_verb_from(sentence, 0) && !sentence.asks()) {
        proposals.insert(second, ErrorCode::missing_verb, "are");
    }
}

/// "When we press far from it it easier", "near the pole it harder": the clause before it has no comma.
void find_missing_behind(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& word = sentence[i + 1];
    if (i > 1 && sentence.is(i, {"it"}) && !sentence[i].before_stop && !sentence.asks() &&
        word.degree == Degree::comparative && is_physical(word.adjective) &&
        (sentence.ends_at(i + 1) || sentence.is(i + 2, {"to"})) &&
        sentence.is(0, {"when", "if", "near", "at", "on", "as", "far", "close"}) &&
        !sentence[i - 1].mainly_verb() &&
        !sentence.is(i - 1, {"make", "makes", "made", "is", "get"})) {
        proposals.insert(i + 1, ErrorCode::missing_verb, "is");
    }
}

/// "Pressing far from the support easier": what one does has a verb of its own too.
void find_missing_behind_doing(const FreeSentence& sentence, Proposals& proposals) {
    const int last = sentence.size() - 1;
    const FreeWord& word = sentence[last];
    bool at_place = false;
    for (int i = 1; i < last; ++i) {
        at_place = at_place || sentence.is(i, {"near", "far", "from", "at", "on", "close"});
    }
    if (sentence.is(0, {"pushing", "pressing", "pulling", "lifting", "moving", "turning"}) &&
        at_place && word.degree == Degree::comparative && is_physical(word.adjective) &&
        !has_verb_from(sentence, 1) && !sentence.asks()) {
        proposals.insert(last, ErrorCode::missing_verb, "is");
    }
}

/// What the distance of Venus? How big the Earth?
void find_missing_in_question(const FreeSentence& sentence, Proposals& proposals) {
    const bool what = sentence.is(0, {"what", "where", "who"});
    const bool how = sentence.is(0, {"how"}) && is_physical(sentence.text(1));
    const int at = what ? 1 : 2;
    const bool named = sentence.is(at, {"the"}) || (how && is_planet(sentence.text(at)));
    if (!sentence.asks() || (!what && !how) || !named || has_verb_from(sentence, 0)) {
        return;
    }
    for (int i = at; i < sentence.size(); ++i) {
        // A verb of another kind, or none that is seen: "What the boy said?"
        if (sentence[i].verb_count > sentence[i].noun_count ||
            sentence[i].before_stop != (i + 1 == sentence.size())) {
            return;
        }
    }
    proposals.insert(at, ErrorCode::missing_verb, "is");
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
                          !sentence.ends_at(at + 1) && !has_verb_from(sentence, at + 2);
        const bool is = sentence.be_at(at + 1) && !has_verb_from(sentence, at + 2) &&
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
        find_missing_behind(sentence, i, proposals);
        find_missing_pronoun(sentence, i, proposals);
        find_said_twice(sentence, i, proposals);
        find_missing_there(sentence, i, proposals);
    }
    find_missing_between(sentence, proposals);
    find_missing_behind_doing(sentence, proposals);
    find_missing_in_question(sentence, proposals);
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
