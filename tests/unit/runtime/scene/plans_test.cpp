#include "haptics/loop/haptic_loop.h"
#include "haptics/tool/tool_plan.h"
#include "runtime/effect/kite/plan_kite.h"
#include "runtime/scene/compile_plan.h"
#include "runtime/scene/plan.h"
#include "runtime/scene/plan_hands.h"
#include "runtime/scene/round_up.h"
#include "tests/unit/runtime/rig.h"
#include "tests/unit/runtime/scene/plan_scene.h"

#include <rapidcheck.h>

using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

Expected<std::shared_ptr<const CollisionMesh>> no_solid(const BodyDescription& /*body*/) {
    return fail("there is no mesh here");
}

// A beam of 1 m on a hinge through its middle.
const SolidLoader kBeam = load_as({1.0, 0.1, 0.1});

LessonDescription with_beam(double inertia_kg_m2) {
    LessonDescription lesson;
    lesson.bodies = {make_solid("beam")};
    lesson.bodies[0].hinge = AxleSettings{};
    lesson.bodies[0].hinge->inertia_kg_m2 = inertia_kg_m2;
    return lesson;
}

LessonDescription with_kite() {
    LessonDescription lesson;
    lesson.gravity_W = {0, -1.62, 0};
    lesson.ground_height_m = 2.0;
    lesson.hand.scale = 4.0;
    lesson.kite = KiteDescription{};
    lesson.kite->line = 7;
    lesson.wind = {8.0, 1.0, 0.25, Vector3(0, 0, 1), 8};
    return lesson;
}

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

TEST_CASE("plan: free English is checked only where a lesson with questions wants it") {
    LessonDescription lesson;
    lesson.id = lesson.title = "q";
    lesson.free_english = true;
    const auto silent = value_of(compile_plan(lesson, {}, {}));
    CHECK_FALSE(silent.has("lesson", "free English"));
    lesson.questions.resize(1);
    const auto asking = value_of(compile_plan(lesson, {}, {}));
    CHECK(asking.free_english);
    CHECK(asking.has("lesson", "free English"));
    lesson.free_english = false;
    CHECK_FALSE(compile_plan(lesson, {}, {})->has("lesson", "free English"));
}

TEST_CASE("plan: a lesson may want less force than the site allows, and never gets more") {
    LessonDescription lesson;
    PlanOptions options;
    options.site = make_site_limits(4.0);
    for (const auto& [wanted_N, limit_N] : {std::pair(2.0, 2.0), {4.0, 4.0}, {10.0, 4.0}}) {
        lesson.force_limit_N = wanted_N;
        const auto plan = plan_of(lesson, no_solid, options);
        CHECK(plan.haptic.safety.max_force_N == limit_N);
        // The wrist's share falls with it.
        CHECK(plan.haptic.safety.max_torque_Nm == Approx(0.3 * limit_N / 5.0));
    }
}

TEST_CASE("plan: weights fit under what the lesson wants") {
    LessonDescription lesson;
    lesson.force_limit_N = 1.0;
    BodyDescription stone;
    stone.name = "stone";
    stone.model = "egg";
    stone.mass_kg = 10.0;
    stone.movable = true;
    lesson.bodies = {stone};
    const auto plan = plan_of(lesson, no_solid);
    CHECK(plan.felt_weight_N.front() == Approx(kWeightShareOfLimit * 1.0));
}

TEST_CASE("plan: a place's limits of speed and energy are the loop's") {
    PlanOptions options;
    options.site.speed_m_per_s = 1.5;
    options.site.energy_J = 2.0;
    const auto plan = plan_of({}, no_solid, options);
    CHECK(plan.haptic.safety.max_felt_speed_m_per_s == 1.5);
    CHECK(plan.haptic.safety.max_energy_J == 2.0);
}

