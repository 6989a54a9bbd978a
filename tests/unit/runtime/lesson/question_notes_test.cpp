#include "runtime/lesson/question_notes.h"

#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/lesson/session_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

LessonDescription with_answers(std::vector<std::string> answers) {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = std::move(answers);
    lesson.questions[0].again = "Weigh them again.";
    return lesson;
}

}  // namespace

TEST_CASE("question notes: a question without a hint is told with its line") {
    LessonDescription lesson = two_things();
    lesson.questions[0].again.clear();
    const auto notes = question_notes(lesson, "/nowhere");
    REQUIRE(notes.size() == 1);
    CHECK(notes[0] ==
          "lesson.lua:7: question \"heaviest\": it has no `again`, so after a wrong "
          "answer no hint is given.");
    lesson.questions[0].again = "Weigh them again.";
    CHECK(question_notes(lesson, "/nowhere").empty());
}

TEST_CASE("question notes: what the review finds has the question's line") {
    const auto notes = question_notes(
        with_answers({"the {thing} is [very] heavy", "the {thing} is heavy"}), "/nowhere");
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0],
               Catch::StartsWith("lesson.lua:7: question \"heaviest\": answer 2 is never"));
    CHECK_THAT(notes[0], Catch::EndsWith("."));
}

TEST_CASE("question notes: words that no dictionary and no rule can say are named") {
    const ScratchFolder folder;
    folder.write("sounds", "the DH AH\nis IH Z\nheavy HH EH V IY\negg EH G\napple AE P AH L\n");
    const std::string sounds = (folder.path() / "sounds").string();
    const auto notes = question_notes(with_answers({"the {thing} is heavy and zorbly"}), sounds);
    REQUIRE(notes.size() == 1);
    CHECK_THAT(notes[0], Catch::StartsWith("lesson.lua:7: ") && Catch::Contains("nobody can hear"));
    CHECK_THAT(notes[0], Catch::Contains("\"zorbly\""));
    CHECK_THAT(notes[0], !Catch::Contains("\"egg\"") && !Catch::Contains("\"heavy\""));
}

TEST_CASE("question notes: questions that do not compile have none") {
    CHECK(question_notes(with_answers({"the {thng} is heavy"}), "/nowhere").empty());
}
