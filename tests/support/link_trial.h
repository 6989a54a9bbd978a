// A wall felt over the arm link, in closed loop under one clock: haptic loop, link with faults, arm's server, simulated arm and
// the hand that holds it.
//
//   the wall is a spring about its surface, F = -K y, both ways, felt through the whole haptic loop with its own passivity and
//   limits; the hand wants to be press_m inside; with an arm of seven joints a torque turns it while it presses, too
// The two sides run in turn, the arm's half a round after the program's, or with rounds of its own (ArmRounds). Calm: in the last quarter of the run the hand's true
// position swings by less than kCalm_m.
#pragma once

#include "haptics/device/arm/simulated_wam.h"
#include "haptics/device/simulated/simulated_arm.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/math/rotation.h"
#include "tests/support/link.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace fulcrum::test_link {

/// When the arm's rounds come: every `every`-th millisecond and a half, each up to jitter_s late; with late_chance by up to late_s more, and
/// what it so misses it leaves out, as a thread does that others kept from running.
struct ArmRounds {
    int every = 1;
    double jitter_s = 0.0;
    double late_chance = 0.0;
    double late_s = 0.0;
    std::uint64_t seed = 5;
};

/// Their times.
class ArmClock {
  public:
    explicit ArmClock(const ArmRounds& rounds, double began_s)
        : rounds_(rounds), chance_(rounds.seed), began_s_(began_s) {}
    [[nodiscard]] double next_s() {
        constexpr double kRound_s = LinkPair::kStep_s;
        round_ += rounds_.every;
        double late_s = rounds_.jitter_s * chance_.draw_chance();
        if (chance_.draw_chance() < rounds_.late_chance) {
            late_s += rounds_.late_s * chance_.draw_chance();
        }
        const double due_s = kRound_s * (static_cast<double>(round_) + 0.5);
        round_ = std::max(round_, static_cast<long>(std::floor((due_s + late_s) / kRound_s - 0.5)));
        return began_s_ + due_s + late_s;
    }

  private:
    ArmRounds rounds_;
    SplitMix chance_;
    double began_s_;
    long round_ = 0;
};

struct LinkTrial {
    double stiffness_N_per_m = 500.0;
    LinkFaults faults{};
    bool balances_energy = true;
    EnergyBalanceSettings energy{};
    /// With a desktop arm's encoder.
    SimulatedArmSettings arm{.mass_kg = 0.25,
                             .damping_Ns_per_m = 0.2,
                             .position_resolution_m = 5.5e-5,
                             .human = kFingertip};
    std::optional<SimulatedWamSettings> wam{};  ///< instead of that arm
    double torque_Nm = 0.0;                     ///< about the wall's normal while it presses
    ArmRounds rounds{};
    double press_m = 0.01;
    double limit_N = 10.0;  ///< of lesson, site and program, the least
    double seconds = 8.0;
    double stroke_m = 0.0;  ///< to and fro by this, four times a second, in the last quarter
    int slow_presses = 0;   ///< instead of all that: so many, kSlowPress_s each, and out again
};

inline constexpr double kCalm_m = 2.0e-4;
inline constexpr double kSlowPress_s = 3.0;  ///< at most 10 mm/s for 10 mm
inline constexpr double kPressesFrom_s = 0.5;

struct LinkCourse {
    double swing_m = 0.0;         ///< in the last quarter
    double peak_N = 0.0;          ///< on the hand, whole run
    double force_N = 0.0;         ///< mean of the last quarter
    double peak_Nm = 0.0;         ///< torque on the hand, whole run
    double turn_swing_rad = 0.0;  ///< of the handle about the wall's normal, in the last quarter
    double given_J =
        0.0;  ///< to the hand and not given back, largest of all times since a second into the run
    double net_J = 0.0;          ///< to the hand, less what it gave, whole run
    double peak_debt_J = 0.0;    ///< at the arm, whole run
    double least_later_J = 0.0;  ///< the least of it after that
    std::uint64_t trips = 0;     ///< of the arm's gate
    bool linked = false;
    [[nodiscard]] bool is_calm() const { return linked && swing_m < kCalm_m; }
};

/// The arm of a trial, and what is true of it.
class TrialArm {
  public:
    TrialArm(const LinkTrial& trial, LatestValue<HandTarget>& target) {
        if (trial.wam) {
            wam_ = std::move(*SimulatedWam::create(*trial.wam, target));
        } else {
            desktop_ = std::make_unique<SimulatedArm>(trial.arm, target);
        }
    }
    [[nodiscard]] Device& device() {
        return wam_ ? static_cast<Device&>(*wam_) : static_cast<Device&>(*desktop_);
    }
    [[nodiscard]] double mass_kg() { return device().traits().mass_kg; }
    /// Along the wall's normal.
    [[nodiscard]] double position_m() const {
        return wam_ ? wam_->compute_pose_D().position.x() : desktop_->position_D().x();
    }
    /// About it.
    [[nodiscard]] double turn_rad() const {
        return wam_ ? compute_log(wam_->compute_pose_D().orientation).x() : 0.0;
    }

  private:
    std::unique_ptr<SimulatedWam> wam_;
    std::unique_ptr<SimulatedArm> desktop_;
};

