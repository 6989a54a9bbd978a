// Every single fault of docs/safety.md that the closed loop of fault_bench.h can have, in the order of its tree, each with its bounds.
#pragma once

#include "tests/support/fault_bench.h"

#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::test_link {

namespace faults {

using Happens = std::function<void(FaultBench&)>;

/// A reading is spoiled from now on.
inline Happens spoil(std::function<bool(DeviceReading&)> how) {
    return [how = std::move(how)](FaultBench& b) { b.hand.spoil = how; };
}
/// The line is as given from now on.
inline Happens line(const LinkFaults& faults) {
    return [faults](FaultBench& b) { b.pair.faulty.set(faults); };
}
/// Somebody sends a command of 9 N in every round, and seals it so.
inline Happens stranger(std::uint8_t key, std::uint64_t sender) {
    return [key, sender](FaultBench& b) {
        const auto seal = std::make_shared<HmacSeal>(key);
        const auto n = std::make_shared<std::uint64_t>(1'000'000);
        b.each_round = [&b, seal, n, sender] {
            LinkPacket packet;
            packet.head = {PacketKind::command,           sender, 2000, ++*n,
                           LinkPost::to_ns(b.pair.now_s), 0,      0};
            packet.command.wrench_D.force = {-9.0, 0.0, 0.0};
            packet.command.max_force_N = 10.0;
            packet.command.max_slew_N_per_s = 500.0;
            PacketBytes bytes{};
            const std::size_t size = write_packet(packet, *seal, bytes);
            b.pair.channel.end(0).send(b.pair.now_s, {}, std::span(bytes).first(size));
        };
    };
}
/// The program's rounds stop for so long, five times a second.
inline Happens late_rounds(double late_s) {
    return [late_s](FaultBench& b) {
        const double since_s = b.pair.now_s;
        b.each_round = [&b, since_s, late_s] {
            b.program_runs = std::fmod(b.pair.now_s - since_s, 0.2) >= late_s;
        };
    };
}
/// So many packets are lost in a row either way, once.
inline Happens lose(int n) {
    return [n](FaultBench& b) {
        const double until_s = b.pair.now_s + n * LinkPair::kStep_s;
        b.each_round = [&b, until_s] { b.pair.tap.cut = b.pair.now_s < until_s + 1e-9; };
    };
}

// What a position sensor can do that the hand does not.

inline Happens freeze() {
    return [](FaultBench& b) {
        const Vector3 last = b.hand.last.pose_D.position;
        b.hand.spoil = [last](DeviceReading& r) {
            r.pose_D.position = last;
            return true;
        };
    };
}
/// To and fro by `size_m`, each time after so many readings.
inline Happens chatter(double size_m, int every) {
    return [size_m, every](FaultBench& b) {
        const auto n = std::make_shared<int>(0);
        b.hand.spoil = [n, size_m, every](DeviceReading& r) {
            r.pose_D.position.y() += (*n)++ / every % 2 == 0 ? size_m : 0.0;
            return true;
        };
    };
}
/// Away from the hand, into the surface.
inline Happens drift(double speed_m_per_s) {
    return [speed_m_per_s](FaultBench& b) {
        const double since_s = b.pair.now_s;
        b.hand.spoil = [since_s, speed_m_per_s](DeviceReading& r) {
            r.pose_D.position.y() -= speed_m_per_s * (r.stamp_s - since_s);
            return true;
        };
    };
}
/// Its clock stands where it was, or goes back from there.
inline Happens hold_clock(double back_s) {
    return [back_s](FaultBench& b) {
        const double stamp_s = b.hand.last.stamp_s - back_s;
        b.hand.spoil = [stamp_s](DeviceReading& r) {
            r.stamp_s = stamp_s;
            return true;
        };
    };
}

}  // namespace faults

