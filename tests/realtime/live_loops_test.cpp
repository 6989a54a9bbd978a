// Haptic and world loop on threads of their own, fed by a third, as in the program: what must fade fades, whatever the
// machine's timing. No time of the wall is asserted; the loops' own clocks are.
#include "haptics/base/clock.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/loop/realtime_thread.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

using namespace fulcrum;

namespace {

// A simulated hand that can be pulled out; counts what it is still given then.
class PluggedHand final : public Device {
  public:
    explicit PluggedHand(LatestValue<HandTarget>& target)
        : hand_(SimulatedHandSettings{}, target) {}
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return hand_.traits(); }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override {
        return hand_.read(now_s, reading) && plugged.load(std::memory_order_relaxed);
    }
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override {
        force_N.store(wrench_D.force.norm(), std::memory_order_relaxed);
        return hand_.write(now_s, wrench_D);
    }
    std::atomic<bool> plugged{true};
    std::atomic<double> force_N{0.0};

  private:
    SimulatedHand hand_;
};

// Everything that runs; the test's own thread is the lesson.
struct Program {
    Program() {
        haptic_plan.carries_weight = true;
        haptic_plan.expects_world = true;
        haptic_plan.safety.soft_start_s = 0.05;
        haptic_plan.safety.soft_start_N_per_s = 50.0;
        // A slow machine is no stale lesson: this test is about what is said, not when.
        haptic_plan.safety.command_timeout_s = 1.0;
        haptic_plan.safety.device_timeout_s = 0.1;
        world_plan.bodies = {{0.3, 0.3, 0.04, 0.0}};
        haptic = std::make_unique<HapticLoop>(haptic_plan, hand, *haptics);
        world = std::make_unique<WorldLoop>(world_plan, std::vector<std::int32_t>{}, *channels,
                                            *haptics);
        RealtimeSettings settings;
        settings.epoch_s = epoch_s;
        REQUIRE(haptic_thread.start(*haptic, settings));
        settings.rate_Hz = world_plan.rate_hz;
        settings.fifo_priority = 0;
        settings.spin_s = 0.0;
        REQUIRE(world_thread.start(*world, settings));
    }

    // Plays the lesson until the condition on the newest state holds. A machine that stops for a second makes the command
    // stale, which fades the force as it should; the condition comes true later.
    template <class Condition>
    void play_until(Condition condition) {
        for (;;) {
            ForceCommand command;
            command.stamp_s = monotonic_now_s() - epoch_s;
            command.lesson_alive = lesson_alive;
            haptics->command.publish(command);
            (void)haptics->state_for_lesson.take();
            if (condition(haptics->state_for_lesson.value())) {
                return;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

    // Engages, then lies 2.9 N into the hand.
    void carry() {
        play_until([](const HapticState& state) { return state.gate == GatePhase::open; });
        channels->commands.push({WorldCommand::Kind::hold, 0});
        play_until([](const HapticState& state) {
            return state.gate == GatePhase::open && state.applied_W.force.y() < -2.9;
        });
    }

    double epoch_s = monotonic_now_s();
    HapticPlan haptic_plan;
    WorldPlan world_plan;
    std::unique_ptr<HapticChannels> haptics = std::make_unique<HapticChannels>();
    std::unique_ptr<WorldChannels> channels = std::make_unique<WorldChannels>();
    LatestValue<HandTarget> target;
    PluggedHand hand{target};
    bool lesson_alive = true;
    std::unique_ptr<HapticLoop> haptic;
    std::unique_ptr<WorldLoop> world;
    RealtimeThread haptic_thread;
    RealtimeThread world_thread;
};

}  // namespace

TEST_CASE("live loops: a weight is felt; the thread stopped, or the device pulled out, it fades") {
    Program program;
    program.carry();
    CHECK(program.hand.force_N.load() > 2.9);
    program.haptic_thread.stop();
    CHECK(program.hand.force_N.load() == 0.0);
    CHECK(program.haptic_thread.status().rounds > 0);
    Program other;
    other.carry();
    other.hand.plugged.store(false);
    other.play_until([](const HapticState& state) {
        return any(state.faults & Fault::device_read) && state.gate == GatePhase::waiting;
    });
    CHECK(other.hand.force_N.load() == 0.0);
}

TEST_CASE(
    "live loops: a lesson that has died, a lesson that is silent, a stop pressed: each fades the "
    "force") {
    for (int kind = 0; kind < 3; ++kind) {
        Program program;
        program.carry();
        if (kind == 0) {
            program.lesson_alive = false;
            program.play_until([](const HapticState& state) {
                return any(state.faults & Fault::lesson_failed) && state.gate == GatePhase::waiting;
            });
        } else if (kind == 1) {
            for (HapticState state;
                 !any(state.faults & Fault::command_stale) || state.gate != GatePhase::waiting;) {
                (void)program.haptics->state_for_lesson.take();
                state = program.haptics->state_for_lesson.value();
                std::this_thread::sleep_for(std::chrono::milliseconds(2));
            }
        } else {
            program.haptics->emergency_stop.press();
            program.play_until([](const HapticState& state) {
                return state.gate == GatePhase::stopped && state.applied_W.force.norm() == 0.0;
            });
        }
        CHECK(program.hand.force_N.load() == 0.0);
    }
}

TEST_CASE("live loops: a weight that is no number fades the force and never reaches the hand") {
    Program program;
    program.carry();
    program.world_thread.stop();  // this thread is the world now
    WorldFrame frame;
    frame.carried_force_W.x() = std::numeric_limits<double>::quiet_NaN();
    program.play_until([&](const HapticState& state) {
        frame.stamp_s = monotonic_now_s() - program.epoch_s;
        program.haptics->world.publish(frame);
        return any(state.faults & Fault::command_invalid) && state.gate == GatePhase::waiting;
    });
    CHECK(program.hand.force_N.load() == 0.0);
}
