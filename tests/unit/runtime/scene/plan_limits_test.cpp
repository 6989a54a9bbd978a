
#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

Expected<std::shared_ptr<const CollisionMesh>> no_solid(const BodyDescription& /*body*/) {
    return fail("there is no mesh here");
}

}  // namespace

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
