#include "haptics/loop/safety.h"
#include "tests/support/bad_numbers.h"
#include "tests/support/refused.h"
#include "tests/unit/haptics/loop/safety_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace fulcrum;

namespace {

constexpr double kTorquePerForce_m = 0.06;

Wrench about_y(double torque_Nm) {
    return {Vector3::Zero(), Vector3(0, torque_Nm, 0)};
}

}  // namespace

// The gate's laws one by one: for torques, at its bounds, in time.

TEST_CASE("safety: a torque engages, rises, slews and fades by the force's laws times 0.06") {
    const SafetySettings settings;
    SafetyGate gate(settings);
    // Alone it keeps the gate waiting: 0.2 N times 0.06.
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(pass(gate, about_y(0.0121)).torque.norm() == 0.0);
        REQUIRE(gate.phase() == GatePhase::waiting);
    }
    for (int i = 0; i < 5; ++i) {
        CHECK(gate.phase() == GatePhase::waiting);
        pass(gate, about_y(i < 4 ? 0.0119 : 0.0));
    }
    REQUIRE(gate.phase() == GatePhase::rising);
    // 5 N/s times 0.06.
    for (int i = 1; i <= 2001; ++i) {
        const double expected_Nm = std::min(5.0 * kTorquePerForce_m * i * kDt_s, 0.27);
        REQUIRE(pass(gate, about_y(0.27)).torque.y() == Approx(expected_Nm).margin(kRounding));
    }
    REQUIRE(gate.phase() == GatePhase::open);
    // 500 N/s times 0.06, through zero.
    for (int i = 1; i <= 25; ++i) {
        const double expected_Nm = std::max(0.27 - 500.0 * kTorquePerForce_m * i * kDt_s, -0.27);
        REQUIRE(pass(gate, about_y(-0.27)).torque.y() == Approx(expected_Nm).margin(kRounding));
    }
    for (int i = 1; i <= 101; ++i) {
        const Wrench out =
            gate.pass(about_y(0.3), i == 1 ? Fault::device_read : Fault::none, kDt_s);
        REQUIRE(out.torque.y() ==
                Approx(-0.27 * std::max(1.0 - 10.0 * i * kDt_s, 0.0)).margin(kRounding));
        // A torque alone is still a fade.
        REQUIRE(gate.is_fading() == (out.torque.norm() > 0.0));
    }
    CHECK(gate.phase() == GatePhase::waiting);
}

TEST_CASE(
    "safety: what comes late in a soft start comes as softly, and the gate opens when it has") {
    const SafetySettings settings;
    const auto rise = [&](const Wrench& late) {
        SafetyGate gate(settings);
        pass(gate, Wrench{}, 5);
        pass(gate, Wrench{}, 1900);
        REQUIRE(gate.phase() == GatePhase::rising);
        int n = 0;
        for (Wrench before{}; gate.phase() == GatePhase::rising; ++n) {
            REQUIRE(n < 3000);
            const double most_N = gate.find_most_N(kDt_s);
            const Wrench now = pass(gate, late);
            CHECK(now.force.norm() <= most_N + kRounding);
            // Also in the call that opens it, but for what was left to come.
            const double left = gate.phase() == GatePhase::rising ? 0.0 : settings.engage_below_N;
            REQUIRE((now.force - before.force).norm() <= 0.005 + left + kRounding);
            REQUIRE((now.torque - before.torque).norm() <=
                    kTorquePerForce_m * (0.005 + left) + kRounding);
            before = now;
        }
        return n;
    };
    // 4.3 of 4.5 N at 5 N/s, and a torque alike; 0.1 N are there when the time is over.
    CHECK(rise(along_x(4.5)) == Approx(862).margin(3));
    CHECK(rise(about_y(0.27)) == Approx(862).margin(3));
    CHECK(rise(along_x(0.1)) == Approx(101).margin(3));
    // One that comes and goes is there whenever it goes.
    SafetyGate gate(settings);
    pass(gate, Wrench{}, 5);
    for (int i = 0; i < 2010; ++i) {
        pass(gate, along_x(i % 10 < 5 ? 4.0 : 0.0));
    }
    CHECK(gate.phase() == GatePhase::open);
}

