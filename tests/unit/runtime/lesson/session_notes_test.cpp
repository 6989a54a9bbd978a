#include "runtime/lesson/list_notes.h"
#include "runtime/lesson/question_notes.h"
#include "runtime/lesson/sentence_form.h"
#include "runtime/lesson/transcript.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

/// A program that hears the same each time, so surely.
PlanOptions hearing(const std::string& text, const std::string& confidence) {
    PlanOptions options;
    options.speech = SpeechInput::external;
    options.hearing.words = {
        "sh", "-c",
        "n=0; while read -r line; do case $line in *listen*) n=$((n+1));; *end*) echo "
        "\"{\\\"heard\\\":$n,\\\"text\\\":\\\"" +
            text + "\\\",\\\"confidence\\\":" + confidence + "}\";; esac; done"};
    return options;
}

/// Whether what is heard so surely is marked.
bool is_marked(const LessonDescription& lesson, const PlanOptions& options) {
    Play play(lesson, options);
    play.ask();
    play.session->hear_utterance(std::vector<std::int16_t>(100, 1));
    REQUIRE(find<JudgeEvent>(play.frame()) != nullptr);
    play.reply({VerdictCommand{"heaviest", true}});
    return find<AnsweredEvent>(play.frame()) != nullptr;
}

}  // namespace

TEST_CASE("list notes: what follows from nouns with a capital is looked at as it was meant") {
    LessonDescription lesson;
    for (const char* noun : {"Wooden block", "Big Ben", "toy Earth", "the Stone"}) {
        lesson.bodies.push_back(thing("it", 0.1));
        lesson.bodies.back().noun = noun;
    }
    const LessonDescription meant = with_small_nouns(lesson);
    CHECK(meant.bodies[0].noun == "wooden block");
    CHECK(meant.bodies[1].noun == "Big Ben");
    CHECK(meant.bodies[2].noun == "toy Earth");
    CHECK(meant.bodies[3].noun == "the stone");
}

TEST_CASE("question notes: a damaged dictionary of sounds is told once, and no more is lost") {
    const ScratchFolder folder;
    folder.write("words.dict", "egg EH G\nthe DH A");
    const auto notes = question_notes(two_things(), {{}, folder.file("words.dict")});
    REQUIRE(notes.size() == 2);
    CHECK(notes[0] == "the dictionary of sounds " + folder.file("words.dict") +
                          ": line 2 has \"A\", which is no sound of English; the file may be "
                          "damaged there, get it anew.");
    check_says(notes[1], {"it has no `again`"});
    CHECK(question_notes(two_things(), {{}, folder.path().string()}).size() == 2);
}

TEST_CASE("sentence form: nothing is told where nobody checks") {
    CHECK(tell_form({}, "It have two moon.").empty());
}

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

TEST_CASE("session: how surely an answer must be heard is the lesson's, else who starts it says") {
    const PlanOptions options = hearing("the apple is the heaviest", "0.5");
    LessonDescription lesson = two_things();
    CHECK(is_marked(lesson, options));  // 0.4 by default
    lesson.sureness = 0.5;
    CHECK(is_marked(lesson, options));
    lesson.sureness = 0.6;
    CHECK_FALSE(is_marked(lesson, options));
    PlanOptions asked = options;
    asked.hearing.sureness = 0.3;
    CHECK(is_marked(lesson, asked));
    asked.hearing.sureness = 0.51;
    lesson.sureness = 0.0;
    CHECK_FALSE(is_marked(lesson, asked));
}

TEST_CASE("session: what is typed is sure, whatever is said of hearing") {
    LessonDescription lesson = two_things();
    lesson.sureness = 1.0;
    Play play(lesson, hearing("", "0"));
    play.frame();
    play.say_rightly("the apple is the heaviest");
    CHECK(find<AnsweredEvent>(play.frame()) != nullptr);
}

TEST_CASE("session: how surely had to be heard is kept, where somebody hears") {
    const auto kept = [](const PlanOptions& options) {
        Play play(two_things(), options);
        const auto& settings = play.store.data.sessions.at(0).settings;
        const auto found =
            std::ranges::find(settings, "sureness", [](const auto& s) { return s.first; });
        return found == settings.end() ? std::string() : found->second;
    };
    PlanOptions options = hearing("", "0");
    CHECK(kept({}).empty());
    CHECK(kept(options) == "0.400000");
    options.hearing.sureness = 0.75;
    CHECK(kept(options) == "0.750000");
}
