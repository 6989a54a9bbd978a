#include "dialogue/marking/near_miss.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

Question eggs() {
    return compiled({"eggs",
                     "How many eggs are there?",
                     {"[there are] {number} <plural:egg>", "{number}"},
                     {{"number", {"no|zero|none", "one|a|an", "two", "three", "ten"}}}});
}

}  // namespace

TEST_CASE("near miss: a number that no list has is understood, fills no slot, and is told") {
    const struct {
        const char *said, *number;
    } rows[] = {{"fifteen", "fifteen"},
                {"There are 15 eggs.", "15"},
                {"I think there are twenty one eggs", "twenty one"},
                {"one hundred and five eggs", "one hundred and five"},
                {"2.5 eggs", "2.5"},
                {"-3", "-3"},
                {"there are -3 eggs", "-3"},
                {"minus three", "minus three"},
                {"12345678 eggs", "12345678"},
                {"five egg", "five"}};
    for (const auto& row : rows) {
        INFO(row.said);
        const Mark mark = mark_answer(eggs(), row.said);
        CHECK(mark.understood);
        CHECK(mark.other_number == row.number);
        CHECK(mark.slots.empty());
        CHECK(mark.form_errors.empty());
    }
    for (const char* said : {"two eggs", "ten", "no eggs"}) {
        INFO(said);
        CHECK(mark_answer(eggs(), said).other_number.empty());
        CHECK_FALSE(mark_answer(eggs(), said).slots.empty());
    }
    for (const char* said : {"fifteen bananas", "eggs", "many eggs", "fifteen eggs two"}) {
        INFO(said);
        CHECK_FALSE(mark_answer(eggs(), said).understood);
        CHECK(mark_answer(eggs(), said).other_number.empty());
    }
    // Where no list has numbers, a number is just not understood.
    CHECK_FALSE(mark_answer(heaviest(), "fifteen").understood);
}

TEST_CASE("near miss: a thing that is pointed at is asked for by name") {
    const struct {
        Question question;
        const char *said, *pointed_with;
    } rows[] = {{heaviest(), "this one is the heaviest", "this one"},
                {heaviest(), "I think this is the heaviest.", "this"},
                {heaviest(), "it is that one", "that one"},
                {heavier(), "This thing is heavier than that thing", "This thing"},
                {heavier(), "it is heavier", "it"},
                {heavier(), "this one", "this one"},
                {made_of_what(), "that thing is made of metal", "that thing"},
                {compares_feel(), "this is harder than that", "this"},
                {feels_how(), "this material is hard", "this material"}};
    for (const auto& row : rows) {
        INFO(row.said);
        const Mark mark = mark_answer(row.question, row.said);
        CHECK_FALSE(mark.understood);
        CHECK(mark.pointed_with == row.pointed_with);
    }
    for (const char* said : {"this one is red", "this apple", "this apple is heavier",
                             "an egg is lighter", "it is lighter", ""}) {
        INFO(said);
        CHECK(mark_answer(heavier(), said).pointed_with.empty());
    }
}

TEST_CASE("near miss: at most one thing is said of an answer") {
    for (const char* said : {"the egg is lighter", "this one is heavier", "fifteen"}) {
        const Mark mark = mark_answer(heavier(), said);
        INFO(said);
        CHECK(int(!mark.opposite_said.empty()) + int(!mark.pointed_with.empty()) +
                  int(!mark.other_number.empty()) <=
              1);
    }
}

TEST_CASE("near miss: the frame of a counting sentence counts several") {
    // What is wanted side by side is one gap.
    CHECK(sentence_frame(compiled({"q",
                                   "Where?",
                                   {"it is {place} the {thing}"},
                                   {{"place", {"on", "under"}}, {"thing", {"egg", "rock"}}}})) ==
          "It is …");
    CHECK(sentence_frame(compiled(
              {"q", "How many?", {"{number} <plural:egg>"}, {{"number", {"one|a|an", "two"}}}})) ==
          "… eggs.");
    CHECK(sentence_frame(compiled({"q",
                                   "How many?",
                                   {"there are {number} <plural:egg> [in {place}]"},
                                   {{"number", {"one", "two"}}, {"place", {"here"}}}})) ==
          "There are … eggs.");
}

TEST_CASE("near miss: a frame says no thing twice, and a place with its thing is one gap") {
    // What the question says stands in one place, and a place with its thing is one gap.
    const Question ball = compiled({"q",
                                    "Where is the ball now?",
                                    {"[the] {thing} is <place>"},
                                    {{"thing", {"ball", "box", "ramp"}},
                                     {"other", {"ball", "box", "ramp"}},
                                     {"where", {"on", "under"}}},
                                    {{"place", "{where} the {other}"}}});
    CHECK(sentence_frame(ball) == "The ball is …");
    CHECK(example_sentence(ball) == "The ball is on the box.");
}

TEST_CASE("near miss: what the question says is none of the choices") {
    const NamedLists lists{{"material", {"metal", "wood"}}, {"feel", {"hard", "rough"}}};
    const std::vector<std::string> answers{"{material} is <adjective:{feel}>"};
    CHECK(choices(compiled({"q", "What is wood like?", answers, lists})) ==
          std::vector<std::string>{"hard", "rough"});
    CHECK(choices(compiled({"q", "What are wood and metal like?", answers, lists})) ==
          std::vector<std::string>{"metal", "wood", "hard", "rough"});
    const NamedLists places{{"thing", {"ball", "box"}}, {"other", {"ball", "box"}}};
    CHECK(
        choices(compiled({"q", "Where is the ball?", {"the {thing} is on the {other}"}, places})) ==
        std::vector<std::string>{"the ball", "the box"});
    // Where nothing else is left to choose all of it is told.
    CHECK(choices(compiled({"q", "Is it wood?", {"it is {material}"}, lists})) ==
          std::vector<std::string>{"metal", "wood"});
}
