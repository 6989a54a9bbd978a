#include "runtime/scene/plan_hands.h"

#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

// A block between two fingers, the second one at another place and scale.
LessonDescription make_two_fingers() {
    LessonDescription lesson;
    BodyDescription block = make_solid("block", 5);
    block.model = "box";
    block.size_m = Vector3::Constant(0.06);
    block.mass_kg = 0.1;
    block.rigid.emplace();
    block.material = 0;
    lesson.bodies = {block};
    MaterialDescription wood;
    wood.felt.name = "wood";
    wood.felt.friction = {0.6, 0.5, 0.0};
    lesson.materials = {wood};
    lesson.hand.centre_W = {0.1, 0.2, 0.0};
    lesson.hand.rate_hz = 2000.0;
    lesson.more_hands.resize(1);
    lesson.more_hands[0].centre_W = {-0.1, 0.2, 0.0};
    lesson.more_hands[0].scale = 2.0;
    lesson.more_hands[0].cursor = SphereShape{0.008};
    lesson.more_hands[0].line = 4;
    return lesson;
}

Plan compile(const LessonDescription& lesson, std::size_t n_hands = kMostHands) {
    PlanOptions options;
    options.n_hands = n_hands;
    return plan_of(lesson, box_mesh, options);
}

}  // namespace

TEST_CASE("plan: a second hand has its own place, scale, cursor and springs, and all else alike") {
    const LessonDescription lesson = make_two_fingers();
    const Plan plan = compile(lesson);
    REQUIRE(plan.more_hands.size() == 1);
    const HapticPlan& first = plan.haptic;
    const HapticPlan& second = plan.more_hands[0];
    CHECK(second.workspace.pose_WD.position == Vector3(-0.1, 0.2, 0.0));
    CHECK(second.workspace.scale == 2.0);
    CHECK(second.rate_hz == 2000.0);
    CHECK(std::get<SphereShape>(second.proxy.cursor).radius_m == 0.008);
    // As stiff in either hand.
    CHECK(2.0 * second.coupling.stiffness_N_per_m == Approx(first.coupling.stiffness_N_per_m));
    REQUIRE(second.solids.size() == first.solids.size());
    CHECK(2.0 * second.solids[0].coupling->stiffness_N_per_m ==
          Approx(first.solids[0].coupling->stiffness_N_per_m));
    CHECK(second.safety.max_force_N == first.safety.max_force_N);
    REQUIRE(second.rigid.size() == 1);
    CHECK(second.rigid[0].mass_kg == 0.1);
    CHECK(second.rigid[0].grip_buttons == first.rigid[0].grip_buttons);
    CHECK(validate(second));
}

TEST_CASE("plan: with one hand a lesson of two costs what a lesson of one does, stage by stage") {
    LessonDescription lesson = make_two_fingers();
    const Plan with_one = compile(lesson, 1);
    const Plan with_two = compile(lesson);
    lesson.more_hands.clear();
    const Plan of_one = compile(lesson);
    CHECK(with_one.more_hands.empty());
    REQUIRE(with_one.stages.size() == of_one.stages.size());
    for (std::size_t i = 0; i < of_one.stages.size(); ++i) {
        CHECK(with_one.stages[i].loop == of_one.stages[i].loop);
        CHECK(with_one.stages[i].name == of_one.stages[i].name);
    }
    const auto count = [](const Plan& plan, const std::string& loop) {
        return std::ranges::count(plan.stages, loop, &PlanStage::loop);
    };
    CHECK(count(with_one, "hand 2") == 0);
    CHECK(count(with_two, "hand 2") == count(with_two, "haptic"));
    CHECK(stage_of(with_two, "hand 2", "read").line == 4);
}

TEST_CASE("plan: what one hand alone can hold goes with no second one, whoever is there") {
    const auto sentence = [](const std::function<void(LessonDescription&)>& change) {
        LessonDescription lesson = make_two_fingers();
        change(lesson);
        PlanOptions options;
        options.n_hands = 1;
        return refusal(lesson, box_mesh, options);
    };
    CHECK(sentence([](LessonDescription&) {}).empty());
    const std::string advice =
        ", and the lesson has two hands; leave out one of them: two hands go with solid and rigid "
        "bodies and declared forces.";
    CHECK(sentence([](auto& lesson) {
              lesson.bucket.present = true;
              lesson.bucket.line = 9;
          }) == "lesson.lua:9: a bucket hangs on one hand" + advice);
    CHECK(sentence([](auto& lesson) {
              lesson.kite.emplace();
              lesson.kite->line = 8;
          }) == "lesson.lua:8: a kite's line is held by one hand" + advice);
    CHECK(sentence([](auto& lesson) {
              lesson.hand.lesson_force = true;
              lesson.hand.force_line = 7;
          }) == "lesson.lua:7: the lesson's own force is for one hand" + advice);
    CHECK(sentence([](auto& lesson) { lesson.more_hands[0].tool.emplace(); }) ==
          "lesson.lua:4: a tool needs the time of one hand" + advice);
    CHECK(sentence([](auto& lesson) {
              lesson.bodies[0].rigid.reset();
              lesson.bodies[0].movable = true;
          }) == "lesson.lua:5: the block is movable" + advice);
    CHECK(sentence([](auto& lesson) {
              lesson.bodies[0].rigid.reset();
              lesson.bodies[0].hinge.emplace();
          }) == "lesson.lua:5: the block is on a hinge" + advice);
    // A field that is too stiff for the larger scale is refused too.
    check_says(sentence([](auto& lesson) {
                   ForceDescription spring;
                   spring.name = "s";
                   spring.field.kind = FieldKind::spring;
                   spring.field.stiffness_N_per_m = 1500.0;
                   lesson.forces = {spring};
               }),
               {"too stiff"});
}

TEST_CASE("plan: a lesson as one of its hands sees it has no other") {
    const LessonDescription lesson = make_two_fingers();
    const LessonDescription second = as_seen_by(lesson, 1);
    CHECK(second.hand.centre_W == Vector3(-0.1, 0.2, 0.0));
    CHECK(second.hand.rate_hz == 2000.0);
    CHECK(second.more_hands.empty());
    CHECK(as_seen_by(lesson, 0).hand.centre_W == lesson.hand.centre_W);
    CHECK(name_of_loop(0) == "haptic");
    CHECK(name_of_loop(1) == "hand 2");
    CHECK(find_largest_scale(lesson) == 2.0);
}
