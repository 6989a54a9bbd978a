// fulcrum arm: the arm's side of the link, with a real arm or with a simulated one for trying and testing; fulcrum stop.
#include "haptics/base/clock.h"
#include "haptics/link/arm_server.h"
#include "haptics/link/link_faults.h"
#include "haptics/loop/realtime_thread.h"
#include "runtime/app/commands.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/own_arm.h"
#include "runtime/app/served_arm.h"
#include "runtime/app/site_file.h"
#include "runtime/app/stop_signal.h"
#include "runtime/link/arm_key.h"
#include "runtime/link/udp_socket.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <poll.h>
#include <string>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace fulcrum::runtime {
namespace {

// What somebody types at the arm: nothing, or a whole line.
std::string read_line_now() {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    static bool ended = false;
    if (ended || ::poll(&input, 1, 0) <= 0 || (input.revents & POLLIN) == 0) {
        return {};
    }
    char letters[256];
    const ssize_t got = ::read(STDIN_FILENO, letters, sizeof letters);
    ended = got <= 0;
    return got > 0 ? std::string(letters, static_cast<std::size_t>(got)) : std::string();
}

// Whoever does not read what is printed must not keep keys from being heard.
bool can_print() {
    pollfd output{STDOUT_FILENO, POLLOUT, 0};
    return ::poll(&output, 1, 0) > 0 && (output.revents & POLLOUT) != 0;
}

// To a program that this is attached to, in its words (own_arm.h).
void say_line(std::string_view begin, const std::string& rest) {
    std::printf("%.*s%s\n", static_cast<int>(begin.size()), begin.data(), rest.c_str());
    (void)std::fflush(stdout);
}

// Why there is no arm, to whoever started it.
int refuse_arm(const Options& options, const Error& error) {
    if (options.arm.is_attached) {
        say_line(kArmError, to_sentence(error));
    }
    return complain(error, 2);
}

// Where the hand that holds the arm wants to be: still, or slowly round an upright circle.
HandTarget hand_at(double now_s, const ArmOptions& options) {
    constexpr double kRadius_m = 0.03;
    constexpr double kTurns_per_s = 0.2;
    HandTarget target;
    if (options.motion == ArmMotion::circle) {
        const double angle = 2.0 * std::numbers::pi * kTurns_per_s * now_s;
        target.pose_D.position = {kRadius_m * std::sin(angle), kRadius_m * (1.0 - std::cos(angle)),
                                  0.0};
    }
    return target;
}

// One line on how it goes.
std::string describe(const ArmServerStatus& status) {
    const auto count = [&](Refusal why) {
        return static_cast<unsigned long long>(
            status.counts.received[static_cast<std::size_t>(why)]);
    };
    char line[280];
    std::snprintf(line, sizeof line,
                  "%s, %.2f N (most %.2f), round trip %.2f ms, clocks differ by %.3f s, %llu "
                  "commands, %llu refused (%llu of another key, %llu of another version), %llu "
                  "faded, gone %.0f ms after the last command%s",
                  status.held ? "held" : "waiting", status.applied_D.force.norm(),
                  status.peak_force_N, 1e3 * status.round_trip_s, status.offset_s,
                  count(Refusal::none), static_cast<unsigned long long>(status.counts.refused()),
                  count(Refusal::forged), count(Refusal::version),
                  static_cast<unsigned long long>(status.trips), 1e3 * status.gone_after_s,
                  status.gate == GatePhase::stopped ? ", STOPPED: Enter lifts it" : "");
    return line;
}

std::string describe(const LinkFaultCounts& counts) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "On the line: %llu passed, %llu lost, %llu delayed, %llu overtaken, %llu "
                  "doubled, %llu damaged, %llu dropped.",
                  static_cast<unsigned long long>(counts.passed),
                  static_cast<unsigned long long>(counts.lost),
                  static_cast<unsigned long long>(counts.delayed),
                  static_cast<unsigned long long>(counts.overtaken),
                  static_cast<unsigned long long>(counts.doubled),
                  static_cast<unsigned long long>(counts.damaged),
                  static_cast<unsigned long long>(counts.dropped));
    return line;
}

// Whoever is attached to a program ends when that does.
bool input_ends() {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    char letters[256];
    return ::poll(&input, 1, 0) > 0 && ::read(STDIN_FILENO, letters, sizeof letters) <= 0;
}

// What has happened to a real arm.
std::string take_notice(const ServedArm& arm) {
    return arm.port != nullptr ? arm.port->take_notice() : std::string();
}

std::string words_again(const ServedArm& arm) {
    std::string words;
    if (arm.port != nullptr) {
        for (const std::string& word : arm.port->words_again()) {
            words += (words.empty() ? "" : " ") + word;
        }
    }
    return words;
}

// The same for a program: it is told what happens, and that this still lives.
void attend_attached(const ServedArm& arm, LatestValue<HandTarget>& target, const Options& options,
                     double epoch_s) {
    constexpr auto kPause = std::chrono::milliseconds(10);
    double told_s = 0.0;
    while (!interrupted() && !input_ends()) {
        const double now_s = monotonic_now_s() - epoch_s;
        target.publish(hand_at(now_s, options.arm));
        if (const std::string notice = take_notice(arm); !notice.empty()) {
            say_line(kArmTold, notice);
        }
        if (now_s - told_s >= kArmBeat_s && can_print()) {
            told_s = now_s;
            say_line(kArmBeat, {});
        }
        std::this_thread::sleep_for(kPause);
    }
}

