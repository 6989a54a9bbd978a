// One fault in the closed loop, and what the hand feels of it: a lesson's spring holds about 3 N against a hand, through haptic loop,
// link, arm's server and simulated arm under one clock; then something breaks.
//
// Measured from the fault on: the largest force on the hand and its largest step in a round, the energy that the hand is given, and
// how long until no force is left. Some faults are no reason to stop, and then the force must stay as it was.
#pragma once

#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "tests/support/link.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::test_link {

/// An arm whose sensor or motor can break.
class BreakableArm final : public Device {
  public:
    BreakableArm(const SimulatedArmSettings& settings, LatestValue<HandTarget>& target)
        : arm(settings, target) {}
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return arm.traits(); }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override {
        (void)arm.read(now_s, reading);
        if (spoil) {
            return spoil(reading);
        }
        return true;
    }
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override {
        return arm.write(now_s, wrench_D) && motor_works;
    }
    SimulatedArm arm;
    std::function<bool(DeviceReading&)> spoil;  ///< what a reading becomes; false: none
    bool motor_works = true;
};

/// All that runs, for a fault to break something of.
struct FaultBench {
    FaultBench()
        : hand(arm_settings(), target), pair(hand), loop(make_plan(), linked(pair), *channels) {
        command.lesson_alive = true;
        command.fields[0].anchor_W = Vector3(0.03, 0.0, 0.0);
    }

    static SimulatedArmSettings arm_settings() {
        SimulatedArmSettings settings = make_desktop_arm();
        settings.max_force_N = 10.0;
        settings.human = kArm;
        return settings;
    }
    static HapticPlan make_plan() {
        HapticPlan plan;
        plan.expects_world = true;
        plan.lesson_force = true;
        plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 400.0}};
        return plan;
    }
    // The loop is built for a device that has said what it is.
    static Device& linked(LinkPair& pair) {
        (void)pair.link();
        return pair.device;
    }

    void run(double seconds) {
        for (const double until_s = pair.now_s + seconds; pair.now_s < until_s - 1e-9;) {
            step();
        }
    }
    void step() {
        pair.now_s += LinkPair::kStep_s * clock_rate;
        if (lesson_awake) {
            command.stamp_s = pair.now_s;
            channels->command.publish(command);
        }
        if (world_period_s >= 0.0 && pair.now_s - world.stamp_s >= world_period_s - 1e-9) {
            world.stamp_s = pair.now_s;
            channels->world.publish(world);
        }
        if (program_runs) {
            loop.step(pair.now_s);
        }
        if (arm_runs) {
            pair.server.step(pair.now_s + 0.5 * LinkPair::kStep_s);
        }
    }

    LatestValue<HandTarget> target;
    BreakableArm hand;
    LinkPair pair;
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    HapticLoop loop;
    ForceCommand command;
    WorldFrame world;
    bool lesson_awake = true;
    double world_period_s = 0.001;  ///< negative: the world has stopped
    bool program_runs = true;
    bool arm_runs = true;
    double clock_rate = 1.0;
};

struct FaultKind {
    std::string name;
    std::string notices;  ///< who, and by what
    bool fades = true;    ///< else the force goes on as it was
    std::function<void(FaultBench&)> happens;
    bool drops = false;  ///< at once: the time in which it would have faded has passed
};

struct FaultCourse {
    double before_N = 0.0;
    double peak_N = 0.0;  ///< after the fault
    double largest_step_N = 0.0;
    double given_J = 0.0;  ///< to the hand and not given back, at most
    double gone_s = std::numeric_limits<double>::infinity();  ///< below 0.01 N for good
    double end_N = 0.0;
};

inline FaultCourse run_fault(const FaultKind& kind, double seconds = 1.0) {
    FaultBench bench;
    bench.target.publish({});
    bench.command.fields[0].strength = 0.0;
    bench.run(0.5);
    bench.command.fields[0].strength = 1.0;
    bench.run(4.0);
    FaultCourse course;
    course.before_N = bench.hand.arm.force_D().norm();
    kind.happens(bench);
    double given_J = 0.0;
    const double began_s = bench.pair.now_s;
    Vector3 x_before = bench.hand.arm.position_D();
    Vector3 f_before = bench.hand.arm.force_D();
    while (bench.pair.now_s - began_s < seconds) {
        bench.step();
        const Vector3 x = bench.hand.arm.position_D();
        const Vector3 f = bench.hand.arm.force_D();
        given_J = std::max(given_J + f_before.dot(x - x_before), 0.0);
        course.given_J = std::max(course.given_J, given_J);
        course.peak_N = std::max(course.peak_N, f.norm());
        course.largest_step_N = std::max(course.largest_step_N, (f - f_before).norm());
        if (f.norm() >= 0.01) {
            course.gone_s = std::numeric_limits<double>::infinity();
        } else if (!std::isfinite(course.gone_s)) {
            course.gone_s = bench.pair.now_s - began_s;
        }
        x_before = x;
        f_before = f;
    }
    course.end_N = bench.hand.arm.force_D().norm();
    return course;
}

