#include "runtime/lesson/list_notes.h"

#include <catch2/catch.hpp>

using namespace fulcrum::runtime;

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
    CHECK(
        list_notes(lesson) ==
        std::vector<std::string>{
            "lesson.lua:4: question \"which\": \"Apple\" in the list \"fruit\" has a capital, so "
            "it is taken for a name, which has no article; write \"apple\", if it is none.",
            "lesson.lua:4: question \"which\": \"Banana\" in the list \"fruit\" has a capital, so "
            "it is taken for a name, which has no article; write \"banana\", if it is none.",
            "lesson.lua:9: what the lesson knows as \"colour\": \"Egg\" in the list \"fruit\" has "
            "a capital, so it is taken for a name, which has no article; write \"egg\", if it is "
            "none."});
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
    CHECK(
        list_notes(lesson) ==
        std::vector<std::string>{"lesson.lua:3: \"Stone\" in the noun of \"it\" has a capital, so "
                                 "it is taken for a name, which has no article; write "
                                 "\"stone\", if it is none."});
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
    CHECK(notes[0] ==
          "lesson.lua:3: \"Wooden\" in the noun of \"wood\" has a capital, so it is taken for a "
          "name, which has no article; write \"wooden\", if it is none.");
    // What follows from them is looked at as it was meant.
    const LessonDescription meant = with_small_nouns(lesson);
    CHECK(meant.bodies[0].noun == "wooden block");
    CHECK(meant.bodies[1].noun == "Big Ben");
    CHECK(meant.bodies[2].noun == "toy Earth");
    CHECK(meant.bodies[3].noun == "the stone");
}
