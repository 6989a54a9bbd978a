// What a lesson and who stands beside the learner say of a conversation: how many tries there are, how surely an answer must be heard.
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

TEST_CASE("session: a question is left after as many wrong answers as the lesson says") {
    const int tries = GENERATE(1, 2, 4, 7);
    LessonDescription lesson = two_things();
    CHECK(lesson.tries == 4);
    lesson.tries = tries;
    Play play(lesson);
    play.frame();
    for (int i = 1; i <= tries; ++i) {
        CAPTURE(i);
        play.reply({AskCommand{"heaviest"}});
        const AnsweredEvent answered = play.answer("the egg is the heaviest", false);
        CHECK_FALSE(answered.right);
        CHECK(answered.over == (i == tries));
    }
    CHECK(play.store.data.attempts.back().feedback == "moved_on");
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
