#include "dialogue/marking/sentence_marks.h"

#include "dialogue/marking/readings.h"
#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

Question planets() {
    return compiled({"planets",
                     "How many planets are there?",
                     {"there are {number} <plural:planet>"},
                     {{"number", {"7", "8", "9"}}}});
}

Question which_way() {
    return compiled({"which_way",
                     "Which way must the support go?",
                     {"it must go to {place}", "to {place}"},
                     {{"place", {"the Earth", "my hand", "the end"}}}});
}

}  // namespace

TEST_CASE("sentence marks: two sentences that say the same are one answer, without an error") {
    for (const char* said :
         {"Eight. There are eight planets.", "There are eight planets. Eight!",
          "8. There are 8 planets", "Eight; there are eight.", "Eight, there are eight planets",
          "Eight! I think so.", "Yes. Eight."}) {
        INFO(said);
        CHECK(verdict_on(planets(), said, {"8"}) == "right");
    }
    CHECK(mark_answer(planets(), "Eight. There are eight planets.").corrected ==
          "There are 8 planets.");
    CHECK_FALSE(mark_answer(planets(), "Eight. There are eight planets.").short_answer);
    CHECK(readings_of(mark_answer(planets(), "Eight. There are eight planets.")).size() == 1);
    CHECK(verdict_on(which_way(), "To the Earth. It must go to the Earth.", {"Earth"}) == "right");
    CHECK(verdict_on(made_of_what(), "Metal. It is made of metal.", {"metal"}) == "right");
}

TEST_CASE("sentence marks: a pronoun behind a full stop is a subject, and means what was named") {
    for (const char* said :
         {"The apple. It is heavier.", "The apple! It's heavier than the egg.",
          "The apple. I think it is heavier.", "It is the apple. It is heavier.",
          "The apple is heavier. I can feel it.", "The apple is heavier, I felt it in my hand."}) {
        INFO(said);
        CHECK(verdict_on(heavier(), said, {"apple"}) == "right");
    }
    CHECK(verdict_on(heaviest(), "The egg. It is the heaviest.", {"egg"}) == "right");
    CHECK(verdict_on(spaceship_of_what(), "The spaceship? It is made of metal.", {"metal"}) ==
          "right");
    CHECK(verdict_on(moons(), "Mars? It has two moons.", {"2"}) == "right");
    // Within one sentence it repeats the subject, and an error in the second is told at its place.
    CHECK(verdict_on(heaviest(), "The egg it is the heaviest.", {"egg"}) == "right U:PRON");
    CHECK(verdict_on(heavier(), "The apple. It is more heavy.", {"apple"}) == "right R:ADJ:FORM");
    const Mark mark = mark_answer(heavier(), "The apple. It is more heavy.");
    CHECK(mark.form_errors.at(0).begin == 17);
    CHECK(mark.form_errors.at(0).end == 27);
    CHECK(mark.emphasised == "The apple is *heavier*.");
}

TEST_CASE("sentence marks: sentences that contradict each other are never right") {
    for (const char* said :
         {"Eight. There are nine planets.", "There are nine planets. Eight.", "Eight, nine",
          "Eight. Not eight.", "Eight? Nine?", "It is not eight. Eight.", "Eight. No, nine."}) {
        INFO(said);
        CHECK(verdict_on(planets(), said, {"8"}).find("right") != 0);
    }
    for (const char* said :
         {"The apple. It is not heavier.", "The apple. The egg is heavier.",
          "The apple is heavier. The egg.", "They are the same. The apple is heavier.",
          "The apple. No, that is wrong.", "The egg? The apple?", "The apple? No.",
          "The apple, no, the egg", "The apple is heavier, or the egg.", "No, not the apple",
          "The apple. The apple is as heavy as the egg.", "The apple. Maybe not.",
          "The apple. Nobody knows.", "Not the apple. The egg."}) {
        INFO(said);
        CHECK(verdict_on(heavier(), said, {"apple"}).find("right") != 0);
    }
}

TEST_CASE(
    "sentence marks: what the first sentence names counts, whatever all of it may be read as") {
    for (const char* said : {"The egg. It is not as heavy as the apple.",
                             "The egg. It isn't heavier.", "The apple! It isn't heavier."}) {
        INFO(said);
        const Mark mark = mark_answer(heavier(), said);
        CHECK(mark.claim == Claim::every);
        CHECK(readings_of(mark).size() == 2);
    }
    CHECK(verdict_on(heavier(), "The egg. It isn't as light as the apple.", {"egg"}) == "right");
    CHECK(verdict_on(feels_how(), "Metal is hard. And smooth.", {"hard", "smooth"}) == "right");
    CHECK(verdict_on(heavier(), "The apple is heavier, isn't it?", {"apple"}) == "right");
    CHECK(verdict_on(heavier(), "The apple is heavier, is it not the egg?", {"apple"}) == "?");
}