// Until somebody ends it: the hand moves, keys are heard, a line a second says how it goes.
void attend(ArmServer& server, const ServedArm& arm, LatestValue<HandTarget>& target,
            const Options& options, double epoch_s) {
    constexpr auto kPause = std::chrono::milliseconds(10);
    constexpr double kTell_s = 1.0;
    double told_s = 0.0;
    for (double now_s = 0.0; !interrupted() && now_s < options.seconds.value_or(1.0e9);
         now_s = monotonic_now_s() - epoch_s) {
        target.publish(hand_at(now_s, options.arm));
        const std::string line = read_line_now();
        if (line.find('s') != std::string::npos) {
            server.stop();
        } else if (!line.empty()) {
            server.rearm();
        }
        if (const std::string notice = take_notice(arm); !notice.empty()) {
            std::printf("%s\n", notice.c_str());
        }
        if (now_s - told_s >= kTell_s && can_print()) {
            told_s = now_s;
            std::printf("%7.1f s: %s\n", now_s, describe(server.status()).c_str());
            (void)std::fflush(stdout);
        }
        std::this_thread::sleep_for(kPause);
    }
}

}  // namespace

int arm_command(const Options& options) {
    const auto key = find_arm_key_file(options.arm.key_file).and_then(load_or_make_arm_key);
    if (!key) {
        return refuse_arm(options, key.error());
    }
    auto socket = UdpSocket::listen({options.arm.address, options.arm.port});
    if (!socket) {
        return refuse_arm(options, socket.error());
    }
    const SodiumSeal seal(*key);
    SodiumNumbers numbers;
    FaultyDatagrams line(options.arm.faults, **socket);
    LatestValue<HandTarget> target;
    target.publish({});
    auto arm = open_served_arm(options.arm, target);
    if (!arm) {
        return refuse_arm(options, arm.error());
    }
    // The same limits of this place as at a program.
    const auto site = find_site_limits(options.force_limit_N);
    if (!site) {
        return refuse_arm(options, site.error());
    }
    ArmServerSettings& settings = arm->settings;
    apply(*site, settings.safety);
    if (auto good = validate(settings); !good) {
        return refuse_arm(options, good.error());
    }
    ArmServer server(settings, *arm->device, line, seal, numbers);
    watch_for_stop_signal();
    set_stop_target(&server.stop_switch());

    RealtimeSettings pace;
    pace.rate_Hz = settings.rate_Hz;
    pace.epoch_s = monotonic_now_s();
    RealtimeThread thread;
    if (auto started = thread.start(server, pace); !started) {
        return refuse_arm(options, started.error());
    }
    if (options.arm.is_attached) {
        say_line(kArmNamed, arm->device->traits().name);
        say_line(kArmSame, words_again(*arm));
        say_line(kArmAt, std::to_string((*socket)->port()));
        attend_attached(*arm, target, options, pace.epoch_s);
    } else {
        std::printf(
            "%s waits at %s:%u. Play with it: ./fulcrum run gravity --hand "
            "udp:%s:%u\nEnter lifts a stop, s and Enter presses it, Ctrl-C ends.\n",
            arm->port != nullptr ? arm->device->traits().name.c_str() : "A simulated arm",
            options.arm.address.c_str(), (*socket)->port(), options.arm.address.c_str(),
            (*socket)->port());
        (void)std::fflush(stdout);
        attend(server, *arm, target, options, pace.epoch_s);
    }
    thread.stop();
    set_stop_target(nullptr);
    if (options.arm.is_attached) {
        return interrupt_exit_code();
    }
    std::printf("At the end: %s\n%s\n", describe(server.status()).c_str(),
                describe(line.counts()).c_str());
    return interrupt_exit_code();
}

int stop_command(const Options& options) {
    const auto stopped = stop_all_hands({.only = options.only_process});
    if (!stopped) {
        return complain(stopped.error(), 1);
    }
    const std::size_t n_silent = stopped->silent.size();
    if (stopped->n_stopped + n_silent == 0 && options.only_process) {
        std::fprintf(
            stderr,
            "Process %d moves no hand of yours: nothing was stopped. Without --only all are.\n",
            *options.only_process);
        return 1;
    }
    if (stopped->n_stopped > 0) {
        std::printf("Stopped: %zu. Enter in its window, or at the arm, lets it go on.\n",
                    stopped->n_stopped);
    } else if (n_silent == 0) {
        std::printf("Nothing of yours is running that moves a hand.\n");
    }
    for (const pid_t id : stopped->silent) {
        std::fprintf(
            stderr,
            "Process %d was told to stop and has not said that its force is gone; if a hand "
            "is pushed still, switch the arm off.\n",
            static_cast<int>(id));
    }
    return n_silent == 0 ? 0 : 1;
}

}  // namespace fulcrum::runtime
