#include "haptics/loop/realtime_thread.h"
#include "runtime/link/udp_socket.h"
#include "tests/bench/harness/curve.h"
#include "tests/support/link_trial.h"

#include <chrono>
#include <thread>

namespace fulcrum::bench {
namespace {

using namespace test_link;

// A wall felt over the arm link in real time: the haptic loop on one thread, the arm's server, its arm and the hand on another, and UDP
// sockets of this computer between them, whose packets are delayed and lost on the way in and out.
//
// As link_trial.h has it under one clock, with the machine's own clocks, wake-ups and system calls instead.

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

// The map of link_stability.cpp in real time, over sockets of this computer, beside the same walls on simulated lines under one clock.

constexpr double kSocketThrown_J = 0.1;
constexpr double kSocketSoftest_N_per_m = 50.0;
constexpr double kSocketStiffest_N_per_m = 3200.0;

// How evenly the threads ran in all trials.
struct SocketPace {
    double late_99_s = 0.0;
    std::uint64_t misses = 0;
};

// Up by twos until the hand is thrown; the stiffest that did not.
template <class IsQuiet>
double find_stiffest_by_twos(LinkTrial trial, const IsQuiet& is_quiet) {
    double stiffest = kNone;
    for (double k = kSocketSoftest_N_per_m; k <= kSocketStiffest_N_per_m; k *= 2.0) {
        trial.stiffness_N_per_m = k;
        if (!is_quiet(trial)) {
            break;
        }
        stiffest = k;
    }
    return stiffest;
}

Report run_link_sockets(Run& run) {
    LineChart chart;
    chart.name = "link-sockets";
    chart.title = "Stable walls over real sockets, fingertip";
    chart.x = {"delay each way", "ms", false};
    chart.y = {"largest stable stiffness", "N/m", true};
    chart.reference = "the same walls under one clock (dashed), as in link-stability";
    chart.advice =
        "What is stable under one clock is so between two threads over sockets as long as both "
        "keep their rounds; look at the lateness in the heading before a difference is believed.";
    const auto delays_ms = run.pick<std::vector<double>>({0.0, 5.0, 10.0, 20.0}, {10.0});
    const double trial_s = run.pick(3.0, 1.0);
    SocketPace pace;
    double share = 0.0;
    for (const double loss : {0.0, 0.05}) {
        for (const bool balances : {true, false}) {
            const std::string name = std::string(loss > 0.0 ? "5 % in bursts of 10" : "no loss") +
                                     (balances ? "" : ", no balance");
            Line felt{name, LineStyle::measured, delays_ms, {}};
            Line simulated{name + ", one clock", LineStyle::theory, delays_ms, {}};
            for (const double delay_ms : delays_ms) {
                LinkTrial trial;
                trial.faults = {
                    .loss = loss, .burst = loss > 0.0 ? 10 : 1, .delay_s = 1e-3 * delay_ms};
                trial.balances_energy = balances;
                trial.seconds = trial_s;
                simulated.y.push_back(find_stiffest_by_twos(trial, [](const LinkTrial& t) {
                    const test_link::LinkCourse course = test_link::run_link_trial(t);
                    return course.linked && course.given_J < kSocketThrown_J;
                }));
                felt.y.push_back(find_stiffest_by_twos(trial, [&](const LinkTrial& t) {
                    const SocketCourse course = run_socket_trial(t);
                    pace.late_99_s = std::max(pace.late_99_s, course.late_99_s);
                    pace.misses += course.misses;
                    return course.felt.linked && course.felt.given_J < kSocketThrown_J;
                }));
                share += 1.0 / (4.0 * static_cast<double>(delays_ms.size()));
                run.progress(std::min(share, 1.0), name);
            }
            chart.lines.push_back(felt);
            chart.lines.push_back(simulated);
        }
    }
    chart.work =
        "As link-stability, in real time: haptic loop and arm's server on threads of their own at "
        "1 kHz, UDP sockets of this computer between them, packets delayed and lost on the way; "
        "three seconds a wall, one in a quick run, doubled until the hand is given more than 0.1 "
        "J. Rounds of the arm "
        "began at most " +
        to_text(1e3 * pace.late_99_s) + " ms late (99 %, worst trial), " +
        std::to_string(pace.misses) + " rounds of both were missed in all.";
    return {chart};
}

const Registration kLinkSockets{{"link-sockets",
                                 "the same in real time over sockets, beside the simulated line",
                                 run_link_sockets}};

}  // namespace
}  // namespace fulcrum::bench
