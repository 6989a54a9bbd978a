#include "runtime/lesson/speech.h"

#include "runtime/lesson/questions.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

Speech for_lesson(const LessonDescription& lesson) {
    return Speech::build(compile_plan(lesson, {}, nullptr).value());
}

std::shared_ptr<const dialogue::TemplateSet> some_templates() {
    return compile_questions(two_things()).value().at("heaviest").templates;
}

}  // namespace

TEST_CASE("speech: with text the recogniser that is built is the one for text") {
    PlanOptions options;
    options.speech = SpeechInput::text;
    const Plan plan = compile_plan(two_things(), options, nullptr).value();
    CHECK(plan.speech == SpeechInput::text);
    CHECK_FALSE(plan.recogniser);
    CHECK(Speech::build(plan).recogniser_name() == name_of(plan.speech));
    CHECK(name_of(plan.speech) == "text");
}

TEST_CASE("speech: a lesson without questions has nobody who listens") {
    LessonDescription lesson = two_things();
    lesson.questions.clear();
    Speech speech = for_lesson(lesson);
    CHECK(speech.recogniser_name() == "null");
    REQUIRE(speech.listen(some_templates()));
    speech.type("the apple");
    CHECK_FALSE(speech.poll());
}

TEST_CASE("speech: typed words are heard once, and only if somebody listened then") {
    Speech speech = for_lesson(two_things());
    speech.type("too early");
    REQUIRE(speech.listen(some_templates()));
    CHECK_FALSE(speech.poll());
    speech.type("the apple");
    const auto heard = value_of(speech.poll());
    CHECK(heard.text == "the apple");
    CHECK(heard.confidence == 1.0);
    CHECK_FALSE(speech.listening());
    CHECK_FALSE(speech.poll());
}

TEST_CASE("speech: what was typed for one question does not answer the next") {
    Speech speech = for_lesson(two_things());
    REQUIRE(speech.listen(some_templates()));
    speech.type("the apple");
    SECTION("asked in its place") {}
    SECTION("asked after a while") {
        speech.stop_listening();
        CHECK_FALSE(speech.listening());
    }
    REQUIRE(speech.listen(some_templates()));
    CHECK_FALSE(speech.poll());
}

TEST_CASE("speech: nothing to listen for is one sentence") {
    Speech speech = for_lesson(two_things());
    check_says(refusal_of(speech.listen(nullptr)), {"lesson.lua"});
}

TEST_CASE("speech: an instruction stands until the next, and ends the reply to the last answer") {
    Speech speech = for_lesson(two_things());
    CHECK(speech.instruction().empty());
    speech.instruct("Which one is the heaviest?");
    speech.reply("Yes. An apple is *the heaviest*.");
    speech.step(100.0);
    CHECK(speech.instruction() == "Which one is the heaviest?");
    CHECK(speech.last_reply() == "Yes. An apple is *the heaviest*.");
    speech.reply("Not yet.");
    CHECK(speech.last_reply() == "Not yet.");
    speech.step(100.0);
    speech.instruct("Catch the egg!");
    CHECK(speech.instruction() == "Catch the egg!");
    CHECK(speech.last_reply().empty());
    speech.instruct("");
    CHECK(speech.instruction().empty());
}

TEST_CASE("speech: a reply can be read to its end below the next instruction") {
    const double needed_s =
        dialogue::CaptionVoice().reading_time_s("Yes. An apple is the heaviest.");
    CHECK(needed_s > 2.5);
    Speech speech = for_lesson(two_things());
    speech.reply("Yes. An apple is *the heaviest*.");
    speech.step(1.0);
    speech.instruct("Catch the egg!");
    CHECK(speech.instruction() == "Catch the egg!");
    speech.step(needed_s - 1.1);
    CHECK(speech.last_reply() == "Yes. An apple is *the heaviest*.");
    speech.instruct("Feel the egg.");
    CHECK(speech.last_reply() == "Yes. An apple is *the heaviest*.");
    SECTION("then it ends") {
        speech.step(0.2);
        CHECK(speech.last_reply().empty());
    }
    SECTION("and the next reply stands until an instruction comes") {
        speech.reply("Not yet.");
        speech.step(100.0);
        CHECK(speech.last_reply() == "Not yet.");
    }
}

TEST_CASE("speech: where nothing is to be done a reply stands on until something is") {
    Speech speech = for_lesson(two_things());
    speech.instruct("Which one is the heaviest?");
    speech.reply("Yes.");
    speech.instruct("");
    speech.step(100.0);
    CHECK(speech.last_reply() == "Yes.");
    speech.instruct("Catch the egg!");
    CHECK(speech.last_reply().empty());
}

TEST_CASE("speech: what stands there and is being read is not said once more") {
    using Texts = std::vector<std::string>;
    Speech speech = for_lesson(two_things());
    speech.reply("It is an egg.");
    speech.instruct("It is an egg.");
    speech.instruct("It is an egg.");
    CHECK(speech.take_spoken() == Texts{"It is an egg."});
    speech.reply("It is an egg.");
    CHECK(speech.take_spoken().empty());
    speech.step(100.0);
    // Nobody reads it any more.
    speech.reply("It is an egg.");
    CHECK(speech.take_spoken() == Texts{"It is an egg."});
    speech.instruct("Catch it!");
    speech.instruct("");
    speech.instruct("Catch it!");
    CHECK(speech.take_spoken() == Texts{"Catch it!"});
}

TEST_CASE("speech: a microphone is heard only where somebody speaks to a recogniser") {
    PlanOptions options;
    options.live = true;
    const auto has_microphone = [&] {
        const auto plan = value_of(compile_plan(two_things(), options, nullptr));
        CHECK(plan.has("speech", "microphone") == plan.microphone);
        return plan.microphone;
    };
    CHECK_FALSE(has_microphone());
    options.speech = SpeechInput::sphinx;
    CHECK(has_microphone());
    options.live = false;
    CHECK_FALSE(has_microphone());
    options.live = true;
    options.hearing.recordings = {"said.wav"};
    CHECK_FALSE(has_microphone());
    options.hearing.recordings.clear();
    LessonDescription silent = two_things();
    silent.questions.clear();
    const auto plan = value_of(compile_plan(silent, options, nullptr));
    CHECK_FALSE(plan.microphone);
    CHECK_FALSE(plan.recogniser);
}
