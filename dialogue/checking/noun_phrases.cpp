#include "dialogue/checking/noun_phrases.h"

#include "dialogue/checking/grammar_words.h"
#include "dialogue/english/noun.h"

namespace fulcrum::dialogue {
namespace {

/// A noun behind a determiner, though it can be a verb as well: "the feel"; not "this feels".
bool is_weak_noun(const FreeSentence& sentence, int i) {
    const FreeWord& word = sentence[i];
    return word.noun_count > 0 &&
           !(word.verb_in_s && sentence.is(i - 1, {"this", "that", "which", "what"}));
}

/// May this word stand among the nouns of a phrase, whose first noun is at `first_noun`?
bool is_among_nouns(const FreeSentence& sentence, int i, int first_noun, bool determined) {
    const FreeWord& word = sentence[i];
    if (word.closed || word.number) {
        return false;
    }
    return word.mainly_noun() || (word.text == "force" && is_measured(sentence.text(i - 1))) ||
           (i == first_noun &&
            (is_material(sentence.text(i)) || (determined && is_weak_noun(sentence, i))));
}

}  // namespace

NounPhrase noun_phrase_at(const FreeSentence& sentence, int first) {
    NounPhrase phrase{first, first, first};
    int i = first;
    if (is_determiner(sentence.text(i)) && !sentence[i].before_stop) {
        phrase.determined = true;
        ++i;
    }
    while (sentence[i].number && !sentence[i].before_stop) {  // "twenty eight"
        ++i;
    }
    // Adjectives, then nouns; the last noun is the head.
    while (i < sentence.size() && !sentence[i].before_stop && sentence[i].mainly_adjective()) {
        ++i;
    }
    const int first_noun = i;
    int head = i - 1;
    while (i < sentence.size() && is_among_nouns(sentence, i, first_noun, phrase.determined)) {
        head = i;
        if (sentence[i].before_stop) {
            break;
        }
        ++i;
    }
    if (head < first || !(sentence[head].noun_count > 0) || sentence[head].closed) {
        return phrase;
    }
    phrase.head = head;
    phrase.last = head + 1;
    const FreeWord& noun = sentence[head];
    if (is_collective(noun.text)) {
        return phrase;
    }
    if (noun.plural_noun()) {
        phrase.sure = true;
        phrase.number = Number::plural;
    } else if ((noun.mainly_noun() || phrase.determined || is_material(noun.text)) &&
               noun.can_be_singular && noun.singular.empty() && plural_of(noun.text) != noun.text) {
        phrase.sure = true;
    }
    const bool one =
        sentence.is(first, {"a", "an", "this", "that", "every", "each", "another", "one"});
    phrase.sure = phrase.sure && !(one && phrase.number == Number::plural);
    return phrase;
}

int name_end(const FreeSentence& sentence, int first) {
    return is_planet(sentence.text(first)) ? first + 1 : noun_phrase_at(sentence, first).last;
}

}  // namespace fulcrum::dialogue
