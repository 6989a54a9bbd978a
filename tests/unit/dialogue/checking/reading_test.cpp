#include "dialogue/checking/reading.h"

#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("reading: what each word can be") {
    const FreeSentence sentence = only_sentence("The mice feel heavier things here");
    CHECK(sentence[0].closed);
    CHECK(sentence[1].plural_noun());
    CHECK(sentence[1].singular == "mouse");
    CHECK(sentence[2].verb == "feel");
    CHECK(sentence[2].verb_plain);
    CHECK(sentence[3].adjective == "heavy");
    CHECK(sentence[3].degree == Degree::comparative);
    CHECK(sentence[4].singular == "thing");
    CHECK_FALSE(sentence[4].can_be_singular);
    CHECK(sentence[9].text.empty());
    CHECK(sentence[-1].text.empty());
}

TEST_CASE("reading: sentences, clauses and stops") {
    static const Lexicon lexicon = opened_lexicon();
    const auto sentences = read_sentences(lexicon, "Is it? No, but I think that it moves!");
    REQUIRE(sentences.size() == 2);
    CHECK(sentences[0].asks());
    CHECK_FALSE(sentences[1].asks());
    CHECK(sentences[1][0].before_stop);
    CHECK(sentences[1].clause_begins(2));
    CHECK(sentences[1].clause_begins(5));
    CHECK_FALSE(sentences[1].clause_begins(3));
    CHECK(read_sentences(lexicon, "").empty());
    CHECK(read_sentences(lexicon, " .?! ").empty());
}

TEST_CASE("reading: an apostrophe s is a verb behind a pronoun and an owner's behind a noun") {
    CHECK_FALSE(only_sentence("it's big")[1].possessive);
    CHECK(only_sentence("the moon's side")[2].possessive);
}
