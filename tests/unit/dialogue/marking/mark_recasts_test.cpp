// What is said back, and what is no error though it looks like one.
#include "dialogue/marking/mark.h"
#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

Question heavier_of_two() {
    return compiled({"heavier",
                     "Which one is heavier, the apple or the egg?",
                     {"[the|a|an] {thing} is <comparative:heavy> [than the {thing:other}]",
                      "the <comparative:heavy> [one] is the {thing}",
                      "the {thing} is the <comparative:heavy> one"},
                     fruit()});
}

}  // namespace

TEST_CASE("mark: a superlative of two things is said back as a comparative, without the") {
    check_rows(heavier_of_two(),
               {{"the apple is the heaviest", "R:ADJ:FORM", "The apple is *heavier*."},
                {"the apple is heaviest", "R:ADJ:FORM", "The apple is *heavier*."},
                {"the apple is the most heavy", "R:ADJ:FORM", "The apple is *heavier*."},
                {"the apple is the more heavy", "R:ADJ:FORM", "The apple is *heavier*."},
                {"the apple is the heaviest than the egg", "U:DET R:ADJ:FORM",
                 "The apple is *heavier* than the egg."},
                // With a noun it has its article, and of two "the heavier" is right.
                {"the apple is the heaviest one", "R:ADJ:FORM", "The apple is *the heavier* one."},
                {"the heaviest is the apple", "R:ADJ:FORM", "*The heavier* is the apple."},
                {"the apple is the heavier", "", "The apple is the heavier."}});
    const Question turn =
        compiled({"turn",
                  "Which one is harder to turn?",
                  {"[the] {planet} is <comparative:hard> to turn [than [the] {other}]"},
                  {{"planet", {"Earth|the Earth", "Jupiter"}}, {"other", {"Jupiter", "Earth"}}}});
    check_rows(turn,
               {{"Jupiter is the hardest to turn", "R:ADJ:FORM", "Jupiter is *harder* to turn."},
                {"Jupiter is the most hard to turn than Earth", "R:ADJ:FORM",
                 "Jupiter is *harder* to turn than Earth."}});
}

TEST_CASE("mark: all of a kind may be meant where one is there, as a subject and behind than") {
    check_rows(
        heavier_of_two(),
        {{"apples are heavier", "", "Apples are heavier."},
         {"apples are heavier than eggs", "", "Apples are heavier than eggs."},
         {"the apple is heavier than eggs", "", "The apple is heavier than eggs."},
         {"apples is heavier than eggs", "R:VERB:SVA", "Apples *are* heavier than eggs."},
         {"aplles are heavier", "R:SPELL", "*Apples* are heavier."},
         // The ones that are there, or what is pointed at, is one thing.
         {"the apples are heavier", "R:NOUN:NUM", "*The apple* is heavier."},
         {"the heavier one is apples", "M:DET R:NOUN:NUM", "The heavier one is *the apple*."}});
    const Question moon = compiled(
        {"moon",
         "Where does an apple weigh less?",
         {"(it|an apple|the apple) weighs less on the {place}", "the {place} pulls the apple"},
         {{"place", {"Earth", "Moon"}}}});
    check_rows(
        moon, {{"apples weigh less on the moon", "", "Apples weigh less on the Moon."},
               {"apples weighs less on the moon", "R:VERB:SVA", "Apples *weigh* less on the Moon."},
               {"apple weighs less on the moon", "M:DET", "*An apple* weighs less on the Moon."},
               {"the moon pulls apples", "R:NOUN:NUM", "The Moon pulls *the apple*."}});
}

TEST_CASE("mark: its is whose it is, or it's, as the sentence asks") {
    const Question pulls =
        compiled({"pulls",
                  "What pulls it down?",
                  {"[the] {puller} pulls it down", "it is [the] {puller}", "[the] {puller}",
                   "the line is made of {material}"},
                  {{"puller", {"weight", "wind"}}, {"material", {"silk", "nylon"}}}});
    check_rows(pulls, {{"its weight", "", "Its weight."},
                       {"its weight pulls it down", "", "Its weight pulls it down."},
                       {"it is its weight", "", "It is its weight."},
                       {"its the weight", "R:ORTH", "*It is* the weight."},
                       {"Its the wind", "R:ORTH", "*It is* the wind."}});
    const Mark mark = mark_answer(pulls, "its the weight");
    REQUIRE(mark.form_errors.size() == 1);
    CHECK(mark.form_errors[0].right == "it's");
    CHECK(mark.gapped == "… the weight.");
    CHECK(mark.slot("puller") == "weight");
}