TEST_CASE("sentence marks: an order, and what compares nothing, are no answers beside another") {
    CHECK(verdict_on(heaviest(), "The apple, then the banana, then the egg.", {"apple"}) == "?");
    CHECK(verdict_on(heavier(), "The egg is heavy, but the apple is heavier.", {"apple"}) == "?");
    CHECK(verdict_on(heavier(), "The apple is heavy.", {"apple"}) == "right R:ADJ:FORM");
}

TEST_CASE("sentence marks: what is ruled out beside the answer is no answer") {
    for (const char* said : {"eight, not nine", "Not nine, eight.", "not nine but eight",
                             "There are eight planets, not nine", "eight, not twelve"}) {
        INFO(said);
        CHECK(verdict_on(planets(), said, {"8"}) == "right");
    }
    CHECK(verdict_on(planets(), "nine, not eight", {"8"}) == "wrong");
    CHECK(verdict_on(planets(), "eight, not eight", {"8"}) == "wrong");
    CHECK(verdict_on(planets(), "eight, not many", {"8"}) == "?");
    CHECK(verdict_on(which_way(), "to the Earth, not to my hand", {"Earth"}) == "right");
    CHECK(verdict_on(which_way(), "to my hand, not to the Earth", {"Earth"}) == "wrong");
    CHECK(verdict_on(heaviest(), "it is the egg, not the apple", {"egg"}) == "right");
    CHECK(verdict_on(heavier(), "The egg isn't heavier, the apple is.", {"apple"}) == "right");
    CHECK(verdict_on(heavier(), "The apple isn't heavier, the egg is.", {"apple"}) == "wrong");
    CHECK(verdict_on(feels_how(), "It is not soft, it's hard.", {"hard"}) == "right");
    CHECK(verdict_on(feels_how(), "It is hard but not soft", {"hard"}) == "right");
    CHECK(verdict_on(feels_how(), "It is soft, not hard.", {"hard"}) == "wrong");
    CHECK(verdict_on(made_of_what(), "It is metal, it is not wood.", {"metal"}) == "right");
    const Mark mark = mark_answer(planets(), "eight, not nine");
    CHECK(mark.claim == Claim::every);
    CHECK(mark.denied == std::vector<bool>{false, true});
    CHECK(mark.slots == Slots{{"number", "8"}});
}

TEST_CASE("sentence marks: no before an answer is a word where nobody asked for yes or no") {
    CHECK(verdict_on(heavier(), "No, the apple is heavier!", {"apple"}) == "right");
    CHECK(verdict_on(heavier(), "No! The apple.", {"apple"}) == "right");
    CHECK(verdict_on(heavier(), "No apple is heavier", {"apple"}) == "?");
    const Question asks = compiled(
        {"asks", "Is the apple heavier?", {"the {thing} is <comparative:heavy>"}, fruit()});
    CHECK(verdict_on(asks, "No, the apple is heavier!", {"apple"}) == "?");
}

TEST_CASE("sentence marks: what is told of the other one by the opposite word is ruled out") {
    for (const char* said :
         {"The apple is heavier, the egg is lighter.", "The apple is heavier. The egg is lighter.",
          "the apple is heavier and the egg is lighter",
          "The egg is lighter, but the apple is heavier"}) {
        INFO(said);
        CHECK(verdict_on(heavier(), said, {"apple"}).find("right") == 0);
    }
    CHECK(verdict_on(heavier(), "the egg is heavier, the apple is lighter", {"apple"}) == "wrong");
    CHECK(verdict_on(heavier(), "the apple is heavier, the apple is lighter", {"apple"}) ==
          "wrong");
    CHECK(verdict_on(heavier(), "the egg is lighter, the banana is lighter", {"apple"}) == "?");
    // Nobody knows here what "the lightest" is.
    CHECK(verdict_on(heaviest(), "the egg is the heaviest, the apple is the lightest", {"egg"}) ==
          "?");
}

TEST_CASE("sentence marks: as many names as were counted may stand behind an answer") {
    const std::string names = "Mercury, Venus, Earth, Mars, Jupiter, Saturn, Uranus and Neptune";
    for (const std::string& said :
         {"Eight: " + names, "There are eight: " + names + ".", "there are eight planets, " + names,
          std::string("There are seven: a, b, c, d, the e, f and g")}) {
        INFO(said);
        CHECK(verdict_on(planets(), said, {"8", "7"}) == "right");
        CHECK(mark_answer(planets(), said).short_answer);
    }
    CHECK(verdict_on(moons(), "Mars has two moons, Phobos and Deimos.", {"2"}) == "right");
    for (const char* said : {"Eight: Mercury and Venus", "Eight: no", "Eight: that is wrong",
                             "Eight, Mercury", "Eight: a, b, c, d, e, f, g and not h",
                             "Eight: one, two, three, four, five, six, g, h"}) {
        INFO(said);
        CHECK(verdict_on(planets(), said, {"8"}) == "?");
    }
    CHECK(verdict_on(moons(), "two moons, 8 and 21", {"2"}) == "?");
}
