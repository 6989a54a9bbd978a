#include "dialogue/checking/noun_phrases.h"

#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("noun phrases: a noun phrase ends with its head") {
    const FreeSentence sentence = only_sentence("the big red apples are here");
    const NounPhrase phrase = noun_phrase_at(sentence, 0);
    CHECK(phrase.head == 3);
    CHECK(phrase.last == 4);
    CHECK(phrase.determined);
    CHECK(phrase.number == Number::plural);
    const NounPhrase none = noun_phrase_at(sentence, 4);
    CHECK(none.first == none.last);
    CHECK(noun_phrase_at(only_sentence("this feels rough"), 0).last == 0);
}

TEST_CASE("noun phrases: a planet ends with its name, whatever stands behind it") {
    CHECK(name_end(only_sentence("Jupiter moons are many"), 0) == 1);
    CHECK(name_end(only_sentence("the two planets turn"), 0) == 3);
    CHECK(name_end(only_sentence("is it heavy"), 0) == 0);
    CHECK(name_end(only_sentence("the egg"), 2) == 2);
}