/// Faults of the arm and of its sensors.
[[nodiscard]] inline std::vector<FaultKind> arm_faults() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const char* const kNoPose = "the arm gives no pose, or no number";
    const char* const kFrozen = "a sensor is frozen: the same place to the bit";
    const char* const kShakes = "a sensor shakes";
    const char* const kDrifts = "a sensor drifts";
    // The limit, over the way that it moves the hand that holds it.
    constexpr double kDrift_J = 5.0 * 5.0 / kArm.stiffness_N_per_m;
    using namespace faults;
    return {
        {kNoPose, "no pose", Notices::arm, Fault::device_read, 1, 3.2, 0.05, 0.001, 101,
         spoil([](DeviceReading&) { return false; })},
        {kNoPose, "no number", Notices::arm, Fault::device_invalid, 1, 3.2, 0.05, 0.001, 101,
         spoil([nan](DeviceReading& r) {
             r.pose_D.position.x() = nan;
             return true;
         })},
        {"a sensor jumps", "a jump by 10 cm", Notices::arm, Fault::device_invalid, 1, 3.2, 0.05,
         0.001, 101, spoil([](DeviceReading& r) {
             r.pose_D.position.x() += 0.1;
             return true;
         })},
        {"a sensor's clock stands still", "a clock that stands", Notices::arm, Fault::device_stale,
         21, 3.25, 0.1, 0.002, 121, hold_clock(0.0)},
        {"a sensor's clock goes back", "a clock that goes back by 5 ms", Notices::arm,
         Fault::device_invalid, 1, 3.2, 0.05, 0.001, 101, hold_clock(0.005)},
        {kFrozen, "a frozen sensor", Notices::arm, Fault::device_stale, 51, 3.3, 0.05, 0.004, 151,
         freeze()},
        {kShakes, "1 mm to and fro, 500 Hz", Notices::arm, Fault::device_invalid, 6, 3.3, 4.6,
         0.002, 106, chatter(1.0e-3, 1)},
        {kShakes, "1 mm to and fro, 125 Hz", Notices::arm, Fault::device_invalid, 16, 5.0, 4.6,
         0.002, 116, chatter(1.0e-3, 4)},
        {kShakes, "0.1 mm to and fro, 500 Hz", Notices::nobody, Fault::none, 0, 5.0, 3.5, 0.01, 0,
         chatter(0.1e-3, 1)},
        {kDrifts, "a drift of 5 mm/s", Notices::nobody, Fault::none, 0, 4.3, 0.35, kDrift_J, -1,
         drift(0.005)},
        {kDrifts, "a drift of 50 mm/s", Notices::nobody, Fault::none, 0, 5.0, 0.9, kDrift_J, -1,
         drift(0.05)},
        {kDrifts, "a drift of 1 m/s", Notices::nobody, Fault::none, 0, 5.0, 2.0, kDrift_J, -1,
         drift(1.0)},
        {"the motor refuses", "the motor refuses", Notices::arm, Fault::device_write, 2, 3.25, 0.05,
         0.001, 102, [](FaultBench& b) { b.hand.motor_works = false; }},
    };
}

/// Faults of the line, and of who is on it; and the clutch.
[[nodiscard]] inline std::vector<FaultKind> line_faults() {
    const char* const kCut = "the cable is pulled, the radio is jammed";
    const char* const kOrder = "packets doubled, late, in any order";
    const char* const kForged = "packets damaged or forged";
    using namespace faults;
    return {
        {kCut, "the cable is pulled", Notices::both, Fault::command_stale, 20, 3.25, 0.3, 0.001,
         120, [](FaultBench& b) { b.pair.tap.cut = true; }},
        {"up to ten packets in a row are lost", "a twentieth lost, in bursts of ten",
         Notices::nobody, Fault::none, 0, 3.45, 0.35, 0.005, 0, line({.loss = 0.05, .burst = 10})},
        {"up to ten packets in a row are lost", "nineteen lost in a row", Notices::nobody,
         Fault::none, 0, 3.4, 0.35, 0.005, 0, lose(19)},
        {"twenty packets in a row and more are lost, either way", "twenty lost in a row",
         Notices::both, Fault::command_stale, 20, 3.25, 0.3, 0.001, 121, lose(20)},
        {kOrder, "all doubled", Notices::nobody, Fault::none, 0, 3.4, 0.3, 0.005, 0,
         line({.duplicate = 1.0})},
        {kOrder, "up to 10 ms late, in any order", Notices::nobody, Fault::none, 0, 3.45, 0.4,
         0.005, 0, line({.jitter_s = 0.01})},
        {kOrder, "all 60 ms late", Notices::both, Fault::command_stale, 20, 3.25, 0.3, 0.001, 120,
         line({.delay_s = 0.06})},
        {kForged, "one in ten damaged", Notices::nobody, Fault::none, 0, 3.4, 0.35, 0.005, 0,
         line({.corrupt = 0.1})},
        {kForged, "commands of 9 N with another key", Notices::nobody, Fault::none, 0, 3.4, 0.3,
         0.005, 0, stranger(99, 1000)},
        {"a stranger wants the arm", "commands of 9 N by another program", Notices::nobody,
         Fault::none, 0, 3.4, 0.3, 0.005, 0, stranger(7, 4242)},
        {"the clutch is held or let go (`haptics/device/fitted`)", "the clutch is held",
         Notices::arm, Fault::clutched, 1, 3.2, 0.05, 0.001, 101, spoil([](DeviceReading& r) {
             r.faults |= Fault::clutched;
             return true;
         })},
        {"the way becomes longer for good", "the way 30 ms longer", Notices::both,
         Fault::command_stale, 20, 3.25, 0.3, 0.001, 120, line({.delay_s = 0.03})},
    };
}

