// Errors of a sentence's parts: their order, an adverb or a noun for an adjective.
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

/// Of those, what goes with a comparative before its noun alone.
constexpr auto kHaveOrWant = std::to_array<std::string_view>({"have", "want", "need"});

/// feels roughs, metal is smooths, wood feels hardy, rubber is stick. `felt`: of a material, or behind "feels", nothing but an
/// adjective can stand there.
bool find_spoilt_adjective(const FreeSentence& sentence, int at, bool felt, Proposals& proposals) {
    const FreeWord& word = sentence[at];
    const bool rare =
        !word.known || (word.noun_count <= 1 && word.adjective.empty() && word.verb.empty());
    const bool ends = word.text.ends_with('y') || word.text.ends_with('s');
    const bool alone = sentence.ends_at(at) || sentence.is(at + 1, {"and", "but"});
    if (word.text.size() < 5 || !alone || is_physical(word.text)) {
        return false;
    }
    if (felt && is_physical(word.text + "y")) {
        proposals.replace(at, ErrorCode::morphology, word.text + "y");
        return true;
    }
    if (!ends || !(rare || felt)) {
        return false;
    }
    const std::string base = word.text.substr(0, word.text.size() - 1);
    if (rare && base.ends_with('e') && is_physical(base.substr(0, base.size() - 1) + "y")) {
        proposals.replace(at, ErrorCode::spelling, base.substr(0, base.size() - 1) + "y");
    } else if (is_physical(base)) {
        proposals.replace(at, ErrorCode::morphology, base);  // "smoothy", "roughs"
    }
    return true;
}

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
    // "Rock feels smoothness": a verb too, so no noun for sure.
    const bool of_material = is_material(sentence.text(i - 1));
    const bool of_thing = sentence[i - 1].mainly_noun() || of_material ||
                          (linking && (is_third_singular(sentence.text(i - 1)) ||
                                       sentence.is(i - 1, {"this", "that", "one"})));
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
    if (find_spoilt_adjective(sentence, at, alone && (linking || of_material), proposals)) {
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
    // "The bowl heavier is than the egg" has its verb behind that (find_be_behind_degree).
    const bool before_verb = sentence.is(i - 1, {"the"}) && sentence.be_at(i + 2) &&
                             !sentence.is(i + 3, {"than"}) && sentence.clause_begins(i - 1) &&
                             !sentence.asks();
    const bool compared = adjective.degree == Degree::comparative;
    for (int at = 0; at < i; ++at) {
        // "It needs a tail shorter", "you have to use a cloth lighter": these turn nothing into what is compared.
        if (compared && std::find(kHaveOrWant.begin(), kHaveOrWant.end(), sentence[at].verb) !=
                            kHaveOrWant.end()) {
            continue;
        }
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

/// it the apple is, it of metal made is: the verb at the end.
void find_verb_last(const FreeSentence& sentence, Proposals& proposals) {
    const int last = sentence.size() - 1;
    const NounPhrase named = noun_phrase_at(sentence, 1);
    if (sentence.is(0, {"it", "this"}) && sentence.is(last, {"is", "was"}) && !sentence.asks() &&
        named.determined && named.last == last && is_central_determiner(sentence.text(1)) &&
        !sentence[last].possessive && !sentence[0].before_stop) {
        std::string right = sentence.text(last);
        for (int i = 1; i < last; ++i) {
            right += " " + sentence[i].written;
        }
        proposals.replace(1, last + 1, ErrorCode::word_order, right);
    }
}

/// is of metal made.
void find_made_last(const FreeSentence& sentence, int i, Proposals& proposals) {
    const std::string& material = sentence.text(i + 1);
    if (sentence.be_at(i - 1) && sentence.is(i, {"of"}) && is_material(material) &&
        sentence.is(i + 2, {"made"}) && sentence.ends_at(i + 2)) {
        proposals.replace(i, i + 3, ErrorCode::word_order, "made of " + material);
    }
}

/// the bowl heavier is than the egg; the bowl the heaviest is.
void find_be_behind_degree(const FreeSentence& sentence, int i, Proposals& proposals) {
    const FreeWord& word = sentence[i];
    const NounPhrase subject = noun_phrase_at(sentence, 0);
    const bool the = sentence.is(i - 1, {"the"});
    const int first = the ? i - 1 : i;
    if (word.closed || word.adjective_count <= word.noun_count || !sentence.be_at(i + 1) ||
        sentence.asks() || subject.last != first || subject.first == subject.last) {
        return;
    }
    const bool compared = word.degree == Degree::comparative && sentence.is(i + 2, {"than"});
    const bool most = word.degree == Degree::superlative && the && sentence.ends_at(i + 1);
    if (compared || most) {
        proposals.replace(first, i + 2, ErrorCode::word_order,
                          sentence.text(i + 1) + (the ? " the " : " ") + word.text);
    }
}

/// it is the lift what holds it.
void find_what(const FreeSentence& sentence, Proposals& proposals) {
    if (!sentence.is(0, {"it"}) || !sentence.be_at(1) || sentence.asks()) {
        return;
    }
    const NounPhrase named = noun_phrase_at(sentence, 2);
    const int what = named.last;
    const FreeWord& next = sentence[what + 1];
    const bool goes_on = next.verb_count > 0 || is_modal(next.text) ||
                         is_third_singular(next.text) || is_other_person(next.text);
    // "Lift" is rather what one does, to the lexicon.
    const int bare =
        named.first == named.last && sentence[2].noun_count > sentence[2].adjective_count ? 3
                                                                                          : what;
    const int at = sentence.is(what, {"what"}) ? what : bare;
    if (at > 2 && sentence.is(at, {"what"}) && !sentence[at].behind_stop &&
        (at != what || goes_on)) {
        proposals.replace(at, ErrorCode::wrong_pronoun, "that");
    }
}

}  // namespace

void find_order_errors(const FreeSentence& sentence, Proposals& proposals) {
    for (int i = 0; i < sentence.size(); ++i) {
        find_adverb(sentence, i, proposals);
        find_adjective_behind(sentence, i, proposals);
        find_place_words(sentence, i, proposals);
        find_made_last(sentence, i, proposals);
        find_be_behind_degree(sentence, i, proposals);
    }
    find_verb_last(sentence, proposals);
    find_straight_question(sentence, proposals);
    find_how_many(sentence, proposals);
    find_what(sentence, proposals);
}

}  // namespace fulcrum::dialogue
// NOLINTEND(readability-function-cognitive-complexity,bugprone-branch-clone)
