#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// A lesson that knows what colour a thing has; `answers` of its question.
LessonDescription knowing(const std::string& answers) {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {answers};
    KnowledgeDescription colour;
    colour.id = "colour";
    colour.asked = {"what colour is the {thing}"};
    colour.line = 9;
    lesson.knowledge = {colour};
    return lesson;
}

/// Told by the lesson, as the learner sees it.
std::string told(Play& play) {
    play.reply({TellCommand{"colour", "It is red."}});
    return play.session->hud().feedback;
}

}  // namespace

TEST_CASE("asking: between questions what is asked is answered by the lesson") {
    Play play(knowing("the {thing} is the <superlative:heavy>"));
    play.frame();
    play.reply();
    const auto asked = Play::told<AskedEvent>(play.hear("What colour is the apple?"));
    CHECK(asked.knowledge == "colour");
    CHECK(told(play) == "It is red.");
}

TEST_CASE("asking: a question that is open comes first") {
    Play play(knowing("the {thing} is the <superlative:heavy>"));
    play.ask();
    const LessonFrame& frame = play.hear("What colour is the apple?");
    CHECK(find<AskedEvent>(frame) == nullptr);
    CHECK(find<AnsweredEvent>(frame) == nullptr);
    play.reply();
    CHECK(play.session->hud().question_open);
    CHECK(play.store.data.attempts.empty());
}

TEST_CASE("asking: what nobody knows while a question is open is told so, and closes nothing") {
    for (const bool knows : {true, false}) {
        LessonDescription lesson = knowing("the {thing} is the <superlative:heavy>");
        if (!knows) {
            lesson.knowledge.clear();
        }
        Play play(lesson);
        play.ask();
        for (const char* asked :
             {"Can I eat it?", "why is it red", "Where do you come from?", "And is it good?",
              "Have you got a dog?", "how many are there", "tell me more"}) {
            CAPTURE(asked);
            CHECK(find<AnsweredEvent>(play.hear(asked)) == nullptr);
            play.reply();
            CHECK(play.session->hud().question_open);
            CHECK(play.session->hud().feedback == "[knowledge.unknown_now]");
        }
        CHECK(play.store.data.attempts.empty());
        // What is an answer, or would be one, goes on being one.
        play.hear("is the heaviest");
        play.reply();
        CHECK(play.session->hud().feedback != "[knowledge.unknown_now]");
        CHECK(play.store.data.attempts.size() == 1);
        play.hear("the apple is the heaviest?");
        play.reply({VerdictCommand{"heaviest", true}});
        CHECK(play.store.data.attempts.size() == 2);
    }
}

TEST_CASE("asking: who asked while a question is open is waited for anew") {
    Play play(knowing("the {thing} is the <superlative:heavy>"));
    play.ask();
    const double asked_at_s = play.session->hud().question_asked_at_s;
    for (const char* asked : {"What colour is the apple?", "Can I eat it?"}) {
        play.hear(asked);
        play.reply();
        CHECK(play.session->hud().question_asked_at_s > asked_at_s);
        CHECK(play.session->listens());
    }
}

TEST_CASE("asking: where the question's own answers ask, what is asked is right, and answered") {
    Play play(knowing("how heavy is the {thing}"));
    play.ask();
    const LessonFrame& frame = play.hear("What colour is the apple?");
    const auto* asked = find<AskedEvent>(frame);
    const auto* answered = find<AnsweredEvent>(frame);
    REQUIRE(asked != nullptr);
    REQUIRE(answered != nullptr);
    CHECK(answered->right);
    CHECK(answered->over);
    CHECK(answered->slots == std::vector<std::pair<std::string, std::string>>{{"thing", "apple"}});
    // Praise and answer stand together.
    const std::string shown = told(play);
    CHECK(shown.size() > std::string("It is red.").size());
    CHECK(shown.ends_with(" It is red."));
    CHECK_FALSE(play.session->hud().question_open);
    REQUIRE(play.store.data.attempts.size() == 1);
    CHECK(play.store.data.attempts[0].meaning_right);
}

TEST_CASE("asking: what nobody knows is no answer, and the question stays") {
    Play play(knowing("how heavy is the {thing}"));
    play.ask();
    CHECK(find<AnsweredEvent>(play.hear("Why is the apple red?")) == nullptr);
    play.reply();
    CHECK(play.session->hud().question_open);
    CHECK(play.session->hud().feedback == "[knowledge.unknown]");
    // What asks for nothing is not understood, as ever.
    CHECK(find<AnsweredEvent>(play.hear("bla bla")) == nullptr);
    play.reply();
    CHECK(play.session->hud().feedback != "[knowledge.unknown]");
}
