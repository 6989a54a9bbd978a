#include "dialogue/conversation/help.h"

#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace fulcrum::dialogue;

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
