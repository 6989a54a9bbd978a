#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

const Catalogue& ladder_words() {
    static const Catalogue catalogue = english_words();
    return catalogue;
}

/// Asks once and answers once, rightly in meaning.
Feedback climb(Conversation& talk, const Question& question, std::string_view said) {
    talk.ask(question);
    return talk.respond(talk.hear(said), true);
}

}  // namespace

TEST_CASE("conversation: the ladder can be set, and a question has its own") {
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::prompt, FeedbackStep::rule};
    Conversation talk(ladder_words(), settings);
    CHECK(climb(talk, heaviest(), "watermelon is heaviest").kind == FeedbackKind::prompt);
    const Feedback rule = climb(talk, heaviest(), "watermelon is heaviest");
    CHECK(rule.kind == FeedbackKind::rule);
    CHECK_THAT(rule.text, Catch::Contains("There is only one, so we say the: *the heaviest*."));
    // Who stands on the last step stays there.
    CHECK(climb(talk, heaviest(), "watermelon is heaviest").kind == FeedbackKind::rule);
    Question patient = heaviest();
    patient.ladder = {FeedbackStep::recast};
    for (int i = 0; i < 5; ++i) {
        CHECK(climb(talk, patient, "watermelon is heaviest").kind == FeedbackKind::recast);
    }
    // Sightings are counted over all questions, whatever their ladders.
    CHECK(climb(talk, heaviest(), "watermelon is heaviest").kind == FeedbackKind::rule);
    settings.ladder.clear();
    Conversation usual(ladder_words(), settings);
    for (const FeedbackKind kind :
         {FeedbackKind::recast, FeedbackKind::prompt, FeedbackKind::rule, FeedbackKind::rule}) {
        CHECK(climb(usual, heaviest(), "watermelon is heaviest").kind == kind);
    }
}

TEST_CASE("conversation: a step may let the hand feel it again, and nobody is held back by it") {
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::replay, FeedbackStep::recast};
    Conversation talk(ladder_words(), settings);
    const Feedback felt = climb(talk, heaviest(), "watermelon is most heavy");
    CHECK(felt.kind == FeedbackKind::replay);
    CHECK(felt.replay);
    CHECK_FALSE(felt.ask_again);
    CHECK_FALSE(felt.may_repeat);
    CHECK(felt.text == "Yes. A watermelon is *the heaviest*.");
    CHECK(talk.state() == Conversation::State::done);
    CHECK_FALSE(climb(talk, heaviest(), "watermelon is most heavy").replay);
}

TEST_CASE(
    "conversation: a rule names the word that is missing or misspelt, and reads as a sentence") {
    ConversationSettings settings;
    settings.ladder = {FeedbackStep::rule};
    Conversation talk(ladder_words(), settings);
    CHECK(climb(talk, heaviest(), "an apple the heaviest").text ==
          "Yes. An apple *is* the heaviest. Every sentence needs a verb, here is.");
    CHECK(climb(talk, heaviest(), "an appel is the heaviest").text ==
          "Yes. *An apple* is the heaviest. The right spelling: apple.");
}
