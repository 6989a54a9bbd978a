// How well an answer was heard, and whether its form was heard with it.
#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

#include <string_view>

using namespace fulcrum::dialogue;

namespace {

const Catalogue& heard_words() {
    static const Catalogue catalogue = english_words();
    return catalogue;
}

Feedback answer_heaviest(Conversation& talk, std::string_view said) {
    talk.ask(heaviest());
    return talk.respond(talk.hear(said), true);
}

/// At an invitation to say it once more: "an apple is the most heavy", said twice.
Conversation invited() {
    Conversation talk(heard_words());
    CHECK(answer_heaviest(talk, "an apple is the most heavy").kind == FeedbackKind::recast);
    REQUIRE(answer_heaviest(talk, "an apple is the most heavy").kind == FeedbackKind::prompt);
    REQUIRE(talk.state() == Conversation::State::invited);
    return talk;
}

}  // namespace

TEST_CASE(
    "conversation: where the meaning alone was heard nothing is said of form, nor learnt of it") {
    Conversation talk(heard_words());
    for (const char* said : {"watermelon is most heavy", "a watermelon is the heaviest"}) {
        for (int i = 0; i < 4; ++i) {
            talk.ask(heaviest());
            const Mark mark = talk.hear(said, 0.9, false);
            CHECK(mark.understood);
            CHECK(mark.slot("thing") == "watermelon");
            CHECK(mark.form_errors.empty());
            CHECK_FALSE(mark.form_known);
            CHECK_FALSE(mark.form_right());  // not known is not right
            CHECK_FALSE(mark.target_right());
            const Feedback feedback = talk.respond(mark, true);
            CHECK(feedback.kind == FeedbackKind::praise);
            CHECK(feedback.text == "Yes! A watermelon is the heaviest.");
            CHECK(feedback.uptake == Uptake::none);
        }
    }
    talk.ask(heaviest());
    const Mark wrong = talk.hear("an egg is the heaviest", 0.9, false);
    CHECK(talk.respond(wrong, false).kind == FeedbackKind::wrong_meaning);
    // The ladder still stands at its foot.
    CHECK(answer_heaviest(talk, "watermelon is most heavy").kind == FeedbackKind::recast);
}

TEST_CASE("conversation: typed or heard word for word the form is known, right or not") {
    Conversation talk(heard_words());
    talk.ask(heaviest());
    CHECK(talk.hear("a watermelon is the heaviest").form_right());
    const Mark wrong = talk.hear("watermelon is most heavy", 0.9);
    CHECK(wrong.form_known);
    CHECK_FALSE(wrong.form_right());
    CHECK(talk.hear("nonsense").form_known);
    CHECK_FALSE(talk.hear("nonsense", 0.9, false).form_known);
}

TEST_CASE("conversation: a repeat whose form was not heard is neither repaired nor not") {
    for (const char* said : {"an apple is the heaviest", "an apple is the most heavy"}) {
        Conversation talk = invited();
        const Feedback feedback = talk.respond(talk.hear(said, 0.9, false), true);
        CHECK(feedback.uptake == Uptake::none);
        CHECK(feedback.text == "Yes. An apple is *the heaviest*.");
        CHECK(talk.state() == Conversation::State::done);
        // It did not clear the ladder: the third time comes the rule.
        CHECK(answer_heaviest(talk, "an apple is the most heavy").kind == FeedbackKind::rule);
    }
}

TEST_CASE("conversation: words whose form was not heard are not checked") {
    Conversation talk(heard_words());
    talk.set_form_check([](std::string_view text) {
        CheckedText checked;
        checked.corrected = checked.marked = std::string(text);
        checked.errors.push_back({ErrorCode::agreement, 0, 2, "it", "they"});
        return checked;
    });
    talk.ask(heaviest());
    CHECK(talk.respond(talk.hear("it have a ring"), true).free_errors.size() == 1);
    const Feedback meaning = talk.respond(talk.hear("it have a ring", 0.9, false), true);
    CHECK(meaning.kind == FeedbackKind::not_understood);
    CHECK(meaning.free_errors.empty());
    CHECK(meaning.text.find("In English we say") == std::string::npos);
}
