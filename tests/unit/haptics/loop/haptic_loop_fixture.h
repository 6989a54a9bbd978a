// A haptic loop on a scripted device, with a lesson and a world that keep it fresh.
#pragma once

#include "haptics/loop/haptic_loop.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/haptics/loop/rounds.h"

#include <catch2/catch.hpp>

#include <memory>
#include <utility>

namespace fulcrum {

// A loop with everything round it; `run` steps it, keeping lesson and world fresh while they are awake.
struct Bench {
    explicit Bench(const HapticPlan& plan, std::unique_ptr<Proxy> proxy = nullptr,
                   AxleChannels* axles = nullptr)
        : loop(plan, device, with_axles(*channels, axles), std::move(proxy)) {
        command.lesson_alive = true;
    }
    static HapticChannels& with_axles(HapticChannels& channels, AxleChannels* axles) {
        channels.axles = axles;
        return channels;
    }

    void run(int n) {
        for (int i = 0; i < n; ++i) {
            now_s += kDt_s;
            if (lesson_awake) {
                command.stamp_s = now_s;
                channels->command.publish(command);
            }
            if (world_awake) {
                world.stamp_s = now_s;
                channels->world.publish(world);
            }
            loop.step(now_s);
        }
    }

    ScriptedDevice device;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    ForceCommand command;
    WorldFrame world;
    bool lesson_awake = true;
    bool world_awake = true;
    double now_s = 0.0;
    HapticLoop loop;
};

inline HapticPlan make_weight_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    return plan;
}

// Holding 3 N with the gate open.
inline void hold(Bench& bench) {
    bench.run(3000);
    bench.world.carried_force_W = Vector3(0.0, -3.0, 0.0);
    bench.run(1000);
    REQUIRE(bench.loop.state().gate == GatePhase::open);
    REQUIRE((bench.device.written_D.force - Vector3(0.0, -3.0, 0.0)).norm() < kRounding);
}

inline bool saw(const Bench& bench, Fault fault) {
    return any(bench.loop.state().faults & fault);
}

}  // namespace fulcrum
