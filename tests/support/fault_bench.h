// One fault in the closed loop, and what the hand feels of it: a hand that moves about presses into a surface and is held by a lesson's
// spring as well, with about 3 N, through haptic loop, link, arm's server and simulated arm under one clock; then something breaks.
//
// Measured from the fault on: who notices it first, by which fault, when; the largest force on the hand and its largest step in a
// round; the energy that the hand is given; how long until no force is left. Some faults are no reason to stop: then the force must be at
// the end what it would have been.
#pragma once

#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/math/split_mix.h"
#include "tests/support/link.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace fulcrum::test_link {

/// An arm whose sensor or motor can break; its last digits tremble.
class BreakableArm final : public Device {
  public:
    BreakableArm(const SimulatedArmSettings& settings, LatestValue<HandTarget>& target)
        : arm(settings, target) {}
    [[nodiscard]] const DeviceTraits& traits() const noexcept override { return arm.traits(); }
    [[nodiscard]] bool read(double now_s, DeviceReading& reading) noexcept override {
        (void)arm.read(now_s, reading);
        for (double& x : reading.pose_D.position) {
            x += kTremble_m * (2.0 * tremble_.draw_chance() - 1.0);
        }
        const bool gives = !spoil || spoil(reading);
        last = reading;
        return gives;
    }
    [[nodiscard]] bool write(double now_s, const Wrench& wrench_D) noexcept override {
        return arm.write(now_s, wrench_D) && motor_works;
    }
    SimulatedArm arm;
    DeviceReading last{};                       ///< what was told last
    std::function<bool(DeviceReading&)> spoil;  ///< what a reading becomes; false: none
    bool motor_works = true;

  private:
    static constexpr double kTremble_m = 5.0e-6;
    SplitMix tremble_{1};
};

/// All that runs, for a fault to break something of.
struct FaultBench {
    static constexpr double kPress_m = 0.03;

    FaultBench()
        : hand(arm_settings(), target),
          pair(hand, {}, {.sensor = {0.05, 1.5, 300.0}}),
          loop(make_plan(), linked(pair), *channels) {
        command.lesson_alive = true;
        world.solid_poses_W[0] = floor();
    }

    static SimulatedArmSettings arm_settings() {
        SimulatedArmSettings settings = make_desktop_arm();
        settings.max_force_N = 10.0;
        settings.position_resolution_m = 0.0;  // its sensor trembles instead
        settings.human = kArm;
        return settings;
    }
    static Pose floor() { return Pose::at({0.0, -0.1, 0.0}); }  // its top is y = 0
    static HapticPlan make_plan() {
        HapticPlan plan;
        plan.expects_world = true;
        plan.lesson_force = true;
        plan.coupling.stiffness_N_per_m = 400.0;
        plan.solids = {SolidPlan{0, BoxShape{{1.0, 0.1, 1.0}}, floor()}};
        plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 20.0}};
        return plan;
    }
    // The loop is built for a device that has said what it is.
    static Device& linked(LinkPair& pair) {
        (void)pair.link();
        return pair.device;
    }
    // Round a circle, in and out of the surface by some millimetres.
    static Vector3 aim(double now_s) {
        const double turn = 2.0 * M_PI * 0.5 * now_s;
        return {0.015 * std::cos(turn), -kPress_m + 0.004 * std::sin(2.0 * M_PI * 0.9 * now_s),
                0.015 * std::sin(turn)};
    }

    void run(double seconds) {
        for (const double until_s = pair.now_s + seconds; pair.now_s < until_s - 1e-9;) {
            step();
        }
    }
    void step() {
        pair.now_s += LinkPair::kStep_s;
        if (each_round) {
            each_round();
        }
        target.publish(
            {.pose_D = Pose::at(hand_at ? hand_at(pair.now_s)
                                        : (presses ? aim(pair.now_s) : Vector3(0.0, 0.01, 0.0)))});
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
    bool presses = false;
    std::function<Vector3(double)> hand_at;  ///< where the hand wants to be, instead
    std::function<void()> each_round;        ///< what goes on breaking
    bool lesson_awake = true;
    double world_period_s = 0.001;  ///< negative: the world has stopped
    bool program_runs = true;
    bool arm_runs = true;
};

/// Who notices a fault first.
enum class Notices { nobody, arm, program, both };
[[nodiscard]] constexpr const char* name_of(Notices who) noexcept {
    constexpr const char* kNames[] = {"nobody", "arm", "program", "both"};
    return kNames[static_cast<std::size_t>(who)];
}

/// One fault: how it is broken, and what docs/safety.md promises of it.
struct FaultKind {
    std::string row;   ///< of the fault tree: what breaks
    std::string name;  ///< in the table of what was measured
    Notices who = Notices::nobody;
    Fault notice = Fault::none;  ///< the first that they tell
    double notice_ms = 0.0;      ///< at most
    // Bounds of what is felt.
    double most_N = 0.0;
    double most_step_N = 0.0;
    double most_J = 0.0;
    double gone_ms =
        0.0;  ///< at most; 0: the force stays as without a fault; negative: it stays, and may be another
    std::function<void(FaultBench&)> happens;
};

struct FaultCourse {
    double before_N = 0.0;
    Notices who = Notices::nobody;
    Fault notice = Fault::none;
    double notice_s = std::numeric_limits<double>::infinity();
    double peak_N = 0.0;  ///< after the fault
    double largest_step_N = 0.0;
    double given_J = 0.0;  ///< to the hand and not given back, at most
    double gone_s = std::numeric_limits<double>::infinity();  ///< below 0.01 N for good
    double end_N = 0.0;
};

/// Pressing, before anything breaks.
inline void press(FaultBench& bench) {
    bench.run(0.5);
    bench.presses = true;
    bench.run(4.0);
}

inline FaultCourse run_fault(const FaultKind& kind, double seconds = 1.0) {
    FaultBench bench;
    press(bench);
    FaultCourse course;
    course.before_N = bench.hand.arm.force_D().norm();
    kind.happens(bench);
    double given_J = 0.0;
    const double began_s = bench.pair.now_s;
    Vector3 x_before = bench.hand.arm.position_D();
    Vector3 f_before = bench.hand.arm.force_D();
    while (bench.pair.now_s - began_s < seconds - 1e-9) {
        bench.step();
        const double since_s = bench.pair.now_s - began_s;
        const Fault arm = bench.pair.server.status().faults;
        const Fault program = bench.loop.state().faults;
        if (course.who == Notices::nobody && any(arm | program)) {
            course.who = !any(program) ? Notices::arm : any(arm) ? Notices::both : Notices::program;
            course.notice = arm | program;
            course.notice_s = since_s;
        }
        const Vector3 x = bench.hand.arm.position_D();
        const Vector3 f = bench.hand.arm.force_D();
        given_J = std::max(given_J + f_before.dot(x - x_before), 0.0);
        course.given_J = std::max(course.given_J, given_J);
        course.peak_N = std::max(course.peak_N, f.norm());
        course.largest_step_N = std::max(course.largest_step_N, (f - f_before).norm());
        if (f.norm() >= 0.01) {
            course.gone_s = std::numeric_limits<double>::infinity();
        } else if (!std::isfinite(course.gone_s)) {
            course.gone_s = since_s;
        }
        x_before = x;
        f_before = f;
    }
    course.end_N = bench.hand.arm.force_D().norm();
    return course;
}

}  // namespace fulcrum::test_link