TEST_CASE("safety: a device without torque engages whatever torque is commanded") {
    SafetySettings settings;
    settings.max_torque_Nm = 0.0;
    SafetyGate gate(settings);
    for (int i = 0; i < 5; ++i) {
        CHECK(pass(gate, about_y(0.2)).torque.norm() == 0.0);
    }
    CHECK(gate.phase() == GatePhase::rising);
}

TEST_CASE("safety: engagement counts what is commanded, and a fault starts the count again") {
    SafetySettings settings;
    settings.max_force_N = 0.5;
    settings.engage_below_N = 1.0;
    REQUIRE(validate(settings));
    SafetyGate gate(settings);
    pass(gate, along_x(100.0), 1000);
    CHECK(gate.phase() == GatePhase::waiting);
    gate = SafetyGate{SafetySettings{}};
    pass(gate, along_x(0.0), 4);
    (void)gate.pass(along_x(0.0), Fault::device_read, kDt_s);
    for (int i = 0; i < 4; ++i) {
        pass(gate, along_x(0.0));
        CHECK(gate.phase() == GatePhase::waiting);
    }
    pass(gate, along_x(0.0));
    CHECK(gate.phase() == GatePhase::rising);
}

TEST_CASE("safety: a force that is there from the start comes in softly at a hand that rests") {
    constexpr double kRests = 0.0499;
    const auto hold = [](SafetyGate& gate, double hand_m_per_s, int n, Fault fault = Fault::none) {
        Wrench out{};
        for (int i = 0; i < n; ++i) {
            out = gate.pass(along_x(5.0), fault, kDt_s, hand_m_per_s);
        }
        return out.force.x();
    };
    SafetyGate gate{SafetySettings{}};
    CHECK(hold(gate, kRests, 499) == 0.0);
    // The rest is one: a movement, a fault, a speed that nobody knows or that is no number begins it anew.
    for (const double moves : {0.051, std::nan(""), kInfinity}) {
        CHECK(hold(gate, moves, 1) == 0.0);
        CHECK(hold(gate, kRests, 499) == 0.0);
    }
    CHECK(hold(gate, kRests, 1, Fault::device_stale) == 0.0);
    CHECK(hold(gate, 0.0, 499) == 0.0);
    REQUIRE(gate.phase() == GatePhase::waiting);
    // Then as slowly as any soft start, whatever the hand does.
    double before_N = hold(gate, kRests, 2);
    REQUIRE(gate.phase() == GatePhase::rising);
    for (int i = 0; i < 990; ++i) {
        const double now_N = hold(gate, 1.0, 1);
        REQUIRE(now_N - before_N <= 0.005 + kRounding);
        before_N = now_N;
    }
    CHECK(before_N > 4.9);
    // After a fault not without another rest, and after a stop not before somebody lifts it.
    (void)hold(gate, kRests, 101, Fault::lesson_failed);
    REQUIRE(gate.phase() == GatePhase::waiting);
    CHECK(hold(gate, kRests, 498) == 0.0);
    CHECK(hold(gate, kRests, 4) > 0.0);
    (void)hold(gate, kRests, 2000, Fault::emergency_stop);
    CHECK(hold(gate, kRests, 3000) == 0.0);
    gate.reset();
    CHECK(hold(gate, kRests, 499) == 0.0);
    CHECK(hold(gate, kRests, 3) > 0.0);
    // What threw the hand must become small first.
    for (const Fault thrown : {Fault::hand_too_fast, Fault::too_much_energy}) {
        (void)hold(gate, kRests, 200, thrown);
        CHECK(hold(gate, kRests, 3000) == 0.0);
        pass(gate, along_x(0.0), 5);
        CHECK(hold(gate, kRests, 2) > 0.0);
    }
}

