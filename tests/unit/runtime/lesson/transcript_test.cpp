#include "runtime/lesson/transcript.h"

#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("transcript: each thing that is said is one line with its time") {
    Transcript transcript;
    transcript.begin_level(0.0, 1, "Near or far?");
    transcript.begin_level(1.0, 2, "");
    transcript.show(2.0, "");
    transcript.show(2.04, "Press.\nHarder.");
    transcript.ask(600.0, "Where?");
    const std::vector<std::string> lines = transcript.take();
    REQUIRE(lines.size() == 4);
    CHECK(lines[0] == "    0.0 s  level    1: Near or far?");
    CHECK(lines[1] == "    1.0 s  level    2");
    CHECK(lines[2] == "    2.0 s  shows    Press. Harder.");
    CHECK(lines[3] == "  600.0 s  asks     Where?");
    CHECK(transcript.take().empty());
}

TEST_CASE("transcript: an answer tells how its meaning and its form were marked") {
    MarkedAnswer answer;
    CHECK(verdict_text(answer) == "not understood");
    answer.mark.understood = true;
    CHECK(verdict_text(answer) == "wrong");
    answer.right = true;
    answer.mark.form_errors.resize(2);
    answer.mark.form_errors[0].code = dialogue::ErrorCode::missing_determiner;
    answer.mark.form_errors[1].code = dialogue::ErrorCode::adjective_form;
    CHECK(verdict_text(answer) == "right; form: M:DET, R:ADJ:FORM");
    answer.mark = without_form(std::move(answer.mark));
    CHECK(verdict_text(answer) == "right; form not heard");
}

TEST_CASE("transcript: a play tells its captions, questions, answers and levels in order") {
    Play play;
    (void)play.frame();
    LessonReply reply;
    reply.commands = {LevelCommand{1, "Two"}, CaptionCommand{"Look!"}, AskCommand{"heaviest"}};
    const auto asked = value_of(play.session->finish_frame(reply));
    REQUIRE(asked.said.size() == 3);
    CHECK_THAT(asked.said[0], Catch::EndsWith("level    1: Two"));
    CHECK_THAT(asked.said[1], Catch::EndsWith("shows    Look!"));
    CHECK_THAT(asked.said[2], Catch::EndsWith("asks     Which one is the heaviest?"));

    (void)play.hear("apple is the heaviest");
    reply.commands = {VerdictCommand{"heaviest", true}};
    const auto answered = value_of(play.session->finish_frame(reply));
    REQUIRE(answered.said.size() == 2);
    CHECK_THAT(answered.said[0],
               Catch::EndsWith("learner  apple is the heaviest (right; form: M:DET)"));
    CHECK_THAT(answered.said[1], Catch::EndsWith("answers  Yes. *An apple* is the heaviest."));
}
