#include "haptics/loop/stage_listener.h"

#include "haptics/geometry/shape.h"
#include "tests/support/touchable.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <vector>

namespace fulcrum {
namespace {

// Everything that a plan can hold.
HapticPlan make_full_plan() {
    HapticPlan plan = make_weight_plan();
    plan.lesson_force = true;
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

// A lesson that pulls, a weight, and a hand on its way into the ball.
struct FedBench : Bench {
    explicit FedBench(const HapticPlan& plan) : Bench(plan) {
        command.linearised.force_W = {0.1, 0.2, 0.0};
        world.carried_force_W = {0.0, -0.5, 0.0};
    }
    void run(StageListener* listener) {
        now_s += kDt_s;
        command.stamp_s = command.linearised.stamp_s = world.stamp_s = now_s;
        channels->command.publish(command);
        channels->world.publish(world);
        device.pose_D.position = {0.12 - 0.04 * now_s, 0.01, 0.0};
        if (listener != nullptr) {
            loop.step_observed(now_s, *listener);
        } else {
            loop.step(now_s);
        }
    }
};

TEST_CASE("stage listener: a round that is watched is the same round to the byte") {
    const HapticPlan plan = make_full_plan();
    FedBench plain(plan);
    FedBench watched(plan);
    Listener listener;
    bool touched = false;
    for (int k = 1; k <= 1000; ++k) {
        plain.run(nullptr);
        watched.run(&listener);
        const HapticState& a = plain.state();
        const HapticState& b = watched.state();
        REQUIRE(a.commanded_W.force == b.commanded_W.force);
        REQUIRE(a.commanded_W.torque == b.commanded_W.torque);
        REQUIRE(a.applied_W.force == b.applied_W.force);
        REQUIRE(a.proxy_position_W == b.proxy_position_W);
        REQUIRE(a.faults == b.faults);
        touched = touched || a.touched_body >= 0;
    }
    CHECK(touched);
    CHECK(plain.state().applied_W.force.norm() > 0.1);
}

TEST_CASE("stage listener: it is told of the stages that were built, in order, and of no others") {
    HapticPlan bare;
    bare.expects_lesson = false;
    for (const HapticPlan& plan : {make_full_plan(), bare}) {
        FedBench bench(plan);
        Listener listener;
        bench.run(&listener);
        std::vector<HapticStage> built;
        for (const StageInfo& info : bench.loop.stages()) {
            built.push_back(info.stage);
        }
        CHECK(listener.stages == built);
    }
}

}  // namespace
}  // namespace fulcrum
