#include "runtime/lesson/questions.h"

#include "tests/unit/runtime/lesson/session_fixture.h"

#include <catch2/catch.hpp>

using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

TEST_CASE("questions: a {thing} without a list means the nouns of the scene") {
    const auto questions = compile_questions(two_things());
    REQUIRE(questions.has_value());
    const auto& question = questions->at("heaviest");
    CHECK(fulcrum::dialogue::mark_answer(question, "an egg is the heaviest").slot("thing") ==
          "egg");
    CHECK_FALSE(fulcrum::dialogue::mark_answer(question, "a planet is the heaviest").understood);
}

TEST_CASE("questions: {other} is a second thing of the scene") {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {"the {thing} is <comparative:heavy> than the {other}"};
    const auto mark = fulcrum::dialogue::mark_answer(compile_questions(lesson)->at("heaviest"),
                                                     "the apple is heavier than the egg");
    CHECK(mark.slot("thing") == "apple");
    CHECK(mark.slot("other") == "egg");
}

TEST_CASE("questions: a list that isn't there is named, with its line and what was meant") {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {"the {thng} is the <superlative:heavy>"};
    const auto slip = compile_questions(lesson);
    REQUIRE_FALSE(slip.has_value());
    CHECK(slip.error().where == "lesson.lua:7");
    CHECK_THAT(slip.error().message,
               Catch::Contains("there is no list \"thng\"; did you mean thing?"));
    lesson.questions[0].answers = {"the {planet} is the <superlative:heavy>"};
    CHECK_THAT(compile_questions(lesson).error().message,
               Catch::Contains("there is no list \"planet\"; the lists are: thing, other"));
    // Without bodies nothing is a thing of the scene.
    lesson.bodies.clear();
    lesson.questions[0].answers = {"the {thing} is the <superlative:heavy>"};
    CHECK_THAT(compile_questions(lesson).error().message,
               Catch::Contains("there is no list \"thing\"; the lists are: none"));
}

TEST_CASE("questions: what the teacher wants said after a wrong meaning is kept") {
    LessonDescription lesson = two_things();
    CHECK(compile_questions(lesson)->at("heaviest").again.empty());
    lesson.questions[0].again = "Let's weigh them again.";
    CHECK(compile_questions(lesson)->at("heaviest").again == "Let's weigh them again.");
}

TEST_CASE("questions: the teacher's own list wins over the scene's nouns") {
    LessonDescription lesson = two_things();
    lesson.questions[0].lists = {{"thing", {"planet"}}};
    const auto questions = compile_questions(lesson);
    REQUIRE(questions.has_value());
    CHECK(fulcrum::dialogue::mark_answer(questions->at("heaviest"), "a planet is the heaviest")
              .understood);
}

TEST_CASE(
    "questions: a template that cannot work names line and letter; two of one name are refused") {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {"the {thing is"};
    const auto bad = compile_questions(lesson);
    REQUIRE_FALSE(bad.has_value());
    CHECK(bad.error().where == "lesson.lua:7");
    CHECK_THAT(to_sentence(bad.error()),
               Catch::StartsWith("lesson.lua:7: question \"heaviest\", answer 1, letter 5: "));

    lesson = two_things();
    lesson.questions.push_back(lesson.questions[0]);
    CHECK_FALSE(compile_questions(lesson).has_value());
}

TEST_CASE("questions: a list that no sentence has is a slot that was forgotten") {
    LessonDescription lesson = two_things();
    lesson.questions[0].lists = {{"colour", {"red"}}};
    lesson.questions[0].answers = {"the apple is red"};
    const auto bad = compile_questions(lesson);
    REQUIRE_FALSE(bad.has_value());
    CHECK(to_sentence(bad.error()) ==
          "lesson.lua:7: question \"heaviest\": no sentence has {colour}; write {colour} "
          "where its words belong, or take it out.");
    for (const char* answer :
         {"the apple is {colour}", "it is {colour:first}", "it is <adjective:{colour}>"}) {
        INFO(answer);
        lesson.questions[0].answers = {answer};
        CHECK(compile_questions(lesson).has_value());
    }
}

TEST_CASE("questions: a rule stands for what several sentences have, and may use another") {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {"it is <place>", "the {thing} is <place>"};
    lesson.questions[0].lists = {{"side", {"left", "right"}}};
    lesson.questions[0].rules = {{"place", "(<below>|on the {side})"},
                                 {"below", "under the table"}};
    const auto questions = compile_questions(lesson);
    REQUIRE(questions.has_value());
    const auto& question = questions->at("heaviest");
    const auto mark = fulcrum::dialogue::mark_answer(question, "the egg is on the left");
    CHECK(mark.slot("thing") == "egg");
    CHECK(mark.slot("side") == "left");
    CHECK(mark.form_right());
    CHECK(fulcrum::dialogue::mark_answer(question, "it is under the table").form_right());
    CHECK_FALSE(fulcrum::dialogue::mark_answer(question, "it is place").understood);
    // What nobody uses was forgotten; a name that none has was meant for another.
    lesson.questions[0].rules.emplace_back("far", "far away");
    CHECK(to_sentence(compile_questions(lesson).error()) ==
          "lesson.lua:7: question \"heaviest\": no sentence has <far>; write <far> where its words "
          "belong, or take it out.");
    lesson.questions[0].rules.pop_back();
    lesson.questions[0].answers = {"it is <plase>"};
    CHECK_THAT(to_sentence(compile_questions(lesson).error()),
               Catch::Contains("there is no rule <plase>; did you mean <place>?"));
    lesson.questions[0].rules = {{"place", "at <place>"}};
    lesson.questions[0].answers = {"it is <place>"};
    CHECK_THAT(to_sentence(compile_questions(lesson).error()), Catch::Contains("uses itself"));
}

