
#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

// A beam of 1 m on a hinge through its middle.
const SolidLoader kBeam = load_as({1.0, 0.1, 0.1});

LessonDescription with_beam(double inertia_kg_m2) {
    LessonDescription lesson;
    lesson.bodies = {make_solid("beam")};
    lesson.bodies[0].hinge = AxleSettings{};
    lesson.bodies[0].hinge->inertia_kg_m2 = inertia_kg_m2;
    return lesson;
}

}  // namespace

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
