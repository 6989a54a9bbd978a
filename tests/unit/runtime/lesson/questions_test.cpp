#include "runtime/lesson/questions.h"

#include "tests/unit/runtime/lesson/session_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

using Strings = std::vector<std::string>;
using Lists = std::vector<std::pair<std::string, Strings>>;
using Rules = std::vector<std::pair<std::string, std::string>>;

// Two things, and the question "heaviest" of line 7 with these.
LessonDescription with(const Strings& answers, const Lists& lists = {}, const Rules& rules = {}) {
    LessonDescription lesson = two_things();
    lesson.questions[0].answers = answers;
    lesson.questions[0].lists = lists;
    lesson.questions[0].rules = rules;
    return lesson;
}

dialogue::Question question_of(const LessonDescription& lesson) {
    return value_of(compile_questions(lesson)).at("heaviest");
}

dialogue::Mark mark(const LessonDescription& lesson, const std::string& said) {
    return dialogue::mark_answer(question_of(lesson), said);
}

const Lists kSides{{"side", {"left", "right"}}};
const Lists kMaterials{{"material", {"metal", "wood"}}, {"feel", {"hard", "soft"}}};

}  // namespace

TEST_CASE("questions: slots are of the scene, or of the teacher's lists, which win") {
    const Strings usual = two_things().questions[0].answers;
    const Strings compares{"the {thing} is <comparative:heavy> than the {other}"};
    const Strings made{"[the|a|an] {thing} <made_of:{material}>",
                       "[the|a|an] {thing} is <adjective:{feel}> and <adjective:{feel:also}>"};
    const struct {
        LessonDescription lesson;
        const char *said, *slot, *value;  // no slot: not understood
    } rows[] = {
        {with(usual), "an egg is the heaviest", "thing", "egg"},
        {with(usual), "a planet is the heaviest", "", ""},
        {with(usual, {{"thing", {"planet"}}}), "a planet is the heaviest", "thing", "planet"},
        {with(compares), "the apple is heavier than the egg", "thing", "apple"},
        {with(compares), "the apple is heavier than the egg", "other", "egg"},
        // What a thing is made of, and how it feels.
        {with(made, kMaterials), "the egg is make of wood", "thing", "egg"},
        {with(made, kMaterials), "the egg is make of wood", "material", "wood"},
        {with(made, kMaterials), "an apple is hard soft", "feel", "hard"},
        {with(made, kMaterials), "an apple is hard soft", "also", "soft"},
    };
    for (const auto& row : rows) {
        CAPTURE(row.said, row.slot);
        const dialogue::Mark marked = mark(row.lesson, row.said);
        CHECK(marked.understood == !std::string(row.slot).empty());
        CHECK(marked.slot(row.slot) == row.value);
    }
}

TEST_CASE("questions: what cannot work is one sentence with its line and what was meant") {
    const struct {
        LessonDescription lesson;
        const char* told;
    } rows[] = {
        {with({"the {thng} is the <superlative:heavy>"}),
         "there is no list \"thng\"; did you mean thing?"},
        {with({"the {planet} is the <superlative:heavy>"}),
         "there is no list \"planet\"; the lists are: thing, other"},
        {with({"the {thing is"}), "lesson.lua:7: question \"heaviest\", answer 1, letter 5: "},
        {with({"the apple is red"}, {{"colour", {"red"}}}),
         "lesson.lua:7: question \"heaviest\": no sentence has {colour}; write {colour} where its "
         "words belong, or take it out."},
        // What no sentence uses was forgotten; a name that none has was meant for another.
        {with({"it is on the {side}"}, kSides, {{"far", "far away"}}),
         "lesson.lua:7: question \"heaviest\": no sentence has <far>; write <far> where its words "
         "belong, or take it out."},
        {with({"it is <plase>"}, kSides, {{"place", "on the {side}"}}),
         "there is no rule <plase>; did you mean <place>?"},
        {with({"it is <place>"}, kSides, {{"place", "at <place>"}}), "uses itself"},
        // The slots of grammar.
        {with({"the {thing} <made_of:{materiel}>"}, kMaterials),
         "there is no list \"materiel\"; did you mean material?"},
        {with({"the {thing} <made_of>"}, kMaterials), "<made_of> needs a word"},
        {with({"the {thing} <made_off:metal>"}, kMaterials), "did you mean <made_of:word>?"},
        {with({"the {thing} is <adjective:{fel}>"}, kMaterials),
         "there is no list \"fel\"; did you mean feel?"},
        {with({"the {thing} is <adjective:{feel}> and <adjective:{feel}>"}, kMaterials),
         "filled twice"},
        {with({"the {thing} is <adjective:{feel>"}, kMaterials), "closed"},
    };
    for (const auto& row : rows) {
        const std::string told = refusal_of(compile_questions(row.lesson));
        check_says(told, {row.told});
        CHECK_THAT(told, Catch::StartsWith("lesson.lua:7: "));
        // What is given with its end is the whole sentence.
        CHECK((told == row.told || !std::string_view(row.told).ends_with('.')));
    }
    // Without bodies nothing is a thing of the scene; two questions of one name are refused.
    LessonDescription lesson = two_things();
    lesson.bodies.clear();
    check_says(refusal_of(compile_questions(lesson)),
               {"there is no list \"thing\"; the lists are: none"});
    lesson = two_things();
    lesson.questions.push_back(lesson.questions[0]);
    CHECK_FALSE(compile_questions(lesson));
}

TEST_CASE("questions: a list may stand in any form of slot") {
    for (const char* answer :
         {"the apple is {colour}", "it is {colour:first}", "it is <adjective:{colour}>"}) {
        INFO(answer);
        CHECK(compile_questions(with({answer}, {{"colour", {"red"}}})));
    }
}

TEST_CASE("questions: what the teacher wants said after a wrong meaning is kept") {
    LessonDescription lesson = two_things();
    CHECK(question_of(lesson).again.empty());
    lesson.questions[0].again = "Let's weigh them again.";
    CHECK(question_of(lesson).again == "Let's weigh them again.");
}

TEST_CASE("questions: a rule stands for what several sentences have, and may use another") {
    const LessonDescription lesson =
        with({"it is <place>", "the {thing} is <place>"}, kSides,
             {{"place", "(<below>|on the {side})"}, {"below", "under the table"}});
    const auto left = mark(lesson, "the egg is on the left");
    CHECK(left.slot("thing") == "egg");
    CHECK(left.slot("side") == "left");
    CHECK(left.form_right());
    CHECK(mark(lesson, "it is under the table").form_right());
    CHECK_FALSE(mark(lesson, "it is place").understood);
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