TEST_CASE("plan: among voxels a tool has a point a voxel, or fewer as is said or told") {
    LessonDescription lesson = make_lesson();
    lesson.hand.tool->method = ToolMethod::voxel_sampling;
    lesson.hand.tool->voxel_m = 0.001;
    // A cylinder of 2 cm and 10 cm has 15 000 square millimetres.
    const auto whole = plan_of(lesson);
    const std::size_t n = count_points(*whole.haptic.tool);
    CHECK(n > 12'000);
    CHECK(n <= 20'000);
    CHECK(whole.notices.empty());
    lesson.hand.rate_hz = 4000.0;
    const auto late = plan_of(lesson);
    CHECK(count_points(*late.haptic.tool) == 2000);
    REQUIRE(late.notices.size() == 1);
    CHECK(late.notices[0].find("lesson.lua:7: the tool: it has " + std::to_string(n) +
                               " voxels of its own, and a step has time for 5000 points") == 0);
    lesson.hand.tool->points = 3000;
    const auto chosen = plan_of(lesson);
    CHECK(count_points(*chosen.haptic.tool) == 3000);
    CHECK(chosen.notices.empty());
}

TEST_CASE("rounding up: two digits, upwards, and what has two stays") {
    for (const double two_digits : {4.3e-5, 0.043, 0.3, 1.0, 9.9, 10.0, 430.0}) {
        CHECK(round_up(two_digits) == Approx(two_digits).epsilon(1.0e-12));
        CHECK(round_up(0.999 * two_digits) == Approx(two_digits).epsilon(1.0e-12));
        CHECK(round_up(1.001 * two_digits) > 1.005 * two_digits);
    }
    CHECK(round_up(0.0421) == Approx(0.043).epsilon(1.0e-12));
    CHECK(round_up(99.5) == Approx(100.0).epsilon(1.0e-12));
}

TEST_CASE("rounding up: never below, and by less than a tenth above") {
    CHECK(rc::check("of any size", [] {
        const double value = std::pow(10.0, *rc::gen::inRange(-12000, 12000) / 1000.0);
        const double rounded = round_up(value);
        RC_ASSERT(rounded >= value * (1.0 - 1.0e-10));
        RC_ASSERT(rounded <= value * (1.1 + 1.0e-10));
    }));
}

TEST_CASE("plan: a hinge brings the stage that turns, and names the line that asked") {
    const auto plan = plan_of(with_beam(0.1), kBeam);
    CHECK(plan.has("haptic", "turning"));
    REQUIRE(plan.haptic.axles.size() == 1);
    CHECK(plan.haptic.axles[0].solid == 0);
    CHECK(plan.haptic.axles[0].reach_m == Approx(std::hypot(0.5, 0.05)));
    CHECK(stage_of(plan, "haptic", "turning").line == 4);
    LessonDescription still = with_beam(0.1);
    still.bodies[0].hinge.reset();
    const auto without = plan_of(still, kBeam);
    CHECK_FALSE(without.has("haptic", "turning"));
    CHECK(without.haptic.axles.empty());
    CHECK(without.day == kTestDay);
}

TEST_CASE("plan: what turns too easily, or both turns and falls, is refused with its line") {
    CHECK(refusal(with_beam(0.01), kBeam) ==
          "lesson.lua:4: the beam: an inertia of 0.01 kg m^2 is too little for a body that a hand "
          "presses 0.502494 m from its axis: it would shake; give it at least 0.02525 kg m^2.");
    LessonDescription falling = with_beam(0.1);
    falling.bodies[0].movable = true;
    CHECK(
        refusal(falling, kBeam) ==
        "lesson.lua:4: the beam is on a hinge and movable; leave out one of them: what turns on a "
        "hinge does not fall.");
}

TEST_CASE("plan: a kite brings flight and a line in the hand, and names the line that asked") {
    const auto plan = plan_of(with_kite(), nullptr);
    CHECK(plan.has("haptic", "forces: line"));
    CHECK(plan.has("kite", "flight"));
    CHECK(plan.has("haptic", "passivity"));
    CHECK_FALSE(plan.has("world", "falling bodies"));
    for (const PlanStage& stage : plan.stages) {
        if (stage.loop == "kite") {
            CHECK(stage.line == 7);
            CHECK(stage.rate_hz == kKiteRate_Hz);
            CHECK(stage.memory_bytes > 1000);
        }
    }
    REQUIRE(plan.kite);
    const KiteFlightSettings& flight = plan.kite->flight;
    CHECK(flight.gravity_m_per_s2 == Approx(1.62));
    CHECK(flight.wind.ground_m == 2.0);
    CHECK(flight.wind.speed_m_per_s == 8.0);
    CHECK(flight.wind.gustiness == 1.0);
    CHECK(flight.wind.downwind_W == Vector3(0, 0, 1));
    CHECK(plan.haptic.line->most_N == Approx(0.9 * 5.0));
}

TEST_CASE("plan: a lesson without a kite has nothing of one") {
    LessonDescription lesson = with_kite();
    lesson.kite.reset();
    lesson.wind = {};
    const auto plan = plan_of(lesson, nullptr);
    CHECK_FALSE(plan.kite);
    CHECK_FALSE(plan.haptic.line);
    CHECK(std::ranges::none_of(plan.stages, [](const PlanStage& stage) {
        return stage.loop == "kite" || stage.name == "forces: line";
    }));
}

TEST_CASE("plan: a kite pulls no harder than hand, site and arm may be pulled") {
    PlanOptions options;
    options.site = make_site_limits(2.0);
    const Plan usual = plan_of(with_kite(), nullptr);
    const Plan milder = plan_of(with_kite(), nullptr, options);
    CHECK(milder.haptic.line->most_N == Approx(1.8));
    CHECK(milder.haptic.line->share == Approx(0.4 * usual.haptic.line->share));
    REQUIRE(milder.notices.size() == usual.notices.size() + 1);
    check_says(milder.notices.back(), {"0.40"});
    options.device_force_limit_N = 1.0;
    CHECK(plan_of(with_kite(), nullptr, options).haptic.line->most_N == 1.0);
    CHECK(plan_of(with_kite(), nullptr, options).haptic.line->share ==
          Approx(0.2 * usual.haptic.line->share));
}

TEST_CASE("plan: a wind without a kite, a line too stiff and a kite that is none are refused") {
    const auto sentence = [](auto change) {
        LessonDescription lesson = with_kite();
        change(lesson);
        return refusal(lesson, nullptr);
    };
    CHECK(
        sentence([](LessonDescription& l) { l.kite.reset(); }) ==
        "lesson.lua:8: nothing flies in the wind; declare a world:kite { … } as well, or leave the "
        "wind out.");
    CHECK_THAT(sentence([](LessonDescription& l) { l.hand.scale = 50.0; }),
               Catch::StartsWith("lesson.lua:7: the kite's line is too stiff for a hand at scale"));
    CHECK_THAT(sentence([](LessonDescription& l) { l.kite->flight.kite.strips = 0; }),
               Catch::StartsWith("lesson.lua:7: "));
}

TEST_CASE("plan: another design keeps the line and the wind") {
    KiteFlightSettings flight;
    flight.wind.speed_m_per_s = 9.0;
    flight.line.length_m = 33.0;
    KiteSettings design;
    design.tail_m = 7.0;
    const KiteFlightSettings changed = with_design(flight, design);
    CHECK(changed.kite == design);
    CHECK(changed.wind.speed_m_per_s == 9.0);
    CHECK(changed.line.length_m == 33.0);
}

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
