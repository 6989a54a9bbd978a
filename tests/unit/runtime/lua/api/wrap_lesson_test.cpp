#include "dialogue/conversation/conversation.h"
#include "tests/unit/runtime/lua/hosted_lesson.h"

#include <catch2/catch.hpp>

#include <string>
#include <utility>

namespace fulcrum::runtime {
namespace {

using test::HostedLesson;

TEST_CASE("lesson: head, questions and tests arrive, with their lines") {
    HostedLesson lesson;
    REQUIRE(
        lesson.load("\nL:question \"heaviest\" {\n prompt = 'Which?', answers = { 'the "
                    "{thing}' }, right = print }\n"
                    "L:question('lightest', { prompt = 'Which?', answers = { 'a' }, again = 'Lift "
                    "both.', right = print })\nL:test { hand = 'sweep.lua', say = { 'a' }, expect "
                    "= {} }") == "");
    const LessonDescription& d = lesson.host->description();
    CHECK((d.id == "t" && d.title == "T"));
    REQUIRE(d.questions.size() == 2);
    CHECK((d.questions[0].id == "heaviest" && d.questions[0].prompt == "Which?"));
    CHECK(d.questions[0].line == 3);
    CHECK((d.questions[1].id == "lightest" && d.questions[1].line == 5));
    CHECK((d.questions[0].again.empty() && d.questions[1].again == "Lift both."));
    CHECK((d.tests.at(0).hand == "sweep.lua" && d.tests[0].say == std::vector<std::string>{"a"} &&
           d.tests[0].line == 6));
}

TEST_CASE("lesson: one lesson, questions of different names, hands beside it") {
    CHECK(HostedLesson().load("lesson { id = 'u', title = 'U' }") ==
          "lesson.lua:2: a file makes one lesson; this is the second lesson{…}.");
    const std::string q = "L:question 'q' { prompt = '', answers = { 'a' }, right = print } ";
    CHECK(HostedLesson().load(q + q) ==
          "lesson.lua:2: there is already a question \"q\"; give this one another name.");
    CHECK(HostedLesson().load("L:test { hand = 'sub/x.lua' }") ==
          "lesson.lua:2: test.hand is the name of a Lua file beside the lesson, such as "
          "\"sweep.lua\"; got \"sub/x.lua\".");
    CHECK(HostedLesson().load("L:question 'q' { prompt = '', answers = { 'a' } }") ==
          "lesson.lua:2: question.right is missing; it is a function.");
    CHECK(HostedLesson().start("for i = 1, 33 do L:listen(print) end") ==
          "lesson.lua:2: a lesson has at most 32 listeners.");
}

TEST_CASE("lesson: tries and sureness arrive, and their ranges are told") {
    const auto load = [](const std::string& fields) {
        HostedLesson lesson;
        lesson.says = fields;
        const std::string error = lesson.load("");
        return std::pair(error, error.empty() ? lesson.host->description() : LessonDescription{});
    };
    CHECK(load("").second.tries == dialogue::ConversationSettings{}.tries);
    CHECK(load("").second.sureness == dialogue::ConversationSettings{}.least_confidence);
    const auto [error, given] = load(", tries = 2, sureness = 0.75");
    CHECK(error.empty());
    CHECK(given.tries == 2);
    CHECK(given.sureness == 0.75);
    CHECK(load(", tries = 0").first ==
          "lesson.lua:1: lesson.tries is a whole number, 1 to 20; got 0.");
    CHECK(load(", tries = 21").first ==
          "lesson.lua:1: lesson.tries is a whole number, 1 to 20; got 21.");
    CHECK_FALSE(load(", tries = 1.5").first.empty());
    CHECK(load(", sureness = 1.5").first == "lesson.lua:1: lesson.sureness is 0 to 1; got 1.5.");
    CHECK_FALSE(load(", sureness = 'much'").first.empty());
}

TEST_CASE("lesson: examples of a question and a test's learner arrive") {
    HostedLesson lesson;
    REQUIRE(lesson.load("L:question 'q' { prompt = '', answers = { 'a' }, right = print,\n"
                        "  examples = { right = { 'a', 'b' }, form = { 'c' } } }\n"
                        "L:test { learner = { wrong = 0.25, form = 0.5 } }") == "");
    const LessonDescription& d = lesson.host->description();
    CHECK(d.questions.at(0).examples.right == std::vector<std::string>{"a", "b"});
    CHECK(d.questions[0].examples.wrong.empty());
    CHECK(d.questions[0].examples.form == std::vector<std::string>{"c"});
    REQUIRE(d.tests.at(0).learner);
    CHECK((d.tests[0].learner->wrong == 0.25 && d.tests[0].learner->form == 0.5 &&
           d.tests[0].learner->unclear == 0.0));
    CHECK(HostedLesson().load("L:test { say = { 'a' }, learner = {} }") ==
          "lesson.lua:2: test has say and learner; leave out one of them.");
    CHECK(HostedLesson().load("L:test { learner = { wrong = 2 } }") ==
          "lesson.lua:2: test.learner.wrong is 0 to 1; got 2.");
}

TEST_CASE("lesson: its level is one of English") {
    const auto sentence = [](const std::string& level) {
        HostedLesson lesson;
        lesson.message.lesson = {
            "lesson.lua", "return lesson { id = 'a', title = 'A', level = '" + level + "' }"};
        LessonHost host(lesson.message, {});
        const auto error = host.load();
        return error ? to_sentence(to_error(*error)) : "";
    };
    for (const std::string_view level : kEnglishLevels) {
        CHECK(sentence(std::string(level)) == "");
    }
    for (const char* level : {"Z9", "a1", "", "A1 "}) {
        CHECK(sentence(level) ==
              std::string("lesson.lua:1: lesson.level is A1, A2, B1, B2, C1 or C2; got \"") +
                  level + "\".");
    }
}

TEST_CASE("lesson: a test expects only what a lesson ends with") {
    const auto sentence = [](const std::string& expect) {
        return HostedLesson().load("L:test { expect = { " + expect + " } }");
    };
    CHECK(sentence("finished = true, stars = 3, score = -7, level = 1, attempts = 2, caught = 0, "
                   "form_errors = 1") == "");
    CHECK(sentence("scor = 7") ==
          "lesson.lua:2: test.expect has no \"scor\"; did you mean \"score\"?");
    CHECK(sentence("happiness = 7") ==
          "lesson.lua:2: test.expect has no \"happiness\"; it has finished, stars, score, level, "
          "attempts, caught and form_errors.");
    CHECK(sentence("score = 7.5") == "lesson.lua:2: test.expect.score is a whole number; got 7.5.");
    CHECK(
        sentence("score = '-'") ==
        "lesson.lua:2: test.expect.score is a number, true or false; got the text \"-\"; take its "
        "quotation marks away.");
    CHECK(sentence("score = true") ==
          "lesson.lua:2: test.expect.score is a whole number; got true.");
    CHECK(sentence("finished = 1") ==
          "lesson.lua:2: test.expect.finished is true or false; got 1.");
}

}  // namespace
}  // namespace fulcrum::runtime