/// Every single fault of the fault tree (haptics/SAFETY.md) that this loop can have, in its order.
[[nodiscard]] inline std::vector<FaultKind> all_faults() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto spoil = [](std::function<bool(DeviceReading&)> how) {
        return [how](FaultBench& b) { b.hand.spoil = how; };
    };
    std::vector<FaultKind> kinds;
    // The arm.
    kinds.push_back({"the arm gives no pose", "arm: device_read", true,
                     spoil([](DeviceReading&) { return false; })});
    kinds.push_back(
        {"a sensor gives no number", "arm: device_invalid", true, spoil([nan](DeviceReading& r) {
             r.pose_D.position.x() = nan;
             return true;
         })});
    kinds.push_back(
        {"a sensor jumps by 10 cm", "arm: device_invalid", true, spoil([](DeviceReading& r) {
             r.pose_D.position.x() += 0.1;
             return true;
         })});
    kinds.push_back(
        {"a sensor's clock stands still", "arm: device_stale after 20 ms", true, [](FaultBench& b) {
             const double since_s = b.pair.now_s;
             b.hand.spoil = [since_s](DeviceReading& r) {
                 r.stamp_s = since_s;
                 return true;
             };
         }});
    kinds.push_back({"the motor refuses", "arm: device_write", true,
                     [](FaultBench& b) { b.hand.motor_works = false; }});
    kinds.push_back({"stop is pressed at the arm", "arm: emergency_stop", true,
                     [](FaultBench& b) { b.pair.server.stop(); }});
    // The line.
    kinds.push_back({"the cable is pulled", "arm: command_stale after 20 ms", true,
                     [](FaultBench& b) { b.pair.tap.cut = true; }});
    kinds.push_back({"ten packets in a row are lost, again and again", "nobody: it is borne", false,
                     [](FaultBench& b) { b.pair.faulty.set({.loss = 0.05, .burst = 10}); }});
    kinds.push_back({"every packet comes twice", "replay window", false,
                     [](FaultBench& b) { b.pair.faulty.set({.duplicate = 1.0}); }});
    kinds.push_back({"packets come up to 10 ms late, in any order", "sequence, age", false,
                     [](FaultBench& b) { b.pair.faulty.set({.jitter_s = 0.01}); }});
    kinds.push_back({"one packet in ten is damaged", "checksum", false,
                     [](FaultBench& b) { b.pair.faulty.set({.corrupt = 0.1}); }});
    kinds.push_back({"all packets come 60 ms late", "arm: command_stale after 20 ms", true,
                     [](FaultBench& b) { b.pair.faulty.set({.delay_s = 0.06}); }});
    // The program.
    kinds.push_back({"the program is killed", "arm: command_stale after 20 ms", true,
                     [](FaultBench& b) { b.program_runs = false; }});
    kinds.push_back({"the computer sleeps for ten seconds", "both: command_stale, device_stale",
                     true, [](FaultBench& b) { b.pair.now_s += 10.0; }, true});
    kinds.push_back({"the lesson hangs", "loop: command_stale after 100 ms", true,
                     [](FaultBench& b) { b.lesson_awake = false; }});
    kinds.push_back({"the lesson fails", "loop: lesson_failed", true,
                     [](FaultBench& b) { b.channels->lesson_failed.store(true); }});
    kinds.push_back({"the lesson asks for no number", "loop: command_invalid", true,
                     [nan](FaultBench& b) { b.command.fields[0].anchor_W.x() = nan; }});
    kinds.push_back({"the lesson asks for 100 N at once", "limits, slew", false,
                     [](FaultBench& b) { b.command.fields[0].anchor_W.x() = 0.25; }});
    kinds.push_back({"the world stops", "loop: command_stale after 100 ms", true,
                     [](FaultBench& b) { b.world_period_s = -1.0; }});
    kinds.push_back({"the world runs at 20 Hz", "nobody: it is felt as inertia", false,
                     [](FaultBench& b) { b.world_period_s = 0.05; }});
    kinds.push_back({"stop is pressed in the window", "loop: emergency_stop", true,
                     [](FaultBench& b) { b.channels->emergency_stop.press(); }});
    return kinds;
}

}  // namespace fulcrum::test_link
