#include "dialogue/checking/doubts.h"

#include "dialogue/checking/grammar_words.h"
#include "dialogue/checking/noun_phrases.h"
#include "dialogue/english/adjective.h"
#include "dialogue/english/word_table.h"

#include <array>

namespace fulcrum::dialogue {
namespace {

/// In -ly and another thing than their adjective, which is an adverb as it stands: "flies highly", "pulls more hardly".
constexpr auto kOtherAdverbs = std::to_array<std::string_view>(
    {"hardly", "highly", "lowly", "nearly", "lately", "shortly", "fastly", "longly", "justly"});

/// What a person does: "the kite misses a tail", "it wishes a tail".
constexpr auto kOfPersons = std::to_array<std::string_view>({"miss", "wish"});

/// No thing follows these without a preposition.
constexpr auto kWithPreposition = std::to_array<std::string_view>(
    {"wish", "listen", "wait", "arrive", "depend", "belong", "happen"});

/// Prepositions, and what may stand before another one: "out of", "from under", "up to", "on top of".
constexpr auto kPlaces = std::to_array<std::string_view>(
    {"in",   "on",    "at",   "of",     "to",      "from", "by",   "with", "for", "into",
     "onto", "under", "near", "behind", "between", "up",   "down", "off",  "out", "over"});
constexpr auto kBeforePlaces =
    std::to_array<std::string_view>({"up", "down", "out", "off", "over", "from", "near", "behind"});

/// "Is fly": what is done, in its plain form, where it may be no name of a thing either.
bool is_plain_behind_be(const FreeSentence& sentence, int i) {
    const FreeWord& verb = sentence[i + 1];
    return sentence.be_at(i) && !sentence[i].before_stop && !sentence.asks() && !verb.closed &&
           verb.verb_plain && verb.verb_count > verb.noun_count &&
           verb.verb_count > verb.adjective_count && verb.adverb_count == 0;
}

/// "Near hand": a thing that is there, and nothing says which.
bool is_bare(const FreeSentence& sentence, int i) {
    const FreeWord& noun = sentence[i];
    if (!noun.thing || noun.hyphen_behind || !sentence.is_head(i) || noun.possessive) {
        return false;
    }
    int first = i;
    while (first > 0 && !sentence[first - 1].closed && !sentence[first - 1].number &&
           !sentence[first].behind_stop &&
           (sentence[first - 1].adjective_count > 0 || sentence[first - 1].noun_count > 0)) {
        --first;
    }
    const bool on_top = sentence.is(i, {"top", "side"}) && sentence.is(first - 1, {"on", "at"});
    return !on_top && !is_determiner(sentence.text(first - 1)) && !sentence[first - 1].number &&
           !sentence.is(first - 1, {"one"}) && !sentence[first - 1].possessive;
}

/// "Planets they are": who does it is said twice.
bool is_said_twice(const FreeSentence& sentence, int i) {
    return i > 0 && !sentence[i].behind_stop && !sentence[i - 1].closed &&
           sentence[i - 1].mainly_noun() && sentence.is(i, {"it", "they", "he", "she"}) &&
           sentence.be_at(i + 1) && !is_time_or_amount(sentence.text(i - 1));
}

/// "More much lighter", "more lighter", "fly more high".
bool is_compared_wrongly(const FreeSentence& sentence, int i) {
    const int at = is_light_adverb(sentence.text(i + 1)) ? i + 2 : i + 1;
    const FreeWord& word = sentence[at];
    const Comparison how = comparison_of(word.text);
    const bool with_ending = is_physical(word.text) && word.adjective_count > 0 &&
                             (how == Comparison::ending || how == Comparison::irregular);
    return sentence.is(i, {"more", "most"}) && !sentence[i].before_stop && !word.closed &&
           (word.degree != Degree::positive || with_ending);
}

/// "Heavier as the wood", "the same than before", "as heavy than": the word behind does not go with what is compared.
bool is_compared_with_other(const FreeSentence& sentence, int i) {
    const FreeWord& word = sentence[i];
    if (word.before_stop) {
        return false;
    }
    const bool comparative = (word.degree == Degree::comparative && !word.closed &&
                              word.adjective_count > word.noun_count) ||
                             sentence.is(i - 1, {"more", "less"}) || word.text == "more";
    return (comparative && sentence.is(i + 1, {"as", "that", "like", "then"})) ||
           (sentence.is(i, {"same"}) && sentence.is(i + 1, {"than", "like", "of"})) ||
           (sentence.is(i - 1, {"as"}) && sentence.is(i + 1, {"than", "like"}));
}

/// "Too much heavy", "very much long": much goes with no plain adjective.
bool is_much_too_much(const FreeSentence& sentence, int i) {
    const FreeWord& word = sentence[i + 1];
    return sentence.is(i, {"much"}) && !sentence[i].before_stop && word.mainly_adjective() &&
           word.degree == Degree::positive && is_physical(word.text) && sentence.ends_at(i + 1);
}

/// "It has not a tail", "how many moons have the Earth": "do" is missing.
bool lacks_do(const FreeSentence& sentence, int i) {
    if (!sentence.is(i, {"have", "has", "had"})) {
        return false;
    }
    const FreeWord& behind = sentence[i + 2];
    const bool denies = sentence.is(i + 1, {"not"}) && !behind.closed && behind.noun_count > 0 &&
                        behind.noun_count > behind.verb_count;
    const bool denies_one =
        sentence.is(i + 1, {"not"}) && sentence.is(i + 2, {"a", "an", "any", "the"});
    const bool asks = sentence.is(0, {"how"}) && sentence.is(1, {"many", "much"}) &&
                      (is_determiner(sentence.text(i + 1)) || is_planet(sentence.text(i + 1)) ||
                       is_third_singular(sentence.text(i + 1))) &&
                      !sentence.is(sentence.size() - 1, {"got"});
    return denies || denies_one || asks;
}

/// "Wind is stronger", "wind stopped": of what is around everybody there is one.
bool is_bare_surrounding(const FreeSentence& sentence, int i) {
    const bool starts = sentence.clause_begins(i) || sentence.is(i - 1, {"when", "and"});
    const FreeWord& next = sentence[i + 1];
    return starts && sentence.is(i, {"wind", "sky", "ground", "sea", "weather"}) &&
           !sentence[i].before_stop &&
           (sentence.be_at(i + 1) || is_modal(next.text) || next.verb_count > next.noun_count);
}

/// "A tail is longer", "must have longer": of what, or longer than what, is not said.
bool is_half_compared(const FreeSentence& sentence, int i) {
    const FreeWord& word = sentence[i + 1];
    const bool ends = !word.closed && word.degree == Degree::comparative &&
                      word.adjective_count > word.noun_count && sentence.ends_at(i + 1);
    const NounPhrase subject = noun_phrase_at(sentence, 0);
    const bool any_such = subject.last == i && sentence.is(0, {"a", "an"}) && sentence.be_at(i);
    return ends && (any_such || sentence.is(i, {"have", "has", "need", "needs"}));
}

/// "In the side", "in the pole": a place that nothing is inside of.
bool is_in_surface(const FreeSentence& sentence, int i) {
    return sentence.is(i, {"in"}) && sentence.is(i + 1, {"the"}) &&
           sentence.is(i + 2, {"side", "pole", "top", "edge", "rim", "surface", "floor", "wall"}) &&
           sentence.ends_at(i + 2);
}

/// "Gives light and warm": a thing beside what it is like. "It is metal and hard" tells two things of it.
bool joins_unlike(const FreeSentence& sentence, int i) {
    const FreeWord& word = sentence[i + 1];
    return sentence.is(i, {"and"}) && sentence.ends_at(i + 1) && word.mainly_adjective() &&
           word.noun_count == 0 && sentence[i - 1].noun_count > 0 &&
           !sentence[i - 1].mainly_adjective() && sentence[i - 2].verb_count > 0 &&
           !sentence.be_at(i - 2) && !is_linking_verb(sentence[i - 2].verb);
}

/// "It is big and have moons": the second verb has another number than the first.
bool joins_other_number(const FreeSentence& sentence, int i) {
    if (!sentence.is(i, {"and", "but"}) ||
        !sentence.is(i + 1, {"have", "are", "do", "go", "pull"})) {
        return false;
    }
    for (int at = 0; at < i; ++at) {
        if (sentence.is(at,
                        {"they", "we", "you", "i", "are", "have", "can", "must", "will", "to"}) ||
            sentence[at].plural_noun()) {
            return false;
        }
    }
    return true;
}

/// "Flies very highly", "more hardly"; not "hardly any", "nearly as long".
bool is_other_adverb(const FreeSentence& sentence, int i) {
    const bool behind_more = sentence.is(i - 1, {"more", "very", "so", "too", "most"});
    return contains(kOtherAdverbs, sentence.text(i)) && (behind_more || sentence.ends_at(i));
}

/// "Make the kite to fly": also a tail that is made to hold it, so nobody can tell.
bool is_made_to(const FreeSentence& sentence, int i) {
    if (sentence[i].verb != "make" && sentence[i].verb != "let") {
        return false;
    }
    const bool pronoun = sentence.is(i + 1, {"it", "him", "her", "them", "me", "us", "you"});
    const int to = pronoun ? i + 2 : noun_phrase_at(sentence, i + 1).last;
    return to > i + 1 && sentence.is(to, {"to"}) && sentence[to + 1].verb_plain;
}

/// "Push in up".
bool has_two_places(const FreeSentence& sentence, int i) {
    return contains(kPlaces, sentence.text(i)) && !contains(kBeforePlaces, sentence.text(i)) &&
           !sentence[i].before_stop && contains(kPlaces, sentence.text(i + 1));
}

/// "It turns around himself", "because he is big": nobody is named.
bool is_no_person(const FreeSentence& sentence, int i) {
    const bool back = sentence.is(i, {"himself", "herself"});
    if (!back && !sentence.is(i, {"he", "she"})) {
        return false;
    }
    for (int at = 0; at < sentence.size(); ++at) {
        const bool person =
            is_other_person(sentence.text(at)) || sentence.is(at, {"who", "my", "me"});
        if ((back && sentence.is(at, {"he", "she", "him", "her"})) || (!back && person) ||
            (sentence[at].capital && at > 0 && !is_planet(sentence.text(at)))) {
            return false;
        }
    }
    return true;
}

/// "It wishes a tail", "the kite misses the tail", "it depends the wind".
bool has_other_object(const FreeSentence& sentence, int i) {
    const FreeWord& verb = sentence[i];
    if (verb.closed || verb.before_stop || !is_determiner(sentence.text(i + 1))) {
        return false;
    }
    const bool of_thing = sentence.is(i - 1, {"it"}) || sentence[i - 1].mainly_noun();
    return contains(kWithPreposition, verb.verb) || (of_thing && contains(kOfPersons, verb.verb));
}

}  // namespace

bool is_doubtful(const FreeSentence& sentence) {
    for (int i = 0; i < sentence.size(); ++i) {
        const bool unknown = !sentence[i].known && !sentence[i].capital;
        if (unknown || is_plain_behind_be(sentence, i) || is_bare(sentence, i) ||
            is_said_twice(sentence, i) || is_compared_wrongly(sentence, i) ||
            is_compared_with_other(sentence, i) || is_other_adverb(sentence, i) ||
            is_made_to(sentence, i) || has_two_places(sentence, i) || is_no_person(sentence, i) ||
            has_other_object(sentence, i) || is_much_too_much(sentence, i) ||
            lacks_do(sentence, i) || is_bare_surrounding(sentence, i) ||
            is_in_surface(sentence, i) || is_half_compared(sentence, i) ||
            joins_unlike(sentence, i) || joins_other_number(sentence, i)) {
            return true;
        }
    }
    return false;
}

}  // namespace fulcrum::dialogue
