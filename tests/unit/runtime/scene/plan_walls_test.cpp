// Walls and springs that a device cannot hold, in the plan. That what it makes settles, tests/stability/declared_walls_test.cpp shows.
#include "runtime/scene/plan_walls.h"

#include "tests/support/declared_wall.h"

#include <catch2/catch.hpp>

namespace fulcrum::runtime {

TEST_CASE(
    "plan: a wall that would shake is felt softer, by a notice with its line, and is judged as it "
    "is felt") {
    const fulcrum::test::DeclaredWall stiff{.stiffness_N_per_m = 2000.0, .damping_Ns_per_m = 20.0};
    WallHolder far;
    far.name = "an arm far away";
    far.link_s = 0.021;
    const auto at_hand = fulcrum::test::make_wall_plan(stiff, {}).value();
    const auto away = fulcrum::test::make_wall_plan(stiff, far).value();
    const auto felt_of = [](const Plan& plan) { return *plan.haptic.solids.front().coupling; };
    CHECK(felt_of(at_hand).stiffness_N_per_m == 2000.0);
    CHECK(felt_of(at_hand).damping_Ns_per_m < 20.0);
    CHECK(felt_of(away).stiffness_N_per_m < 300.0);
    REQUIRE(away.notices.size() == 1);
    CHECK(
        away.notices.front() ==
        "lesson.lua:2: wall is felt with a stiffness of 150 N/m and a damping of 0.6 Ns/m, not "
        "with "
        "a stiffness of 2000 N/m and a damping of 20 Ns/m: with these an arm far away over a link "
        "of 21 ms there and back would shake in a hand.");
    // The answer key.
    CHECK(away.material_facts.front().stiffness_N_per_m == felt_of(away).stiffness_N_per_m);
    CHECK(away.material_facts.front().hardness < kGradeMiddle);
    CHECK(at_hand.material_facts.front().hardness >= kGradeMiddle);
    // What is made of nothing gives way too, and that is told where there is such a thing.
    CHECK(at_hand.haptic.coupling.stiffness_N_per_m == 500.0);
    CHECK(away.haptic.coupling.stiffness_N_per_m < 300.0);
    LessonDescription plain = fulcrum::test::make_wall_lesson(stiff);
    plain.materials.clear();
    plain.bodies.front().material = kNoMaterial;
    plain.bodies.front().model = "sphere";
    PlanOptions options;
    options.holder = far;
    const auto load = [](const BodyDescription& body) {
        return make_box(Vector3::Constant(body.radius_m)).and_then([](const TriangleMesh& box) {
            return CollisionMesh::create(box);
        });
    };
    const auto told = compile_plan(plain, options, load).value().notices;
    REQUIRE(told.size() == 1);
    CHECK(told.front().find("lesson.lua:3: the block, of no material, is felt with a stiffness of "
                            "150 N/m") == 0);
    CHECK(compile_plan(plain, {}, load).value().notices.empty());
}

TEST_CASE(
    "plan: a wall that no rate makes stable is refused, with its line and the nearest that is") {
    const auto refused =
        fulcrum::test::make_wall_plan({.stiffness_N_per_m = 5000.0, .damping_Ns_per_m = 50.0}, {});
    REQUIRE(!refused);
    CHECK(to_sentence(refused.error()) ==
          "lesson.lua:2: wall would shake in a hand with a stiffness of 5000 N/m and a damping "
          "of 50 Ns/m; the nearest that a desktop arm holds is a stiffness of 3750 N/m and a "
          "damping of 6.2 Ns/m.");
    for (const fulcrum::test::DeclaredWall& wall :
         {fulcrum::test::DeclaredWall{5000.0, 0.0}, {10.0, 30.0}, {3750.0, 6.2}}) {
        CAPTURE(wall.stiffness_N_per_m);
        CHECK(fulcrum::test::make_wall_plan(wall, {}).has_value());
    }
    CHECK(!fulcrum::test::make_wall_plan({.stiffness_N_per_m = 100.0, .damping_Ns_per_m = 50.0}, {})
               .has_value());
}

TEST_CASE(
    "plan: a spring that would shake pulls softer, as stiff in the hand at any scale, by a notice "
    "with its line") {
    WallHolder far;
    far.name = "an arm far away";
    far.link_s = 0.021;
    const fulcrum::test::DeclaredWall declared{
        .stiffness_N_per_m = 100.0, .damping_Ns_per_m = 0.0, .is_spring = true};
    LessonDescription lesson = fulcrum::test::make_wall_lesson(declared);
    lesson.hand.scale = 10.0;
    const auto none = [](const BodyDescription&) -> Expected<std::shared_ptr<const CollisionMesh>> {
        return fail("there is no body", {}, {});
    };
    PlanOptions options;
    options.holder = far;
    const auto made = compile_plan(lesson, options, none);
    INFO((made ? "" : to_sentence(made.error())));
    REQUIRE(made);
    const Plan& plan = *made;
    CHECK(plan.haptic.fields.front().stiffness_N_per_m == Approx(15.0));
    REQUIRE(plan.notices.size() == 1);
    CHECK(plan.notices.front().find("lesson.lua:4: the spring \"hold\" is felt with a stiffness of "
                                    "150 N/m") == 0);
    // One that is stable is as it was declared, to the bit.
    lesson.hand.scale = 0.7;
    CHECK(compile_plan(lesson, {}, none).value().haptic.fields.front().stiffness_N_per_m == 100.0);
}

}  // namespace fulcrum::runtime