TEST_CASE("questions: a {thing} may be movable, solid or neither") {
    LessonDescription lesson = two_things();
    lesson.bodies[0].movable = false;
    lesson.bodies[0].solid = true;
    lesson.bodies[1].movable = false;
    const auto questions = compile_questions(lesson);
    REQUIRE(questions.has_value());
    for (const BodyDescription& body : lesson.bodies) {
        CHECK(fulcrum::dialogue::mark_answer(questions->at("heaviest"),
                                             "the " + body.noun + " is the heaviest")
                  .slot("thing") == body.noun);
    }
}

TEST_CASE("questions: mistakes in the slots of grammar have their line and say what was meant") {
    const struct {
        const char *answer, *part;
    } rows[] = {
        {"the {thing} <made_of:{materiel}>",
         "there is no list \"materiel\"; did you mean material?"},
        {"the {thing} <made_of>", "<made_of> needs a word"},
        {"the {thing} <made_off:metal>", "did you mean <made_of:word>?"},
        {"the {thing} is <adjective:{fel}>", "there is no list \"fel\"; did you mean feel?"},
        {"the {thing} is <adjective:{feel}> and <adjective:{feel}>", "filled twice"},
        {"the {thing} is <adjective:{feel>", "closed"},
    };
    for (const auto& row : rows) {
        INFO(row.answer);
        LessonDescription lesson = two_things();
        lesson.questions[0].answers = {row.answer};
        lesson.questions[0].lists = {{"material", {"metal", "wood"}}, {"feel", {"hard", "soft"}}};
        const auto bad = compile_questions(lesson);
        REQUIRE_FALSE(bad.has_value());
        CHECK(bad.error().where == "lesson.lua:7");
        CHECK_THAT(bad.error().message, Catch::Contains(row.part));
    }
}

TEST_CASE(
    "questions: what a thing of the scene is made of, and how it feels, are slots of the answer") {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = {
        "[the|a|an] {thing} <made_of:{material}>",
        "[the|a|an] {thing} is <adjective:{feel}> and <adjective:{feel:also}>"};
    lesson.questions[0].lists = {{"material", {"metal", "wood"}}, {"feel", {"hard", "soft"}}};
    const auto questions = compile_questions(lesson);
    REQUIRE(questions.has_value());
    const auto& question = questions->at("heaviest");
    const auto made = fulcrum::dialogue::mark_answer(question, "the egg is make of wood");
    CHECK(made.slot("thing") == "egg");
    CHECK(made.slot("material") == "wood");
    const auto feels = fulcrum::dialogue::mark_answer(question, "an apple is hard soft");
    CHECK(feels.slot("feel") == "hard");
    CHECK(feels.slot("also") == "soft");
}

TEST_CASE("questions: scenery without a noun is no answer") {
    LessonDescription lesson = two_things();
    BodyDescription tree;
    tree.name = tree.noun = "tree";
    lesson.bodies.push_back(tree);
    const auto understands = [&](const char* said) {
        const auto questions = compile_questions(lesson);
        REQUIRE(questions.has_value());
        return fulcrum::dialogue::mark_answer(questions->at("heaviest"), said).understood;
    };
    CHECK(understands("a tree is the heaviest"));
    lesson.bodies.back().noun.clear();
    CHECK_FALSE(understands("a tree is the heaviest"));
    CHECK(understands("an egg is the heaviest"));
}

TEST_CASE(
    "questions: each has its own ladder of feedback, the lesson's, or the one that is chosen") {
    using enum fulcrum::dialogue::FeedbackStep;
    using Ladder = fulcrum::dialogue::FeedbackLadder;
    LessonDescription lesson = two_things();
    const auto ladder = [&] { return compile_questions(lesson)->at("heaviest").ladder; };
    CHECK(ladder().empty());
    lesson.feedback = {rule};
    CHECK(ladder() == Ladder{rule});
    lesson.questions[0].feedback = {prompt, replay};
    CHECK(ladder() == Ladder{prompt, replay});
    choose_feedback(lesson, {});
    CHECK(ladder() == Ladder{prompt, replay});
    choose_feedback(lesson, {recast});
    CHECK(ladder() == Ladder{recast});
}
