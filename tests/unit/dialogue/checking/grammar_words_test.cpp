#include "dialogue/checking/grammar_words.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("grammar words: each table knows its own and no others") {
    CHECK(is_closed_word("she"));
    CHECK(is_closed_word("must"));
    CHECK_FALSE(is_closed_word("moon"));
    CHECK(is_determiner("these"));
    CHECK(is_central_determiner("my"));
    CHECK_FALSE(is_central_determiner("these"));
    CHECK(is_third_singular("it"));
    CHECK(is_other_person("they"));
    CHECK(is_strictly_mass("advice"));
    CHECK(is_material("metal"));
    CHECK(is_collective("team"));
    CHECK(is_physical("heavy"));
    CHECK(is_physical("red"));
    CHECK_FALSE(is_physical("famous"));
    CHECK(is_planet("mars"));
    CHECK(is_month_or_day("november"));
    CHECK(is_time_or_amount("day"));
}

TEST_CASE("grammar words: the empty word is in no table") {
    for (const auto& is :
         {is_closed_word, is_determiner, is_central_determiner, is_possessive, is_modal,
          is_question_word, is_linking_verb, is_telling_verb, is_strictly_mass, is_material,
          is_collective, is_physical, is_time_or_amount, is_planet, is_month_or_day,
          is_light_adverb, is_third_singular, is_other_person}) {
        CHECK_FALSE(is(""));
    }
}