TEST_CASE("mark: near needs no to, and nearest to a thing needs no the") {
    const Question support =
        compiled({"support",
                  "Where must it go?",
                  {"it must go <comparative:near> to the {goal}", "it must go near to the {goal}",
                   "it must go [nearer] to the {goal}", "it is opposite to the {goal}"},
                  {{"goal", {"stone", "hand"}}}});
    check_rows(support, {{"it must go nearer the stone", "", "It must go nearer the stone."},
                         {"it must go near the stone", "", "It must go near the stone."},
                         {"it is opposite the stone", "", "It is opposite the stone."},
                         {"it must go nearer to the stone", "", "It must go nearer to the stone."},
                         {"it must go the stone", "M:PREP", "It must go *to* the stone."}});
    const Question planet = compiled({"nearest",
                                      "Which planet is the nearest to the Sun?",
                                      {"{planet} is the <superlative:near> [planet] [to the Sun]",
                                       "{planet} is the <superlative:hot> [planet]"},
                                      {{"planet", {"Mercury", "Mars"}}}});
    check_rows(planet, {{"Mercury is nearest to the sun", "", "Mercury is nearest to the Sun."},
                        {"Mercury is nearest the sun", "", "Mercury is nearest the Sun."},
                        {"Mercury is nearest", "M:DET", "Mercury is *the nearest*."},
                        {"Mercury is nearest planet to the sun", "M:DET",
                         "Mercury is *the nearest* planet to the Sun."},
                        {"Mercury is hottest", "M:DET", "Mercury is *the hottest*."}});
}

TEST_CASE("mark: a number may stand without its noun, and the verb goes with it") {
    const Question count =
        compiled({"count",
                  "How many eggs are there?",
                  {"there are {number} <plural:egg>", "it has {number} <plural:egg>"},
                  {{"number", {"no|none", "one|a|an", "two|2", "three|3"}}}});
    check_rows(count, {{"there are two", "", "There are two eggs."},
                       {"there is one", "", "There is one egg."},
                       {"it has three", "", "It has three eggs."},
                       {"there is two", "R:VERB:SVA", "There *are* two."},
                       {"there are one", "R:VERB:SVA", "There *is* one."},
                       {"it has a", "R:OTHER", "It has an *egg*."},
                       {"it has a egg", "R:DET", "It has *an* egg."},
                       {"it has an egg", "", "It has an egg."},
                       {"there are 3.0", "", "There are three eggs."}});
    CHECK(mark_answer(count, "there are two").short_answer);
    CHECK_FALSE(mark_answer(count, "there are two eggs").short_answer);
    CHECK(mark_answer(count, "there are -3").other_number == "-3");
    const Question bare = compiled(
        {"bare", "How many?", {"there are {number}"}, {{"number", {"one", "two", "145"}}}});
    check_rows(bare, {{"there is one", "", "There is one."},
                      {"there are two", "", "There are two."},
                      {"there is 145", "R:VERB:SVA", "There *are* 145."}});
}

TEST_CASE("mark: names keep their capitals, words their hyphens, and yes its comma") {
    const Question day =
        compiled({"day",
                  "How long does it take?",
                  {"it takes the Earth {number} <plural:hour> to go round the Sun-like star",
                   "(yes|no) [it (is|isn't) {heavy}]", "isn't it the {thing}", "no {thing}",
                   "it (can't|won't) fall, {thing}"},
                  {{"number", {"two", "twenty-four"}}, {"heavy", {"heavy"}}, {"thing", {"egg"}}}});
    check_rows(day, {{"it takes the earth 24 hours to go round the sun like star", "",
                      "It takes the Earth twenty-four hours to go round the Sun-like star."},
                     {"it takes earth 24 hours to go round the sun like star", "M:DET",
                      "It takes *the Earth* twenty-four hours to go round the Sun-like star."},
                     {"yes it is heavy", "", "Yes, it is heavy."},
                     {"no it isn't heavy", "", "No, it isn't heavy."},
                     {"isn't it the egg", "", "Isn't it the egg?"},
                     {"no egg", "", "No egg."},
                     {"it can't fall, the egg", "", "It can't fall the egg."},
                     {"it won't fall, the egg", "", "It won't fall the egg."}});
}

