// A haptic loop on a device, with a lesson and a world that keep it fresh.
#pragma once

#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/scripted_device.h"
#include "tests/unit/haptics/loop/rounds.h"

#include <catch2/catch.hpp>

#include <memory>
#include <string>
#include <utility>

namespace fulcrum {

// A frictionless floor, as high as its solid.
class FloorProxy final : public Proxy {
  public:
    void reset(const Vector3& hand_W) noexcept override {
        contact_ = {};
        contact_.position_W = hand_W;
    }
    void put_solid(std::size_t /*solid*/, const Pose& /*pose_W*/) noexcept override {}
    const ProxyContact& step(const Vector3& hand_W,
                             std::span<const Pose> poses_W) noexcept override {
        reset(hand_W);
        const double height_m = poses_W[0].position.y();
        if (hand_W.y() < height_m) {
            contact_.position_W.y() = height_m;
            contact_.solid = 0;
            contact_.n_constraints = 1;
            contact_.normal_W = Vector3::UnitY();
            contact_.touches[0] = {.solid = 0, .push_m = height_m - hand_W.y()};
            contact_.touches[0].anchor_W = contact_.position_W;
        }
        return contact_;
    }

  private:
    ProxyContact contact_;
};

// What a loop is given beside its plan and its device.
struct BenchParts {
    std::unique_ptr<Proxy> proxy = nullptr;  // none: the one that the plan asks for
    AxleChannels* axles = nullptr;
    KiteChannels* kite = nullptr;
    RecordRing* record = nullptr;
    TouchRing* touches = nullptr;
    LatestValue<ForceShares>* shares = nullptr;
    DeviceTraits traits = ScriptedDevice().traits_;  // of a scripted device
};

// A loop with everything round it; `run` steps it, keeping lesson and world fresh while they are awake.
struct LoopBench {
    LoopBench(const HapticPlan& plan, Device& of, BenchParts parts)
        : dt_s(1.0 / plan.rate_hz), loop(make_loop(plan, of, *channels, std::move(parts))) {
        command.lesson_alive = true;
    }
    static HapticLoop make_loop(const HapticPlan& plan, Device& of, HapticChannels& channels,
                                BenchParts parts) {
        channels.axles = parts.axles;
        channels.kite = parts.kite;
        channels.record = parts.record;
        channels.touches = parts.touches;
        channels.shares = parts.shares;
        return parts.proxy ? HapticLoop(plan, of, channels, std::move(parts.proxy))
                           : HapticLoop(plan, of, channels);
    }

    void run(int n) {
        for (int i = 0; i < n; ++i) {
            now_s += dt_s;
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
    // The names of its stages, each of which has its rate and its memory.
    [[nodiscard]] std::string stages() const {
        std::string all;
        for (const StageInfo& stage : loop.stages()) {
            CHECK(stage.rate_Hz == 1.0 / dt_s);
            CHECK(stage.bytes > 0);
            all += std::string(name_of(stage.stage)) + ", ";
        }
        return all;
    }
    [[nodiscard]] const HapticState& state() const { return loop.state(); }
    [[nodiscard]] bool saw(Fault fault) const { return any(state().faults & fault); }

    double dt_s;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    ForceCommand command;
    WorldFrame world;
    bool lesson_awake = true;
    bool world_awake = true;
    double now_s = 0.0;
    HapticLoop loop;
};

// A device that does as the test says.
struct BenchDevice {
    ScriptedDevice device;
};
struct Bench : BenchDevice, LoopBench {
    explicit Bench(const HapticPlan& plan, BenchParts parts = {})
        : LoopBench(plan, like(parts.traits), std::move(parts)) {}
    ScriptedDevice& like(const DeviceTraits& traits) {
        device.traits_ = traits;
        return device;
    }
    void move(double x_m, double y_m = 0.0) {
        device.pose_D.position += Vector3(x_m, y_m, 0.0);
        run(1);
    }
    [[nodiscard]] const Vector3& written_N() const { return device.written_D.force; }
};

// A hand that holds a device, and goes where it wants.
struct BenchHand {
    explicit BenchHand(const SimulatedHandSettings& settings) : device(settings, target) {}
    LatestValue<HandTarget> target;
    SimulatedHand device;
};
struct HandBench : BenchHand, LoopBench {
    explicit HandBench(const HapticPlan& plan, const SimulatedHandSettings& settings = {},
                       BenchParts parts = {})
        : BenchHand(settings), LoopBench(plan, device, std::move(parts)) {}
    void run_to(const Vector3& wanted_D) {
        target.publish({.pose_D = Pose::at(wanted_D)});
        run(1);
    }
};

inline HapticPlan make_weight_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    return plan;
}
inline HapticPlan make_lesson_plan() {
    HapticPlan plan;
    plan.lesson_force = true;
    return plan;
}

// Holding 3 N with the gate open.
inline void hold(Bench& bench) {
    bench.run(3000);
    bench.world.carried_force_W = Vector3(0.0, -3.0, 0.0);
    bench.run(1000);
    REQUIRE(bench.state().gate == GatePhase::open);
    REQUIRE((bench.written_N() - Vector3(0.0, -3.0, 0.0)).norm() < kRounding);
}
struct HoldingBench : Bench {
    explicit HoldingBench(HapticPlan plan = make_weight_plan(), BenchParts parts = {})
        : Bench(plan, std::move(parts)) {
        hold(*this);
    }
};

}  // namespace fulcrum