TEST_CASE(
    "safety: at a hand that rests a force comes softly to its end, whatever the soft start's "
    "time") {
    for (const auto& [rise_N_per_s, time_s] : {std::pair{0.5, 2.0}, {5.0, 0.0}, {2.0, 1.0}}) {
        SafetySettings settings;
        settings.soft_start_N_per_s = rise_N_per_s;
        settings.soft_start_s = time_s;
        REQUIRE(validate(settings));
        SafetyGate gate(settings);
        double before_N = 0.0;
        for (int i = 0; i < 12'000; ++i) {
            const double now_N = gate.pass(along_x(4.5), Fault::none, kDt_s, 0.0).force.x();
            REQUIRE(now_N - before_N <= rise_N_per_s * kDt_s + kRounding);
            before_N = now_N;
        }
        CHECK(before_N == Approx(4.5));
        CHECK(gate.phase() == GatePhase::open);
    }
    // With a speed of zero no rest opens it.
    SafetySettings never;
    never.rest_speed_m_per_s = 0.0;
    SafetyGate gate(never);
    for (int i = 0; i < 2000; ++i) {
        REQUIRE(gate.pass(along_x(4.5), Fault::none, kDt_s, 0.0).force.x() == 0.0);
    }
}

TEST_CASE("safety: the soft start lasts its time to the end, and a long pause is no part of it") {
    SafetyGate gate{SafetySettings{}};
    pass(gate, along_x(0.0), 5 + 1900);
    REQUIRE(gate.phase() == GatePhase::rising);
    // 1.9 s into it, and after three seconds in which nobody called.
    CHECK(pass(gate, along_x(9.0)).force.x() == Approx(0.005));
    CHECK(gate.pass(along_x(9.0), Fault::none, 3.0).force.x() == Approx(0.005 + 0.05));
    CHECK(gate.phase() == GatePhase::rising);
}

TEST_CASE("safety: a gate built with absurd settings obeys the strictest of each law") {
    SafetySettings absurd;
    absurd.max_force_N = 1e9;
    absurd.max_slew_N_per_s = 1e9;
    absurd.engage_below_N = 1e9;
    absurd.soft_start_N_per_s = 1e9;
    absurd.max_transient_N = 1e9;
    absurd.fade_s = 1e9;
    SafetyGate gate(absurd);
    // Engages below 1 N.
    pass(gate, along_x(1.01), 100);
    REQUIRE(gate.phase() == GatePhase::waiting);
    pass(gate, along_x(0.99), 4);
    pass(gate, along_x(0.0));
    REQUIRE(gate.phase() == GatePhase::rising);
    // Rises by 50 N/s, slews by 5000 N/s, and swings by 5 N beyond.
    CHECK(pass(gate, along_x(100.0)).force.x() == Approx(0.05));
    pass(gate, along_x(0.0), 2100);
    REQUIRE(gate.phase() == GatePhase::open);
    CHECK(pass(gate, along_x(100.0)).force.x() == Approx(10.0));
    pass(gate, along_x(100.0), 2);
    // Fades within half a second.
    CHECK(gate.pass(along_x(100.0), Fault::device_read, kDt_s).force.x() ==
          Approx(10.0 * (1.0 - kDt_s / 0.5)));
}

TEST_CASE("safety: a clock that stands still or creeps holds no force that should go") {
    for (const double dt_s : {0.0, 1e-12, 0.0009}) {
        for (const Fault fault : {Fault::emergency_stop, Fault::device_read}) {
            SafetyGate gate = open_gate(SafetySettings{}, 4.0);
            for (int i = 1; i <= 100; ++i) {
                REQUIRE(gate.pass(along_x(4.0), fault, dt_s).force.x() ==
                        Approx(4.0 * (1.0 - 0.01 * i)).margin(kRounding));
            }
            CHECK_FALSE(gate.is_fading());
        }
    }
    // A loop of 5 kHz has a shorter period.
    SafetyGate fast = open_gate(SafetySettings{}, 4.0, 0.0002);
    CHECK(fast.pass(along_x(4.0), Fault::device_read, 0.0).force.x() == Approx(4.0 * 0.998));
}

