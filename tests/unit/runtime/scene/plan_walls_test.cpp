// Walls and springs that a device cannot hold, in the plan. That what it makes settles, tests/stability/declared_walls_test.cpp shows.
#include "runtime/effect/surface/plan_walls.h"

#include "tests/support/declared_wall.h"

#include <catch2/catch.hpp>

#include <algorithm>

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
    options.holders = {far};
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
    options.holders = {far};
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

TEST_CASE("plan: what two devices touch is as soft as the worse of them needs it, which is told") {
    WallHolder far;
    far.name = "an arm far away";
    far.link_s = 0.021;
    const fulcrum::test::DeclaredWall stiff{.stiffness_N_per_m = 2000.0, .damping_Ns_per_m = 20.0};
    const auto load = [](const BodyDescription& body) {
        return make_box(Vector3::Constant(2.0 * body.radius_m))
            .and_then([](const TriangleMesh& box) { return CollisionMesh::create(box); });
    };
    const LessonDescription lesson = fulcrum::test::make_wall_lesson(stiff);
    const auto felt_by = [&](WallHolders holders) {
        PlanOptions options;
        options.holders = std::move(holders);
        const Plan plan = compile_plan(lesson, options, load).value();
        REQUIRE(plan.notices.size() == 1);
        const CouplingSettings felt = *plan.haptic.solids.front().coupling;
        const WallLoop loop{plan.haptic.rate_hz, plan.haptic.safety.max_slew_N_per_s,
                            plan.haptic.safety.max_force_N};
        for (const WallHolder& holder : options.holders) {
            CHECK(compute_wall_margin(felt, holder, loop) >= 1.0);
        }
        return std::pair(felt.stiffness_N_per_m, plan.notices.front());
    };
    const auto [alone, told] = felt_by({far});
    CHECK(felt_by({far, {}}) == std::pair(alone, told));
    CHECK(felt_by({{}, far}).second.find("an arm far away over a link of 21 ms") !=
          std::string::npos);
    CHECK(felt_by({{}, far}).first == Approx(alone).epsilon(0.1));
}

TEST_CASE("plan: the spring of a tool in the hand is as soft as the device needs it") {
    LessonDescription lesson = fulcrum::test::make_wall_lesson({.stiffness_N_per_m = 100.0});
    lesson.hand.tool.emplace();
    lesson.hand.tool->method = ToolMethod::god_object;
    lesson.hand.tool->stiffness_N_per_m = 800.0;
    lesson.hand.line = 5;
    const auto load = [](const BodyDescription& body) {
        return make_box(Vector3::Constant(2.0 * body.radius_m))
            .and_then([](const TriangleMesh& box) { return CollisionMesh::create(box); });
    };
    PlanOptions options;
    const auto coupling_of = [&] {
        return compile_plan(lesson, options, load).value().haptic.tool->settings.coupling;
    };
    const ToolCouplingSettings at_hand = coupling_of();
    CHECK(at_hand.shift.stiffness_N_per_m == 800.0);
    options.holders[0].name = "an arm far away";
    options.holders[0].link_s = 0.021;
    const ToolCouplingSettings away = coupling_of();
    CHECK(away.shift.stiffness_N_per_m < 200.0);
    // It turns as much softer.
    CHECK(away.turn.stiffness_Nm_per_rad * at_hand.shift.stiffness_N_per_m ==
          Approx(at_hand.turn.stiffness_Nm_per_rad * away.shift.stiffness_N_per_m));
    const auto notices = compile_plan(lesson, options, load).value().notices;
    CHECK(std::ranges::any_of(notices, [](const std::string& told) {
        return told.find("5: the tool's spring is felt with a stiffness of ") != std::string::npos;
    }));
}

}  // namespace fulcrum::runtime
