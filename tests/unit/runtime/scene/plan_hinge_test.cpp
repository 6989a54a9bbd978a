#include "haptics/geometry/shape.h"
#include "runtime/scene/plan.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

// A beam of 1 m on a hinge through its middle.
LessonDescription with_beam(double inertia_kg_m2) {
    LessonDescription lesson;
    BodyDescription beam;
    beam.name = beam.noun = beam.model = "beam";
    beam.solid = true;
    beam.line = 4;
    beam.hinge = AxleSettings{};
    beam.hinge->inertia_kg_m2 = inertia_kg_m2;
    lesson.bodies = {beam};
    return lesson;
}

Expected<std::shared_ptr<const CollisionMesh>> load_beam(const BodyDescription&) {
    return touchable(make_box(Vector3(1.0, 0.1, 0.1)));
}

Expected<Plan> compile(const LessonDescription& lesson) {
    return compile_plan(lesson, {}, load_beam);
}

}  // namespace

TEST_CASE("plan: a hinge brings the stage that turns, and names the line that asked") {
    const auto plan = compile(with_beam(0.1));
    REQUIRE(plan);
    CHECK(plan->has("haptic", "turning"));
    REQUIRE(plan->haptic.axles.size() == 1);
    CHECK(plan->haptic.axles[0].solid == 0);
    CHECK(plan->haptic.axles[0].reach_m == Approx(std::hypot(0.5, 0.05)));
    for (const PlanStage& stage : plan->stages) {
        if (stage.name == "turning") {
            CHECK(stage.line == 4);
        }
    }
    LessonDescription still = with_beam(0.1);
    still.bodies[0].hinge.reset();
    const auto without = compile(still);
    REQUIRE(without);
    CHECK_FALSE(without->has("haptic", "turning"));
    CHECK(without->haptic.axles.empty());
    CHECK(without->day == kTestDay);
}

TEST_CASE("plan: what turns too easily, or both turns and falls, is refused with its line") {
    const auto refusal = [](const LessonDescription& lesson) {
        const auto plan = compile(lesson);
        return plan ? std::string() : to_sentence(plan.error());
    };
    CHECK(refusal(with_beam(0.01)) ==
          "lesson.lua:4: the beam: an inertia of 0.01 kg m^2 is too little for a body that a hand "
          "presses 0.502494 m from its axis: it would shake; give it at least 0.02525 kg m^2.");
    LessonDescription falling = with_beam(0.1);
    falling.bodies[0].movable = true;
    CHECK(
        refusal(falling) ==
        "lesson.lua:4: the beam is on a hinge and movable; leave out one of them: what turns on a "
        "hinge does not fall.");
}
