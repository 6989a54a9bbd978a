#include "runtime/lesson/list_notes.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

// What is told of a word with a capital, where it stands.
std::string note(const std::string& place, const std::string& word, const std::string& where,
                 const std::string& small) {
    return "lesson.lua:" + place + ": " + "\"" + word + "\" in the " + where +
           " has a capital, so it is taken for a name, which has no article; write \"" + small +
           "\", if it is none.";
}

}  // namespace

TEST_CASE("list notes: a common noun with a capital is told once, where it stands first") {
    LessonDescription lesson;
    QuestionDescription question;
    question.id = "which";
    question.line = 4;
    question.lists = {{"fruit", {"Apple", "a pear|the Banana", "Apple pie"}}};
    lesson.questions = {question, question};
    KnowledgeDescription known;
    known.id = "colour";
    known.line = 9;
    known.lists = {{"fruit", {"Apple", "Egg"}}};
    lesson.knowledge = {known};
    CHECK(list_notes(lesson) ==
          std::vector<std::string>{
              note("4: question \"which\"", "Apple", "list \"fruit\"", "apple"),
              note("4: question \"which\"", "Banana", "list \"fruit\"", "banana"),
              note("9: what the lesson knows as \"colour\"", "Egg", "list \"fruit\"", "egg")});
}

TEST_CASE("list notes: a body's noun with a capital is told at the body, and not again in a list") {
    LessonDescription lesson;
    lesson.bodies.resize(3);
    lesson.bodies[0].name = "it";
    lesson.bodies[0].noun = "Stone";
    lesson.bodies[0].line = 3;
    lesson.bodies[1].noun = "Earth";
    lesson.bodies[2].noun = "toy Earth";
    QuestionDescription question;
    question.lists = {{"what", {"Stone"}}};
    lesson.questions = {question};
    CHECK(list_notes(lesson) ==
          std::vector<std::string>{note("3", "Stone", "noun of \"it\"", "stone")});
}

TEST_CASE("list notes: names, units and small letters are passed over") {
    LessonDescription lesson;
    QuestionDescription question;
    question.lists = {{"what",
                       {"Earth|the Earth", "Earth's gravity", "the Moon", "Mercury", "N",
                        "Newton|Isaac Newton", "Archimedes", "apple", "Jane", "May", "", "|"}}};
    lesson.questions = {question};
    CHECK(list_notes(lesson).empty());
}

TEST_CASE("list notes: an adjective with a capital before a small noun begins no name") {
    LessonDescription lesson;
    lesson.bodies.resize(4);
    lesson.bodies[0].name = "wood";
    lesson.bodies[0].noun = "Wooden block";
    lesson.bodies[0].line = 3;
    lesson.bodies[1].noun = "Big Ben";
    lesson.bodies[2].noun = "toy Earth";
    lesson.bodies[3].noun = "the Stone";
    lesson.bodies[3].line = 6;
    const auto notes = list_notes(lesson);
    REQUIRE(notes.size() == 2);
    CHECK(notes[0] == note("3", "Wooden", "noun of \"wood\"", "wooden"));
    // What follows from them is looked at as it was meant.
    const LessonDescription meant = with_small_nouns(lesson);
    CHECK(meant.bodies[0].noun == "wooden block");
    CHECK(meant.bodies[1].noun == "Big Ben");
    CHECK(meant.bodies[2].noun == "toy Earth");
    CHECK(meant.bodies[3].noun == "the stone");
}
