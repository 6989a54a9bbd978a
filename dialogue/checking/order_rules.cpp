// Errors of a sentence's parts: their order, a verb or pronoun that is missing or said twice, an adverb for an adjective.
#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/proposal.h"
#include "dialogue/english/letters.h"

#include <algorithm>
#include <array>

// Each rule is one chain of conditions, told in the order in which the grammar has them.
// NOLINTBEGIN(readability-function-cognitive-complexity,bugprone-branch-clone)
namespace fulcrum::dialogue {
namespace {

/// Adverbs that stand behind "is" in good English.
constexpr auto kSentenceAdverbs = std::to_array<std::string_view>(
    {"really",   "probably", "exactly",  "actually",   "definitely", "finally", "differently",
     "strongly", "badly",    "mostly",   "certainly",  "only",       "surely",  "usually",
     "clearly",  "simply",   "totally",  "deeply",     "likely",     "early",   "daily",
     "fully",    "nearly",   "possibly", "especially", "poorly",     "online",  "absolutely"});

/// "Make the box heavy", "paint the door red": the adjective is right behind its noun.
constexpr auto kTurnInto = std::to_array<std::string_view>(
    {"make", "paint", "find", "keep",  "get",    "leave", "turn",  "consider",
     "have", "want",  "like", "drive", "call",   "hold",  "color", "colour",
     "wash", "dye",   "see",  "feel",  "prefer", "need"});

/// metal feels hardly; the metal is hardness; feels like hard.
void find_adverb(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool linking =
        is_linking_verb(sentence[i].verb) && !sentence[i].closed && sentence[i].verb != "appear";
    if ((!sentence.be_at(i) && !linking) || sentence[i].before_stop || i == 0) {
        return;
    }
    const int at = sentence.is(i + 1, {"very", "so", "too", "quite"}) ? i + 2 : i + 1;
    const FreeWord& word = sentence[at];
    const bool listed = std::find(kSentenceAdverbs.begin(), kSentenceAdverbs.end(), word.text) !=
                        kSentenceAdverbs.end();
    const bool alone = sentence.ends_at(at) || sentence.is(at + 1, {"and", "but"});
    if (alone && !word.adverb_of.empty() && !listed && word.adjective.empty() &&
        (is_physical(word.adverb_of) || !linking)) {
        proposals.replace(at, ErrorCode::morphology, word.adverb_of);
        return;
    }
    const bool of_thing =
        sentence[i - 1].mainly_noun() || (linking && is_third_singular(sentence.text(i - 1)));
    if (word.text.ends_with("ness") && alone && word.text.size() > 6 && of_thing) {
        std::string base = word.text.substr(0, word.text.size() - 4);
        if (base.ends_with('i')) {
            base.back() = 'y';
        }
        if (is_physical(base)) {
            proposals.replace(at, ErrorCode::morphology, base);
        }
        return;
    }
    const bool rare =
        !word.known || (word.noun_count <= 1 && word.adjective.empty() && word.verb.empty());
    if (rare && alone && word.text.size() > 4 &&
        (word.text.ends_with('y') || word.text.ends_with('s'))) {
        std::string base = word.text.substr(0, word.text.size() - 1);
        if (base.ends_with('e') && is_physical(base.substr(0, base.size() - 1) + "y")) {
            proposals.replace(at, ErrorCode::spelling, base.substr(0, base.size() - 1) + "y");
        } else if (is_physical(base)) {
            proposals.replace(at, ErrorCode::morphology, base);  // "smoothy", "roughs"
        }
        return;
    }
    const bool like = linking && sentence.is(i + 1, {"like"}) &&
                      sentence[i + 2].mainly_adjective() &&
                      is_physical(sentence[i + 2].adjective) &&
                      (sentence.ends_at(i + 2) || sentence.is(i + 3, {"and", "but"})) &&
                      sentence[i + 2].noun_count <= 1 + sentence[i + 2].adjective_count / 4;
    if (like) {
        proposals.replace(i + 1, ErrorCode::extra_preposition, "");
    }
}

/// a rock hard, the rock hard is.
void find_adjective_behind(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& noun = sentence[i];
    const FreeWord& adjective = sentence[i + 1];
    const bool fits = noun.singular_noun() && !noun.before_stop &&
                      is_physical(adjective.adjective) && adjective.mainly_adjective() &&
                      !is_time_or_amount(noun.text);
    const bool measure = sentence.is(
        i + 1, {"long", "tall", "wide", "deep", "old", "high", "thick", "full", "free", "light"});
    if (!fits || measure) {
        return;
    }
    const bool indefinite =
        sentence.is(i - 1, {"a", "an"}) && !sentence.is(i - 2, {"such", "half"});
    const bool before_verb = sentence.is(i - 1, {"the"}) && sentence.be_at(i + 2) &&
                             sentence.clause_begins(i - 1) && !sentence.asks();
    for (int at = 0; at < i; ++at) {
        if (std::find(kTurnInto.begin(), kTurnInto.end(), sentence[at].verb) != kTurnInto.end() &&
            sentence[at].verb != "feel" && sentence[at].verb != "see") {
            return;
        }
    }
    if ((indefinite && sentence.ends_at(i + 1) && i > 1) || before_verb) {
        const std::string_view article =
            indefinite ? indefinite_article(adjective.text) : std::string_view("the");
        std::string right(article);
        right += " " + adjective.text + " " + noun.text;
        proposals.replace(i - 1, i + 2, ErrorCode::word_order, right);
    }
}

/// Why the rock is heavy? What it is? How many moons Jupiter has?
void find_straight_question(const FreeSentence& sentence, Proposals& proposals) {
    if (!sentence.asks() || !is_question_word(sentence.text(0)) || sentence[0].before_stop) {
        return;
    }
    const bool what = sentence.is(0, {"what", "who"});
    const bool pronoun = is_third_singular(sentence.text(1)) || is_other_person(sentence.text(1)) ||
                         (sentence.is(1, {"this", "that"}) && sentence.be_at(2));
    const NounPhrase phrase = noun_phrase_at(sentence, 1);
    const int last = pronoun ? 2 : phrase.last;
    const bool whose =
        pronoun || (!what && sentence.is(0, {"why", "where", "when", "how"}) &&
                    phrase.first < phrase.last && is_central_determiner(sentence.text(1)));
    const bool helper =
        sentence.be_at(last) || (is_modal(sentence.text(last)) && !sentence.is(last, {"ll"}));
    if (!whose || !helper || sentence.is(0, {"whose", "which"}) ||
        sentence[last].begin == sentence[last - 1].end) {
        return;
    }
    std::string right = sentence.text(last);
    for (int i = 1; i < last; ++i) {
        right += " " + (sentence[i].closed && sentence.text(i) != "i" ? sentence.text(i)
                                                                      : sentence[i].written);
    }
    proposals.replace(1, last + 1, ErrorCode::word_order, right);
}

/// How many moons Jupiter has?
void find_how_many(const FreeSentence& sentence, Proposals& proposals) {
    if (!sentence.is(0, {"how"}) || !sentence.is(1, {"many", "much"}) ||
        !sentence.is(sentence.size() - 1, {"has", "have"})) {
        return;
    }
    const int last = sentence.size() - 1;
    int first = last - 1;
    const bool determined = first > 2 && is_determiner(sentence.text(first - 1));
    first -= determined ? 1 : 0;
    const bool named = determined || sentence[first].capital ||
                       is_third_singular(sentence.text(first)) ||
                       is_other_person(sentence.text(first)) || is_planet(sentence.text(first));
    if (first < 3 || !named || sentence.is(first - 1, {"does", "do", "did"})) {
        return;
    }
    std::string right = sentence[last].text == "has" ? "does" : "do";
    for (int i = first; i < last; ++i) {
        right += " " + sentence[i].written;
    }
    proposals.replace(first, last + 1, ErrorCode::word_order, right + " have");
}

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

/// there no wind; there two moons.
void find_missing_after_there(const FreeSentence& sentence, int i, Proposals& proposals) {
    const bool there =
        sentence.is(i, {"there"}) && !sentence[i].before_stop &&
        (i == 0 || sentence.is(i - 1, {"because", "but"}) || sentence[i].behind_stop);
    const bool one = sentence.is(i + 1, {"no", "a", "an"});
    if (there && (one || sentence[i + 1].number) && sentence[i + 2].noun_count > 0) {
        const bool many = !one || (sentence.is(i + 1, {"no"}) && sentence[i + 2].plural_noun());
        proposals.insert(i + 1, ErrorCode::missing_verb, many ? "are" : "is");
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
            word.mainly_adjective() && word.verb_count <= 1 + word.adjective_count / 8 &&
            (sentence.ends_at(at) || sentence.is(at + 1, {"and", "than", "but", "because", "to",
                                                          "when", "if", "near", "far"}));
        const NounPhrase thing = noun_phrase_at(sentence, at);
        const bool noun = sentence.is(at, {"a", "an", "the"}) && i == 0 && thing.last > at &&
                          sentence.ends_at(thing.head) && !sentence.is(i, {"you", "i"});
        const bool number = i == 0 && sentence.is(i, {"it"}) && at == i + 1 && sentence[at].number;
        if (adjective || noun || number) {
            proposals.insert(i + 1, ErrorCode::missing_verb, be_of(sentence.text(i)));
        }
        return;
    }
    find_missing_after_there(sentence, i, proposals);
    if (i != 0 && !sentence.is(i - 1, {"because", "but"})) {
        return;
    }
    NounPhrase subject = noun_phrase_at(sentence, i);
    if (is_planet(sentence.text(i))) {
        subject = {i, i + 1, i, true, true, Number::singular};
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
        (sentence[at + 1].degree == Degree::superlative || sentence.is(at + 1, {"most"})) &&
        sentence.ends_at(sentence.is(at + 1, {"most"}) ? at + 2 : at + 1);
    // "The tallest block the metal block", "the apple heavier": no word could be a verb.
    const bool named = i == 0 && (subject.determined || is_planet(sentence.text(0))) &&
                       !sentence.asks() && subject.last < sentence.size();
    const bool equal =
        named && !has_verb_from(sentence, 0) &&
        ((sentence.is(at, {"the"}) && (sentence.is(at + 1, {"same"}) ||
                                       noun_phrase_at(sentence, at).last == sentence.size())) ||
         (word.degree == Degree::comparative && is_physical(word.adjective) &&
          at + 1 == sentence.size()));
    const bool the_one = sentence.is(at, {"the"}) && sentence[at + 1].degree != Degree::positive &&
                         sentence.is(at + 2, {"one"}) && sentence.ends_at(at + 2);
    const bool last =
        at + 1 >= sentence.size() || (sentence.is(at + 1, {"and"}) && at + 3 >= sentence.size());
    const bool plain = is_physical(word.text) && word.mainly_adjective() &&
                       word.degree == Degree::positive && last;
    if (compared || with_more || equal || superlative || the_one || plain) {
        proposals.insert(at, ErrorCode::missing_verb, be);
    }
}

/// far of the support, near of it; want know.
void find_place_words(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (sentence[i].before_stop) {
        return;
    }
    if (sentence.is(i, {"far", "further", "farther"}) && sentence.is(i + 1, {"of"})) {
        proposals.replace(i + 1, ErrorCode::wrong_preposition, "from");
    }
    const FreeWord& next = sentence[i + 1];
    if (sentence.is(i, {"want", "wants"}) && next.mainly_verb() && next.verb_plain &&
        !next.verb_in_s) {
        proposals.insert(i + 1, ErrorCode::missing_preposition, "to");
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
    const bool made = sentence.is(i + 1, {"made"}) && sentence.is(i + 2, {"of", "from"});
    const bool adjective =
        word.mainly_adjective() &&
        (sentence.ends_at(at) || sentence.is(at + 1, {"and", "because", "to", "for", "than"}));
    const bool more = sentence.is(i + 1, {"more"}) && sentence[i + 2].adjective_count > 0 &&
                      !sentence[i + 2].mainly_noun() &&
                      sentence.is(i + 3, {"to", "than", "when", "if"});
    const bool compared = word.degree == Degree::comparative && is_physical(word.adjective) &&
                          !sentence[at + 1].mainly_noun();
    if (made || adjective || more || compared) {
        const bool plural = sentence.is(i, {"are", "were"});
        proposals.insert(i, ErrorCode::missing_pronoun, plural ? "they" : "it");
    }
}

/// the rock it is hard; the lift it pulls the kite.
void find_said_twice(const FreeSentence& sentence, int i, Proposals& proposals) {
    if (i != 0 && !sentence.is(i - 1, {"because"})) {
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

void find_order_errors(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_adverb(sentence, i, proposals);
        find_adjective_behind(sentence, i, proposals);
        find_missing_verb(sentence, i, proposals);
        find_missing_pronoun(sentence, i, proposals);
        find_place_words(sentence, i, proposals);
        find_said_twice(sentence, i, proposals);
    }
    find_straight_question(sentence, proposals);
    find_how_many(sentence, proposals);
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