TEST_CASE("mark: what a list describes is said without an article") {
    const Question between = compiled({"between",
                                       "Which block is between them?",
                                       {"the {colour} block is between them"},
                                       {{"colour", {"red", "blue"}}}});
    check_rows(between, {{"it is blue", "", "The blue block is between them."},
                         {"blue", "", "The blue block is between them."},
                         {"it is a blue", "U:DET", "*The blue* block is between them."}});
}

TEST_CASE("mark: one thing is it, several are they") {
    check_rows(spaceship_of_what(),
               {{"they are made of metal", "R:PRON", "*It* is made of metal."},
                {"these are made of metal", "R:PRON", "*This* is made of metal."},
                {"it is made of metal", "", "It is made of metal."}});
    check_rows(scissors_of_what(),
               {{"it is made of metal", "R:PRON", "*They* are made of metal."},
                {"they are made of metal", "", "They are made of metal."},
                {"these is made of metal", "R:VERB:SVA", "These *are* made of metal."}});
    const Question table =
        compiled({"table",
                  "What is it made of?",
                  {"[a|an|the] {thing} <made_of:{material}>"},
                  {{"thing", {"table", "door"}}, {"material", {"wood", "metal"}}}});
    check_rows(table, {{"they are made of wood", "R:PRON", "*It* is made of wood."},
                       {"tables are made of wood", "", "Tables are made of wood."}});
}

TEST_CASE("mark: one of what a list has several of needs its article") {
    const Question paper = compiled({"paper",
                                     "What is paper made from?",
                                     {"paper is made from {material}", "from {material}"},
                                     {{"material", {"wood|trees", "rock"}}}});
    check_rows(paper, {{"from trees", "", "From trees."},
                       {"from tree", "R:NOUN:NUM", "From *trees*."},
                       {"paper is made from tree", "R:NOUN:NUM", "Paper is made from *trees*."},
                       {"from a tree", "", "From a tree."}});
}

TEST_CASE("mark: more and most with any degree are heard at a superlative, and it is meant") {
    for (const char* said : {"more heaviest", "most heaviest", "more heavier", "most heavier"}) {
        INFO(said);
        const Mark mark = mark_answer(heaviest(), "a watermelon is the " + std::string(said));
        CHECK(mark.slot("thing") == "watermelon");
        CHECK(mark.emphasised == "A watermelon is *the heaviest*.");
        REQUIRE(mark.form_errors.size() == 1);
        CHECK(mark.form_errors[0].errant() == "R:ADJ:FORM");
    }
    check_rows(heavier_of_two(),
               {{"the apple is most heaviest", "R:ADJ:FORM", "The apple is *heavier*."}});
}

TEST_CASE("mark: the heavier needs its noun or nothing behind it, no place") {
    const Question place = compiled({"place",
                                     "Where is it easier?",
                                     {"it is <comparative:easy> [at the {place}|far from it]"},
                                     {{"place", {"handle", "hinge"}}}});
    check_rows(place, {{"it is easier at the handle", "", "It is easier at the handle."},
                       {"it is the easier", "", "It is the easier."},
                       {"it is the easier at the handle", "U:DET", "It is *easier* at the handle."},
                       {"it is the easier far from it", "U:DET", "It is *easier* far from it."}});
    const Question moons = compiled({"moons",
                                     "How many?",
                                     {"it has {number} <plural:moon>"},
                                     {{"number", {"no|none", "two"}}}});
    check_rows(moons, {{"it has none moons", "R:DET", "It has *no* moons."},
                       {"it has no moons", "", "It has no moons."}});
}