TEST_CASE("safety: what lies at a limit by rounding is given, not dropped, in every direction") {
    for (const double limit_N : {0.5, 5.0, 10.0}) {
        SafetySettings settings;
        settings.max_force_N = limit_N;
        SafetyGate gate = open_gate(settings, 0.0);
        double least_N = limit_N;
        double least_Nm = settings.max_torque_Nm;
        for (int i = 0; i < 20000; ++i) {
            // Slowly round, a few units of the last place about the limit's own length.
            const double angle = 1.0e-3 * i;
            const Vector3 along(std::cos(angle), std::sin(angle), 0.1 * std::sin(7.0 * angle));
            const double off = 1.0 + (i % 9 - 4) * 1.1e-16;
            const Vector3 way = along.normalized() * off;
            const Wrench out =
                gate.pass({limit_N * way, settings.max_torque_Nm * way}, Fault::none, kDt_s);
            REQUIRE(out.force.squaredNorm() <= limit_N * limit_N);
            REQUIRE(out.torque.squaredNorm() <= settings.max_torque_Nm * settings.max_torque_Nm);
            if (i > 3000) {
                least_N = std::min(least_N, out.force.norm());
                least_Nm = std::min(least_Nm, out.torque.norm());
            }
        }
        CHECK(least_N > 0.999 * limit_N);
        CHECK(least_Nm > 0.999 * settings.max_torque_Nm);
    }
}

TEST_CASE("safety: each setting is accepted at its bounds and refused just past them, by name") {
    struct Bound {
        double SafetySettings::*field;
        double low, high;
    };
    const Bound bounds[] = {{&SafetySettings::max_force_N, 0.5, 10.0},
                            {&SafetySettings::max_torque_Nm, 0.0, 1.0},
                            {&SafetySettings::max_slew_N_per_s, 10.0, 5000.0},
                            {&SafetySettings::engage_below_N, 0.01, 1.0},
                            {&SafetySettings::max_transient_N, 0.0, 5.0},
                            {&SafetySettings::transient_Ns, 0.001, 0.05},
                            {&SafetySettings::transient_N2s, 0.001, 0.5},
                            {&SafetySettings::rest_speed_m_per_s, 0.0, 0.2},
                            {&SafetySettings::rest_s, 0.2, 60.0},
                            {&SafetySettings::soft_start_N_per_s, 0.5, 50.0},
                            {&SafetySettings::soft_start_s, 0.0, 10.0},
                            {&SafetySettings::fade_s, 0.01, 0.5},
                            {&SafetySettings::command_timeout_s, 0.02, 1.0},
                            {&SafetySettings::device_timeout_s, 0.002, 0.1},
                            {&SafetySettings::max_hand_speed_m_per_s, 0.1, 100.0}};
    for (const Bound& bound : bounds) {
        const auto accepts = [&](double value) {
            SafetySettings settings;
            settings.*bound.field = value;
            return validate(settings).has_value();
        };
        CHECK(accepts(bound.low));
        CHECK(accepts(bound.high));
        CHECK_FALSE(accepts(bound.low - 1e-6));
        CHECK_FALSE(accepts(bound.high + 1e-6));
        for (const double bad : {kNan, -1.0, 1e9}) {
            CHECK_FALSE(accepts(bad));
        }
    }
    CHECK(validate(SafetySettings{}));
    SafetySettings strong;
    strong.max_force_N = 10.1;
    CHECK(is_refused(validate(strong), "max_force_N is 10.1"));
    CHECK(is_refused(validate(strong), "0.5 to 10"));
    for (const int cycles : {0, 1, 1000, 1001}) {
        SafetySettings settings;
        settings.engage_cycles = cycles;
        CHECK(validate(settings).has_value() == (cycles >= 1 && cycles <= 1000));
    }
}
