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

TEST_CASE("lesson: tries and sureness arrive") {
    HostedLesson usual;
    REQUIRE(usual.load("") == "");
    CHECK(usual.host->description().tries == dialogue::ConversationSettings{}.tries);
    CHECK(usual.host->description().sureness == dialogue::ConversationSettings{}.least_confidence);
    HostedLesson own;
    own.says = ", tries = 2, sureness = 0.75";
    REQUIRE(own.load("") == "");
    CHECK(own.host->description().tries == 2);
    CHECK(own.host->description().sureness == 0.75);
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
}

}  // namespace
}  // namespace fulcrum::runtime
