#include "haptics/loop/stage_listener.h"

#include "haptics/geometry/shape.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/scripted_device.h"
#include "tests/support/touchable.h"

#include <catch2/catch.hpp>

#include <memory>

namespace fulcrum {
namespace {

// Everything that a plan can hold.
HapticPlan make_full_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.lesson_force = true;
    plan.expects_world = true;
    plan.fields = {{.kind = FieldKind::spring, .stiffness_N_per_m = 30.0},
                   {.kind = FieldKind::viscosity, .damping_Ns_per_m = 1.0},
                   {.kind = FieldKind::magnet, .peak_force_N = 1.0, .range_m = 0.05}};
    plan.solids = only_solid(touchable(make_sphere(0.1, 4)));
    return plan;
}

class Listener final : public StageListener {
  public:
    void passed(HapticStage stage) noexcept override { stages.push_back(stage); }
    std::vector<HapticStage> stages;
};

// One loop and what it hears.
struct Bench {
    explicit Bench(const HapticPlan& plan)
        : channels(std::make_unique<HapticChannels>()), loop(plan, device, *channels) {}

    void feed(int k) {
        const double now_s = 0.001 * k;
        ForceCommand command;
        command.stamp_s = now_s;
        command.lesson_alive = true;
        command.linearised.stamp_s = now_s;
        command.linearised.force_W = {0.1, 0.2, 0.0};
        channels->command.publish(command);
        WorldFrame world;
        world.stamp_s = now_s;
        world.carried_force_W = {0.0, -0.5, 0.0};
        channels->world.publish(world);
        device.pose_D.position = {0.12 - 0.00004 * k, 0.01, 0.0};
    }

    ScriptedDevice device;
    std::unique_ptr<HapticChannels> channels;
    HapticLoop loop;
};

TEST_CASE("stage listener: a round that is watched is the same round to the byte") {
    const HapticPlan plan = make_full_plan();
    Bench plain(plan);
    Bench watched(plan);
    Listener listener;
    bool touched = false;
    for (int k = 1; k <= 1000; ++k) {
        plain.feed(k);
        watched.feed(k);
        plain.loop.step(0.001 * k);
        watched.loop.step_observed(0.001 * k, listener);
        const HapticState& a = plain.loop.state();
        const HapticState& b = watched.loop.state();
        REQUIRE(a.commanded_W.force == b.commanded_W.force);
        REQUIRE(a.commanded_W.torque == b.commanded_W.torque);
        REQUIRE(a.applied_W.force == b.applied_W.force);
        REQUIRE(a.proxy_position_W == b.proxy_position_W);
        REQUIRE(a.faults == b.faults);
        touched = touched || a.touched_body >= 0;
    }
    CHECK(touched);
    CHECK(plain.loop.state().applied_W.force.norm() > 0.1);
}

TEST_CASE(
    "stage listener: it is told of the stages that were built, in their order, and of no others") {
    HapticPlan bare;
    bare.expects_lesson = false;
    for (const HapticPlan& plan : {make_full_plan(), bare}) {
        Bench bench(plan);
        Listener listener;
        bench.feed(1);
        bench.loop.step_observed(0.001, listener);
        std::vector<HapticStage> built;
        for (const StageInfo& info : bench.loop.stages()) {
            built.push_back(info.stage);
        }
        CHECK(listener.stages == built);
    }
}

}  // namespace
}  // namespace fulcrum
