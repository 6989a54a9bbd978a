#include "runtime/lesson/free_english.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("free English: opened, it finds errors by its words and by its grammar") {
    const auto check = value_of(open_free_english({"egg"}));
    CHECK(check("it have two moon").corrected == "it has two moons");
    CHECK(check("I saw moon.").corrected == "I saw a moon.");
    CHECK(check("It has two moons.").errors.empty());
    CHECK(check("Egg is heavier.").corrected == "The egg is heavier.");
}

TEST_CASE("free English: things are bodies and what questions call so, by the last word") {
    LessonDescription lesson;
    for (const char* noun : {"egg", "", "wooden block", "Sun", "metal block"}) {
        lesson.bodies.emplace_back().noun = noun;
    }
    lesson.questions.emplace_back().lists = {{"thing", {"apple|red apple", "egg"}},
                                             {"number", {"two"}}};
    CHECK(things_of(lesson) == std::vector<std::string>{"egg", "block", "apple"});
}

TEST_CASE("free English: things are also the words that all answers say with an article") {
    LessonDescription lesson;
    QuestionDescription& question = lesson.questions.emplace_back();
    question.answers = {"push at the {place}",
                        "it needs a {missing}",
                        "it has no {missing}",
                        "it is near the {goal}",
                        "{goal}",
                        "it is the {force}",
                        "(a|the) {part}",
                        "it needs a {size} tail"};
    question.lists = {{"place", {"side|rim", "pole|top"}},
                      {"missing", {"tail|kite tail"}},
                      {"goal", {"hand"}},
                      {"force", {"weight", "wind"}},
                      {"part", {"knot"}},
                      {"size", {"longer|long", "short"}},
                      {"nowhere", {"book"}}};
    CHECK(things_of(lesson) == std::vector<std::string>{"side", "pole", "tail", "wind", "knot"});
}

TEST_CASE("free English: things are also the nouns that a lesson says with an article each time") {
    LessonDescription lesson;
    QuestionDescription& question = lesson.questions.emplace_back();
    question.answers = {"pull the (line|string) near the end",
                        "(my|the) hand feels the drag",
                        "[the] cloth is <adjective:light>",
                        "on top of the kite",
                        "it is in the top",
                        "make the {part} longer"};
    question.rules = {{"of", "[(of|in) the (line|rope|air)]"}};
    question.lists = {{"part", {"knot"}}, {"nothing", {"kite"}}};
    CHECK(things_of(lesson) ==
          std::vector<std::string>{"knot", "end", "hand", "line", "rope", "string"});
}
