#include "runtime/app/run_effects.h"

#include "runtime/app/hand_channels.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

// One hand and the effects of a plan, without a lesson's process.
struct Bench {
    Plan plan{};
    HandChannels hand{};
    std::vector<WorldCommand> first{};
    LessonDescription lesson{};
    RunEffects effects{};

    void build() {
        hand.add(plan.haptic, plan.rigid.has_value());
        HapticChannels* const channels[] = {&hand};
        REQUIRE(effects.build({plan, channels, first}));
    }
    SessionInput gather() {
        SessionInput input;
        effects.gather(lesson, input);
        return input;
    }
    void step_loops(double until_s) {
        for (int i = 0; i * 0.001 < until_s; ++i) {
            for (const EffectLoop& loop : effects.loops()) {
                loop.task->step(0.001 * i);
            }
        }
    }
};

KitePlan small_kite() {
    KitePlan kite;
    kite.flight.line.segments = 4;
    return kite;
}

}  // namespace

TEST_CASE("run effects: a plan that calls for none has none, no channels and no loops") {
    Bench bench;
    bench.build();
    CHECK(bench.effects.loops().empty());
    CHECK(bench.hand.axles == nullptr);
    CHECK(bench.hand.rigid == nullptr);
    CHECK(bench.hand.kite == nullptr);
    CHECK(bench.hand.touches == nullptr);
    CHECK(bench.effects.touch_sound() == nullptr);
    const SessionInput input = bench.gather();
    CHECK(input.world == nullptr);
    CHECK(input.axles == nullptr);
    CHECK(input.kite == nullptr);
    CHECK(bench.effects.order({}));
}

TEST_CASE(
    "run effects: a kite flies in its own loop, is told of after its first round, and obeys") {
    Bench bench;
    bench.plan.kite = small_kite();
    bench.plan.haptic.line.emplace();
    bench.build();
    REQUIRE(bench.effects.loops().size() == 1);
    CHECK(bench.effects.loops()[0].name == "kite");
    CHECK(bench.effects.loops()[0].rate_hz == kKiteRate_Hz);
    CHECK(bench.gather().kite == nullptr);
    EffectOrders orders;
    orders.kite = {.n_launches = 1, .elevation_rad = 0.7, .line_m = 20.0, .wind_m_per_s = 6.0};
    CHECK(bench.effects.order(orders));
    bench.hand.kite->hand_W.publish({0.0, 1.0, 0.0});
    bench.step_loops(0.1);
    const KiteFrame* const flies = bench.gather().kite;
    REQUIRE(flies != nullptr);
    const double narrow_N = flies->report.weight_W.norm();
    orders.kite_design = small_kite().flight.kite;
    orders.kite_design->spar_kg_per_m *= 3.0;
    CHECK(bench.effects.order(orders));
    bench.step_loops(0.2);
    CHECK(bench.gather().kite->report.weight_W.norm() > 1.2 * narrow_N);
    CHECK(bench.gather().world == nullptr);
}

TEST_CASE(
    "run effects: what falls is placed before the first round, moves as ordered, and what was hit "
    "is told") {
    Bench bench;
    bench.plan.world.emplace();
    bench.plan.world->bodies = {
        {.mass_kg = 0.1, .felt_mass_kg = 0.1, .radius_m = 0.02, .drag_area_m2 = 0.0}};
    WorldCommand place;
    place.kind = WorldCommand::Kind::place;
    place.body = 0;
    place.position_W = {0.0, 0.5, 0.0};
    bench.first = {place};
    bench.build();
    REQUIRE(bench.effects.loops().size() == 1);
    CHECK(bench.effects.loops()[0].name == "world");
    bench.step_loops(0.01);
    CHECK(bench.gather().world->bodies[0].pose_W.position.y() == 0.5);
    WorldCommand drop = place;
    drop.kind = WorldCommand::Kind::drop;
    EffectOrders orders;
    orders.world = {drop};
    CHECK(bench.effects.order(orders));
    bench.step_loops(1.0);
    const SessionInput after = bench.gather();
    CHECK(after.world->bodies[0].pose_W.position.y() < 0.05);
    CHECK(after.world_events.size() == 1);
    CHECK(bench.effects.n_events_dropped() == 0);
    CHECK(bench.effects.n_commands_ignored() == 0);
    EffectOrders flood;
    flood.world.assign(10'000, place);
    CHECK_FALSE(bench.effects.order(flood));
}

TEST_CASE("run effects: hinges are told by the hand's loop and ordered in it") {
    Bench bench;
    bench.plan.haptic.axles.emplace_back();
    bench.build();
    CHECK(bench.effects.loops().empty());
    REQUIRE(bench.hand.axles != nullptr);
    CHECK(bench.gather().axles == nullptr);
    bench.hand.axles->frame.publish({.n_axles = 1});
    REQUIRE(bench.gather().axles != nullptr);
    EffectOrders orders;
    orders.axles.axles[0].load_N = 3.0;
    CHECK(bench.effects.order(orders));
    REQUIRE(bench.hand.axles->orders.take());
    CHECK(bench.hand.axles->orders.value().axles[0].load_N == 3.0);
}

TEST_CASE("run effects: the sound of touch hears the first hand, and says what memory it has") {
    Bench bench;
    bench.plan.touch_sound = true;
    bench.plan.stages = {{"sound", "touch", 0.0, 0, "", 0}, {"sound", "mixer", 0.0, 0, "", 0}};
    bench.build();
    CHECK(bench.hand.touches != nullptr);
    CHECK(bench.effects.touch_sound() != nullptr);
    bench.effects.measure(bench.plan.stages);
    CHECK(bench.plan.stages[0].memory_bytes > 1000);
    CHECK(bench.plan.stages[1].memory_bytes == 0);
}
