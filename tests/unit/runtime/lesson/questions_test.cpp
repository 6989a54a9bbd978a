#include "runtime/lesson/questions.h"

#include "dialogue/marking/mark_answer.h"
#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

dialogue::Question question_of(const LessonDescription& lesson) {
    return value_of(compile_questions(lesson)).at("heaviest");
}

dialogue::Mark mark(const LessonDescription& lesson, const std::string& said) {
    return dialogue::mark_answer(question_of(lesson), said);
}

}  // namespace

TEST_CASE("questions: what the teacher wants said after a wrong meaning is kept") {
    LessonDescription lesson = two_things();
    CHECK(question_of(lesson).again.empty());
    lesson.questions[0].again = "Let's weigh them again.";
    CHECK(question_of(lesson).again == "Let's weigh them again.");
}

TEST_CASE("questions: two of one name are refused") {
    LessonDescription lesson = two_things();
    lesson.questions.push_back(lesson.questions[0]);
    CHECK_FALSE(compile_questions(lesson));
}

TEST_CASE("questions: a {thing} may be movable, solid or neither; scenery has no noun") {
    LessonDescription lesson = two_things();
    lesson.bodies[0].movable = false;
    lesson.bodies[0].solid = true;
    lesson.bodies[1].movable = false;
    BodyDescription tree;
    tree.name = tree.noun = "tree";
    lesson.bodies.push_back(tree);
    for (const BodyDescription& body : lesson.bodies) {
        CHECK(mark(lesson, "the " + body.noun + " is the heaviest").slot("thing") == body.noun);
    }
    lesson.bodies.back().noun.clear();
    CHECK_FALSE(mark(lesson, "a tree is the heaviest").understood);
    CHECK(mark(lesson, "an egg is the heaviest").understood);
}

TEST_CASE("questions: each has a ladder of feedback, its own, the lesson's, or the chosen one") {
    using enum fulcrum::dialogue::FeedbackStep;
    using Ladder = fulcrum::dialogue::FeedbackLadder;
    LessonDescription lesson = two_things();
    const auto ladder = [&] { return question_of(lesson).ladder; };
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