/// Faults of the program, its computer, its lesson, and what a person does.
[[nodiscard]] inline std::vector<FaultKind> program_faults() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const char* const kLesson = "the lesson hangs, fails, asks for nonsense";
    const char* const kBusy = "all processors are busy";
    const char* const kStop =
        "somebody presses stop: Escape, a button at the arm, `fulcrum stop`, another window";
    using namespace faults;
    return {
        {"the program is killed or hangs", "the program is killed", Notices::arm,
         Fault::command_stale, 20, 3.25, 0.3, 0.001, 120,
         [](FaultBench& b) { b.program_runs = false; }},
        {"the program's computer sleeps, or the program is stopped (SIGSTOP)",
         "both sleep for ten seconds", Notices::program, Fault::device_stale, 1, 0.01, 3.3, 0.005,
         2, [](FaultBench& b) { b.pair.now_s += 10.0; }},
        {kLesson, "the lesson hangs", Notices::program, Fault::command_stale, 100, 3.25, 0.25,
         0.004, 200, [](FaultBench& b) { b.lesson_awake = false; }},
        {kLesson, "the lesson fails", Notices::program, Fault::lesson_failed, 1, 3.2, 0.05, 0.001,
         101, [](FaultBench& b) { b.channels->lesson_failed.store(true); }},
        {kLesson, "the lesson asks for no number", Notices::program, Fault::command_invalid, 1, 3.2,
         0.05, 0.001, 101,
         [nan](FaultBench& b) {
             b.command.linearised.stamp_s = b.pair.now_s;
             b.command.linearised.force_W.x() = nan;
         }},
        {kLesson, "a spring is nowhere", Notices::nobody, Fault::none, 0, 3.4, 0.3, 0.005, 0,
         [nan](FaultBench& b) { b.command.fields[0].anchor_W.x() = nan; }},
        {"the lesson asks for too much at once", "the lesson asks for 100 N", Notices::nobody,
         Fault::none, 0, 5.0, 4.6, 0.185, -1,
         [](FaultBench& b) { b.command.fields[0].anchor_W.x() = 5.0; }},
        {"the world stops", "the world stops", Notices::program, Fault::command_stale, 100, 3.25,
         0.25, 0.004, 200, [](FaultBench& b) { b.world_period_s = -1.0; }},
        {"the world is slow, 20 Hz", "the world at 20 Hz", Notices::nobody, Fault::none, 0, 3.4,
         0.3, 0.005, 0, [](FaultBench& b) { b.world_period_s = 0.05; }},
        {kBusy, "rounds 15 ms late, five a second", Notices::nobody, Fault::none, 0, 3.45, 0.35,
         0.005, 0, late_rounds(0.015)},
        {kBusy, "rounds 30 ms late, five a second", Notices::arm, Fault::command_stale, 20, 3.25,
         0.3, 0.001, 120, late_rounds(0.03)},
        {kStop, "stop at the arm", Notices::arm, Fault::emergency_stop, 1, 3.2, 0.05, 0.001, 101,
         [](FaultBench& b) { b.pair.server.stop(); }},
        {kStop, "stop in the window", Notices::program, Fault::emergency_stop, 1, 3.2, 0.05, 0.001,
         101, [](FaultBench& b) { b.channels->emergency_stop.press(); }},
        {"the hand is thrown, or is given too much", "the hand is pulled away at 6 m/s",
         Notices::arm, Fault::hand_too_fast, 110, 4.0, 0.15, 0.002, 210,
         [](FaultBench& b) {
             const double since_s = b.pair.now_s;
             const Vector3 from = FaultBench::aim(since_s);
             b.hand_at = [since_s, from](double now_s) {
                 return Vector3(from + Vector3(6.0 * (now_s - since_s), 0.0, 0.0));
             };
         }},
    };
}

/// All of them, in the order of the fault tree.
[[nodiscard]] inline std::vector<FaultKind> all_faults() {
    std::vector<FaultKind> all = arm_faults();
    for (auto&& more : {line_faults(), program_faults()}) {
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

}  // namespace fulcrum::test_link
