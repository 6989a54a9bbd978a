#include "hosted_lesson.h"

#include <catch2/catch.hpp>

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
    CHECK(HostedLesson().load(q + q) == "lesson.lua:2: there is already a question \"q\".");
    CHECK(HostedLesson().load("L:test { hand = 'sub/x.lua' }") ==
          "lesson.lua:2: test.hand is the name of a Lua file beside the lesson, such as "
          "\"sweep.lua\"; got \"sub/x.lua\".");
    CHECK(HostedLesson().load("L:question 'q' { prompt = '', answers = { 'a' } }") ==
          "lesson.lua:2: question.right is missing; it is a function.");
    CHECK(HostedLesson().start("for i = 1, 33 do L:listen(print) end") ==
          "lesson.lua:2: a lesson has at most 32 listeners.");
}

}  // namespace
}  // namespace fulcrum::runtime
