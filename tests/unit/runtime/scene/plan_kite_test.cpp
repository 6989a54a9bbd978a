#include "runtime/scene/plan_kite.h"

#include "tests/unit/runtime/scene/plan_scene.h"

using namespace fulcrum::runtime::test;

namespace {

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

}  // namespace

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
