// What is true and no answer yet: "the egg is not the heaviest".
#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

const Catalogue& known_words() {
    static const Catalogue catalogue = english_words();
    return catalogue;
}

}  // namespace

TEST_CASE("left open: who rules one out truly is asked on, and nothing is counted as wrong") {
    Conversation talk(known_words());
    talk.ask(heaviest());
    for (int i = 0; i < 5; ++i) {
        const Feedback open = talk.respond(talk.hear("the egg is not the heaviest"), true);
        CHECK(open.kind == FeedbackKind::not_understood);
        CHECK(open.text == "That is true. But what is the answer?");
        CHECK(open.ask_again);
        CHECK_FALSE(open.replay);
    }
    // As many times as words that are not understood.
    CHECK(talk.respond(talk.hear("the egg is not the heaviest"), true).kind ==
          FeedbackKind::moved_on);
}

TEST_CASE("left open: its form is said back, and what is not true is wrong") {
    Conversation talk(known_words());
    talk.ask(heaviest());
    const Feedback open = talk.respond(talk.hear("egg is not the heaviest"), true);
    CHECK(open.text ==
          "In English we say: *An egg* is not the heaviest. That is true. But what is the answer?");
    CHECK(talk.respond(talk.hear("the watermelon is not the heaviest"), false).kind ==
          FeedbackKind::wrong_meaning);
    CHECK(talk.respond(talk.hear("the watermelon is the heaviest"), true).kind ==
          FeedbackKind::praise);
}
