// A wall felt over the arm link in real time: the haptic loop on one thread, the arm's server, its arm and the hand on another, and UDP
// sockets of this computer between them, whose packets are delayed and lost on the way in and out.
//
// As link_trial.h has it under one clock, with the machine's own clocks, wake-ups and system calls instead.
#pragma once

#include "haptics/loop/realtime_thread.h"
#include "runtime/link/udp_socket.h"
#include "tests/support/link_trial.h"

#include <chrono>
#include <thread>

namespace fulcrum::test_link {

/// The arm's side: serves, moves the hand, counts what it is given.
class SocketArm final : public PeriodicTask {
  public:
    SocketArm(const LinkTrial& trial, Datagrams& datagrams, const Seal& seal,
              SessionNumbers& numbers)
        : trial_(trial),
          arm_(trial.arm, target_),
          server_(settings_of(trial), arm_, datagrams, seal, numbers) {
        target_.publish({});
    }
    void step(double now_s) noexcept override {
        if (began_s_ < 0.0 && server_.status().held) {
            began_s_ = now_s;
        }
        const double run_s = began_s_ < 0.0 ? 0.0 : now_s - began_s_;
        target_.publish({.pose_D = Pose::at({presses_at(run_s) ? trial_.press_m : 0.0, 0.0, 0.0})});
        const double force_N = arm_.force_D().x();
        server_.step(now_s);
        const double x = arm_.position_D().x();
        if (run_s > 1.0) {
            given_J_ = std::max(given_J_ + force_N * (x - x_before_), 0.0);
            course_.given_J = std::max(course_.given_J, given_J_);
        }
        x_before_ = x;
        course_.peak_N = std::max(course_.peak_N, arm_.force_D().norm());
        course_.trips = server_.status().trips;
    }
    void silence(double now_s) noexcept override { server_.silence(now_s); }
    /// When the thread has ended.
    [[nodiscard]] const LinkCourse& course() const { return course_; }

  private:
    static ArmServerSettings settings_of(const LinkTrial& trial) {
        ArmServerSettings settings;
        settings.balances_energy = trial.balances_energy;
        settings.handle_mass_kg = trial.arm.mass_kg;
        settings.energy = trial.energy;
        return settings;
    }
    LinkTrial trial_;
    LatestValue<HandTarget> target_;
    SimulatedArm arm_;
    ArmServer server_;
    double began_s_ = -1.0;
    double x_before_ = 0.0;
    double given_J_ = 0.0;
    LinkCourse course_{};
};

/// How such a trial went, and how evenly the threads ran.
struct SocketCourse {
    LinkCourse felt{};
    double late_99_s = 0.0;  ///< rounds of the arm, 99 %
    std::uint64_t misses = 0;
};

/// In as many seconds as the trial has. Nothing but `felt.linked` false where the system gives no socket.
[[nodiscard]] inline SocketCourse run_socket_trial(const LinkTrial& trial) {
    SocketCourse result;
    auto arm_socket = runtime::UdpSocket::listen({"127.0.0.1", 0});
    if (!arm_socket) {
        return result;
    }
    auto program_socket = runtime::UdpSocket::connect({"127.0.0.1", (*arm_socket)->port()});
    if (!program_socket) {
        return result;
    }
    const HmacSeal seal;
    CountedNumbers arm_numbers(2000);
    CountedNumbers program_numbers(1000);
    FaultyDatagrams line(trial.faults, **program_socket);
    SocketArm arm(trial, **arm_socket, seal, arm_numbers);
    LinkDeviceSettings device_settings;
    device_settings.balances_energy = trial.balances_energy;
    device_settings.energy = trial.energy;
    device_settings.max_force_N = 10.0;
    device_settings.most_round_trip_s = 1.0;
    LinkDevice device(device_settings, line, seal, program_numbers);
    RealtimeSettings pace;
    pace.epoch_s = monotonic_now_s();
    RealtimeThread arm_thread;
    if (!arm_thread.start(arm, pace)) {
        return result;
    }
    const auto now_s = [&] { return monotonic_now_s() - pace.epoch_s; };
    while (!device.greet(now_s()) && now_s() < 3.0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const HapticPlan plan = make_link_plan(trial);
    const auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, device, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    channels->command.publish(command);
    RealtimeThread loop_thread;
    if (loop_thread.start(loop, pace)) {
        std::this_thread::sleep_for(std::chrono::duration<double>(trial.seconds));
        loop_thread.stop();
    }
    arm_thread.stop();
    result.felt = arm.course();
    result.felt.linked = device.status().sessions == 1;
    result.late_99_s = arm_thread.lateness().compute_quantile_s(0.99);
    result.misses = arm_thread.status().misses + loop_thread.status().misses;
    return result;
}

}  // namespace fulcrum::test_link