/// The wall alone, felt through the whole loop.
[[nodiscard]] inline HapticPlan make_link_plan(const LinkTrial& trial) {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.safety.max_force_N = trial.limit_N;
    plan.safety.soft_start_s = 0.0;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), trial.stiffness_N_per_m}};
    plan.lesson_force = trial.torque_Nm != 0.0;
    return plan;
}

/// Whether the hand wants to be in: in and out four times, then it stays in.
[[nodiscard]] inline bool presses_at(double run_s) {
    return run_s > kPressesFrom_s && (run_s > 4.0 || std::fmod(run_s, 0.8) < 0.5);
}

/// How far in the hand wants to be, of press_m.
[[nodiscard]] inline double find_press(const LinkTrial& trial, double run_s) {
    if (trial.slow_presses == 0) {
        return presses_at(run_s) ? 1.0 : 0.0;
    }
    const double pressed_s = run_s - kPressesFrom_s;
    const bool presses = pressed_s > 0.0 && pressed_s < trial.slow_presses * kSlowPress_s;
    return presses ? 0.5 - 0.5 * std::cos(2.0 * M_PI * pressed_s / kSlowPress_s) : 0.0;
}

/// Of slow presses: until the hand is out and at rest.
[[nodiscard]] inline LinkTrial with_slow_presses(LinkTrial trial, int n) {
    trial.slow_presses = n;
    trial.seconds = 2.0 * kPressesFrom_s + n * kSlowPress_s;
    return trial;
}

[[nodiscard]] inline LinkCourse run_link_trial(const LinkTrial& trial) {
    LatestValue<HandTarget> target;
    TrialArm arm(trial, target);
    target.publish({});
    ArmServerSettings server_settings;
    server_settings.balances_energy = trial.balances_energy;
    server_settings.handle_mass_kg = trial.wam ? arm.mass_kg() : trial.arm.mass_kg;
    LinkDeviceSettings device_settings;
    device_settings.balances_energy = trial.balances_energy;
    server_settings.energy = trial.energy;
    device_settings.energy = trial.energy;
    device_settings.max_force_N = trial.limit_N;
    device_settings.most_round_trip_s = 1.0;
    LinkPair pair(arm.device(), trial.faults, server_settings, device_settings);
    LinkCourse course;
    if (!pair.link(3.0)) {
        return course;
    }
    const HapticPlan plan = make_link_plan(trial);
    const auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, pair.device, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    channels->command.publish(command);

    const double began_s = pair.now_s;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    double given_J = 0.0;
    double sum_N = 0.0;
    int n_last = 0;
    double lowest_rad = lowest;
    double highest_rad = highest;
    double x_before = arm.position_m();
    ArmClock arm_clock(trial.rounds, began_s);
    double arm_next_s = arm_clock.next_s();
    while (pair.now_s - began_s < trial.seconds) {
        pair.now_s += LinkPair::kStep_s;
        const double run_s = pair.now_s - began_s;
        const double stroke_m = run_s > 0.75 * trial.seconds
                                    ? trial.stroke_m * std::sin(2.0 * M_PI * 4.0 * run_s)
                                    : 0.0;
        target.publish(
            {.pose_D = Pose::at({find_press(trial, run_s) * trial.press_m + stroke_m, 0.0, 0.0})});
        if (plan.lesson_force) {
            command.stamp_s = command.linearised.stamp_s = pair.now_s;
            command.linearised.torque_W.x() = presses_at(run_s) ? trial.torque_Nm : 0.0;
            channels->command.publish(command);
        }
        loop.step(pair.now_s);
        while (arm_next_s < pair.now_s + LinkPair::kStep_s) {
            const double force_N = pair.server.status().applied_D.force.x();
            pair.server.step(arm_next_s);
            const double debt_J = pair.server.status().excess_J;
            course.least_later_J = std::min(course.least_later_J, debt_J);
            if (debt_J >= course.peak_debt_J) {
                course.peak_debt_J = course.least_later_J = debt_J;
            }
            arm_next_s = arm_clock.next_s();
            const double x = arm.position_m();
            course.net_J += force_N * (x - x_before);
            if (run_s > 1.0) {
                given_J = std::max(given_J + force_N * (x - x_before), 0.0);
                course.given_J = std::max(course.given_J, given_J);
            }
            x_before = x;
            const Wrench& felt_D = pair.server.status().applied_D;
            course.peak_N = std::max(course.peak_N, felt_D.force.norm());
            course.peak_Nm = std::max(course.peak_Nm, felt_D.torque.norm());
        }
        const double x = x_before;
        if (run_s > 0.75 * trial.seconds) {
            lowest = std::min(lowest, x);
            highest = std::max(highest, x);
            lowest_rad = std::min(lowest_rad, arm.turn_rad());
            highest_rad = std::max(highest_rad, arm.turn_rad());
            sum_N += pair.server.status().applied_D.force.x();
            ++n_last;
        }
    }
    course.linked = pair.device.status().linked;
    course.swing_m = highest - lowest;
    course.turn_swing_rad = highest_rad - lowest_rad;
    course.force_N = sum_N / std::max(n_last, 1);
    course.trips = pair.server.status().trips;
    return course;
}

}  // namespace fulcrum::test_link
