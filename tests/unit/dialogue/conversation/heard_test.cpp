// How well an answer was heard, and whether its form was heard with it.
#include "dialogue/conversation/conversation.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

TEST_CASE("conversation: a repeat that is heard badly is asked for again, and is not unrepaired") {
    constexpr double kBadly = 0.2;
    for (const char* said : {"an apple is the most heavy", "an apple is the heaviest", "what?"}) {
        for (const bool right : {true, false}) {
            CAPTURE(said, right);
            Conversation talk = invited();
            const Feedback feedback = talk.respond(talk.hear(said, kBadly), right);
            CHECK(feedback.kind == FeedbackKind::heard_badly);
            CHECK(feedback.text == heard_words().say("feedback.heard_badly"));
            CHECK(feedback.uptake == Uptake::none);
            CHECK(feedback.ask_again);
            CHECK(talk.state() == Conversation::State::invited);
            const Feedback heard = talk.respond(talk.hear("an apple is the heaviest", 0.9), true);
            CHECK(heard.kind == FeedbackKind::praise);
            CHECK(heard.uptake == Uptake::repaired);
            CHECK(heard.attempt == 2);  // the badly heard one is none
            CHECK(talk.state() == Conversation::State::done);
        }
    }
}

TEST_CASE("conversation: nobody is held at an invitation for being heard badly") {
    Conversation talk = invited();
    for (int i = 0; i < 2; ++i) {
        CHECK(talk.respond(talk.hear("an apple is the heaviest", 0.1), true).ask_again);
    }
    const Feedback last = talk.respond(talk.hear("an apple is the heaviest", 0.1), true);
    CHECK(last.kind == FeedbackKind::heard_badly);
    CHECK_FALSE(last.ask_again);
    CHECK(last.uptake == Uptake::none);
    CHECK(last.text == "Yes. An apple is *the heaviest*.");
    CHECK(talk.state() == Conversation::State::done);
    // The next invitation begins to count anew.
    CHECK(answer_heaviest(talk, "an apple is the heaviest").kind == FeedbackKind::praise);
    CHECK(answer_heaviest(talk, "an apple is the most heavy").kind == FeedbackKind::recast);
    CHECK(answer_heaviest(talk, "an apple is the most heavy").kind == FeedbackKind::prompt);
    CHECK(talk.respond(talk.hear("an apple is the heaviest", 0.1), true).ask_again);
}

TEST_CASE(
    "conversation: however well each is heard, low confidence never says wrong, and it ends") {
    CHECK(rc::check([](const std::vector<std::pair<unsigned, bool>>& heard) {
        const std::vector<std::string_view> said = {"an apple is the most heavy", "what?",
                                                    "an apple is the heaviest", "the apple"};
        ConversationSettings settings;
        Conversation talk(heard_words(), settings);
        int asked_again = 0;
        for (const auto& [choice, well] : heard) {
            if (talk.state() == Conversation::State::idle ||
                talk.state() == Conversation::State::done) {
                talk.ask(heaviest());
                asked_again = 0;
            }
            const bool was_invited = talk.state() == Conversation::State::invited;
            const double confidence = settings.least_confidence + (well ? 0.0 : -0.01);
            const Mark mark = talk.hear(said[choice % said.size()], confidence);
            const Feedback feedback = talk.respond(mark, true);
            RC_ASSERT((feedback.kind == FeedbackKind::heard_badly) == !well);
            RC_ASSERT(well || feedback.uptake == Uptake::none);
            RC_ASSERT(!was_invited || well || talk.state() != Conversation::State::asked);
            asked_again += was_invited ? 1 : 0;
            RC_ASSERT(asked_again <= 3);
        }
    }));
}
