// What is named in a sentence of free English: a noun with its determiner, its numbers and its adjectives, or a planet by its name.
//
// Thread: pure.  Cost: linear in the words of the phrase.
#pragma once

#include "dialogue/checking/reading.h"

namespace fulcrum::dialogue {

/// A noun phrase that begins at `first`: its words [first, last), and what it asks of its verb.
struct NounPhrase {
    int first = 0;
    int last = 0;             ///< first == last: there is none
    int head = 0;             ///< the noun
    bool determined = false;  ///< begins with the, a, my, …
    bool sure = false;        ///< its number is certain
    Number number = Number::singular;
};

/// The noun phrase that begins at `first`, without what hangs on it ("of wood").
[[nodiscard]] NounPhrase noun_phrase_at(const FreeSentence& sentence, int first);

/// What is named at `first`, a planet by its name or else a noun phrase, ends before this; `first` where nothing is.
[[nodiscard]] int name_end(const FreeSentence& sentence, int first);

}  // namespace fulcrum::dialogue
