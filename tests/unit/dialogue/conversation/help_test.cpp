#include "dialogue/conversation/help.h"

#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

using Words = std::vector<std::string>;

/// Two answers that are different sentences: the first would tell which is meant.
Question far_or_near() {
    return compiled({"easier",
                     "Where is it easier: near it or far from it?",
                     {"it is <comparative:easy> {far} from the support",
                      "it is <comparative:easy> {near} the support"},
                     {{"far", {"far|far away"}}, {"near", {"near|close to"}}}});
}

}  // namespace

TEST_CASE("help: first the sentence with its gap, then what may stand there, each kind of thing") {
    CHECK(help_for(heaviest(), 2).kind == Help::Kind::frame);
    CHECK(help_for(heaviest(), 2).sentence == "… is the heaviest.");
    const Help then = help_for(heaviest(), 3);
    CHECK(then.kind == Help::Kind::choices);
    CHECK(then.sentence.empty());
    CHECK(then.choices == Words{"a watermelon", "an apple", "a banana", "an egg"});
    CHECK(help_for(heaviest(), 7).choices == then.choices);
}

TEST_CASE("help: where the answers are different sentences, all that they say is named") {
    for (const int rung : {2, 3, 9}) {
        const Help help = help_for(far_or_near(), rung);
        CHECK(help.kind == Help::Kind::choices);
        CHECK(help.choices == Words{"far", "near"});
    }
    const Question at_the_end = compiled(
        {"easier",
         "Where is it easier?",
         {"it is <comparative:easy> {far} from it", "it is <comparative:easy> at the {tip}",
          "the <comparative:{how}> the <comparative:easy>"},
         {{"far", {"far"}}, {"tip", {"end"}}, {"how", {"near", "long"}}}});
    CHECK(help_for(at_the_end, 2).choices == Words{"far", "at the end"});
    const Question together =
        compiled({"fall",
                  "Which one is faster?",
                  {"they fall {same}", "[the] {thing} is <comparative:fast>"},
                  {{"same", {"together|at the same time"}}, {"thing", {"apple", "egg"}}}});
    CHECK(help_for(together, 2).choices == Words{"together", "the apple", "the egg"});
}

TEST_CASE("help: a question that is to be asked is shown whole, for there is nothing to guess") {
    const Question ask = compiled({"ask",
                                   "Ask me!",
                                   {"how many moons does {planet} have"},
                                   {{"planet", {"Saturn", "Mars"}}}});
    CHECK(help_for(ask, 2).sentence == "How many moons does … have?");
    CHECK(help_for(ask, 3).kind == Help::Kind::example);
    CHECK(help_for(ask, 3).sentence == "How many moons does Saturn have?");
}

TEST_CASE(
    "help: of more words than anybody listens to the frame stays; one answer alone is shown") {
    Words many;
    for (const char letter : std::string("abcdefghijklm")) {
        many.push_back(std::string("block") + letter);
    }
    const Question long_list =
        compiled({"many", "Which?", {"it is the {thing}"}, {{"thing", many}}});
    CHECK(help_for(long_list, 3).kind == Help::Kind::frame);
    const Question one = compiled({"one", "What is it?", {"it is heavy"}});
    CHECK(help_for(one, 3).kind == Help::Kind::example);
}

TEST_CASE("conversation: whoever wants help is not told which of two answers is right") {
    const Catalogue words = english_words();
    Conversation talk(words);
    const Question question = far_or_near();
    talk.ask(question);
    for (int i = 0; i < 3; ++i) {
        const Feedback feedback = talk.respond(talk.hear("help"), false);
        CHECK(feedback.kind == FeedbackKind::not_understood);
        CHECK(feedback.text == "You can say: far or near.");
    }
}

TEST_CASE(
    "conversation: the opposite is named to who was asked for a thing, not for a reason or a "
    "place") {
    const Catalogue catalogue = english_words();
    const NamedLists lists{{"thing", {"wooden block", "metal block"}},
                           {"other", {"water", "metal"}}};
    const struct {
        const char *prompt, *answer, *said;
        bool is_named;
    } rows[] = {
        {"Look. Which block is lighter?", "[the] {thing} is <comparative:light>",
         "the metal block is heavier", true},
        {"A wooden block and a metal one: what is lighter?", "[the] {thing} is <comparative:light>",
         "the metal block is heavier", true},
        {"Why does the wooden block float?", "because it is <comparative:light> than [the] {other}",
         "Because it is heavier than water.", false},
        {"Why does it float?", "because [the] {thing} is <comparative:light> than [the] {other}",
         "because the metal block is heavier than water", false},
        {"Which way do you feel it?", "it is <comparative:light>", "it is heavier", false},
    };
    for (const auto& row : rows) {
        CAPTURE(row.prompt);
        Conversation talk(catalogue);
        talk.ask(compiled({"q", row.prompt, {row.answer}, lists}));
        const Mark mark = talk.hear(row.said);
        REQUIRE_FALSE(mark.opposite_said.empty());
        const Feedback feedback = talk.respond(mark, false);
        CHECK(feedback.kind == FeedbackKind::not_understood);
        CHECK((feedback.keys.front() == "feedback.opposite") == row.is_named);
    }
}
