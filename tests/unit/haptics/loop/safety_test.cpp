#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/loop/safety_fixture.h"

#include <catch2/catch.hpp>

#include <bit>
#include <cstdint>
#include <random>

using namespace fulcrum;

namespace {

double any_bits(std::mt19937_64& random) {
    return std::bit_cast<double>(random());
}

// Random bits hold few special values; this mixes them in, and sane ones that open the gate.
double any_value(std::mt19937_64& random) {
    constexpr double kSpecial[] = {0.0,   -0.0,    1e-310, 5e-324, 1e308,     -1e308,     9.99, 1e6,
                                   1e154, 1.3e154, 0.001,  -10.0,  kInfinity, -kInfinity, kNan};
    switch (random() % 4) {
        case 0:
            return any_bits(random);
        case 1:
            return kSpecial[random() % std::size(kSpecial)];
        default:
            return static_cast<double>(random() % 2000) * 0.01 - 10.0;
    }
}

Vector3 any_vector(std::mt19937_64& random) {
    return {any_value(random), any_value(random), any_value(random)};
}

}  // namespace

TEST_CASE("safety: ten million random bit patterns never pass the cap") {
    std::mt19937_64 random(20240607);
    constexpr int kCalls = 10'000'000;
    SafetyGate gate{SafetySettings{}};
    double largest_N = 0.0;
    double largest_Nm = 0.0;
    std::int64_t bad = 0;
    std::int64_t moving = 0;
    Wrench commanded{};
    for (int i = 0; i < kCalls; ++i) {
        // Now and then a gate with settings of random bits; calm stretches let it engage and rise.
        if (i % 5000 == 0) {
            SafetySettings settings;
            if (i % 10000 == 0) {
                settings = {any_value(random), any_value(random),          any_value(random),
                            any_value(random), static_cast<int>(random()), any_value(random),
                            any_value(random), any_value(random)};
            } else {
                settings.max_force_N = 10.0;
                settings.max_torque_Nm = 1.0;
                settings.soft_start_N_per_s = 50.0;
            }
            gate = SafetyGate(settings);
        }
        const bool calm = i % 5000 < 10;
        const bool wild = i % 5000 > 4000 && random() % 8 == 0;
        double dt_s = 0.001;
        Fault faults = Fault::none;
        if (calm) {
            commanded = Wrench{};
        } else if (wild) {
            commanded = {any_vector(random), any_vector(random)};
            dt_s = any_value(random);
            faults = static_cast<Fault>(random() % 3 == 0 ? random() : 0);
        } else if (i % 64 == 0) {
            commanded = {Vector3(1e3, -1e2, 5.0) * (static_cast<double>(random() % 100) * 0.01),
                         Vector3(0.5, 3.0, -9.0)};
            if (random() % 200 == 0) {
                gate.reset();
            }
        }
        const Wrench out = gate.pass(commanded, faults, dt_s);
        const double force_N = out.force.norm();
        const double torque_Nm = out.torque.norm();
        bad += !(force_N <= kHardForceCap_N && force_N <= gate.max_force_N() &&
                 torque_Nm <= kHardTorqueCap_Nm);
        moving += force_N > 0.0;
        largest_N = std::max(largest_N, force_N);
        largest_Nm = std::max(largest_Nm, torque_Nm);
    }
    CHECK(bad == 0);
    // The run was no idle one: forces came through, up to the caps.
    CHECK(moving > kCalls / 20);
    CHECK(largest_N > 0.999 * kHardForceCap_N);
    CHECK(largest_Nm > 0.999 * kHardTorqueCap_Nm);
}

TEST_CASE("safety: a gate fed with random bits alone, and settings of random bits, stays capped") {
    std::mt19937_64 random(7);
    std::int64_t bad = 0;
    for (int i = 0; i < 100'000; ++i) {
        SafetyGate gate{SafetySettings{any_bits(random), any_bits(random), any_bits(random),
                                       any_bits(random), static_cast<int>(random()),
                                       any_bits(random), any_bits(random), any_bits(random)}};
        CHECK_FALSE(gate.max_force_N() > kHardForceCap_N);
        for (int k = 0; k < 10; ++k) {
            const Wrench out =
                gate.pass({Vector3(any_bits(random), any_bits(random), any_bits(random)),
                           Vector3(any_bits(random), any_bits(random), any_bits(random))},
                          Fault::none, any_bits(random));
            bad += !(out.force.norm() <= kHardForceCap_N && out.torque.norm() <= kHardTorqueCap_Nm);
        }
    }
    CHECK(bad == 0);
}

TEST_CASE("safety: no force before five calm cycles, then 5 N/s in closed form, then open") {
    SafetyGate gate{SafetySettings{}};
    // Started inside a body: 3 N are asked for and never given.
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(pass(gate, along_x(3.0)).force.norm() == 0.0);
    }
    CHECK(gate.phase() == GatePhase::waiting);
    // Four calm cycles are not enough, and one loud cycle starts the count again.
    pass(gate, along_x(0.19), 4);
    pass(gate, along_x(0.2));
    for (int i = 0; i < 4; ++i) {
        pass(gate, along_x(0.0));
        REQUIRE(gate.phase() == GatePhase::waiting);
    }
    CHECK(pass(gate, along_x(0.0)).force.norm() == 0.0);
    CHECK(gate.phase() == GatePhase::rising);
    // Then |f| = 5 t up to the commanded 4.5 N.
    for (int i = 1; i <= 2000; ++i) {
        const double expected_N = std::min(5.0 * i * kDt_s, 4.5);
        const Wrench out = pass(gate, along_x(4.5));
        REQUIRE(out.force.x() == Approx(expected_N).margin(kRounding));
        REQUIRE(out.force.tail<2>().norm() == 0.0);
    }
    pass(gate, along_x(4.5));
    CHECK(gate.phase() == GatePhase::open);
}

TEST_CASE(
    "safety: without transients the slew law in closed form, through zero, and no long jump") {
    SafetySettings settings;
    settings.max_transient_N = 0.0;
    SafetyGate gate = open_gate(settings, 0.0);
    for (int i = 1; i <= 20; ++i) {
        const double expected_N = std::min(500.0 * i * kDt_s, 5.0);
        REQUIRE(pass(gate, along_x(5.0)).force.x() == Approx(expected_N).margin(kRounding));
    }
    for (int i = 1; i <= 30; ++i) {
        const double expected_N = std::max(5.0 - 500.0 * i * kDt_s, -5.0);
        REQUIRE(pass(gate, along_x(-5.0)).force.x() == Approx(expected_N).margin(kRounding));
    }
    gate = open_gate(settings, 0.0);
    CHECK(gate.pass(along_x(5.0), Fault::none, 3.0).force.x() == Approx(500.0 * kLongestStep_s));
    SafetySettings slow = settings;
    slow.max_slew_N_per_s = 10.0;
    SafetyGate slow_gate = open_gate(slow, 0.0);
    CHECK(slow_gate.pass(along_x(5.0), Fault::none, 3.0).force.x() ==
          Approx(10.0 * kLongestStep_s));
}

TEST_CASE("safety: limits scale the vector and keep its direction") {
    SafetyGate gate = open_gate(SafetySettings{}, 0.0);
    const Wrench asked{Vector3(30.0, -40.0, 12.0), Vector3(0.0, 2.0, -1.5)};
    Wrench out = pass(gate, asked, 1000);
    CHECK(out.force.norm() == Approx(5.0));
    CHECK(out.force.normalized().dot(asked.force.normalized()) == Approx(1.0));
    CHECK(out.torque.norm() == Approx(0.3));
    CHECK(out.torque.normalized().dot(asked.torque.normalized()) == Approx(1.0));
    // Each component alone is within the limit here: clipping by component would have let it pass.
    const Vector3 small_components(4.0, 4.0, 4.0);
    out = pass(gate, {small_components, Vector3::Zero()}, 1000);
    CHECK(out.force.norm() == Approx(5.0));
}

TEST_CASE("safety: what the gate says that it may let through next bounds what it lets through") {
    SafetySettings settings;
    settings.max_torque_Nm = 0.3;
    SafetyGate gate{settings};
    CHECK(gate.find_most_N(kDt_s) == 0.0);
    CHECK(gate.find_most_Nm(kDt_s) == 0.0);
    double tightest = 0.0;
    double tightest_turn = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double dt_s = i % 7 == 0 ? 3.0 * kDt_s : kDt_s;
        const Fault fault = i == 3500 ? Fault::device_read : Fault::none;
        const double most_N = gate.find_most_N(dt_s);
        const double most_Nm = gate.find_most_Nm(dt_s);
        const double asked = i < 100 ? 0.0 : 50.0;
        const Wrench felt = gate.pass({Vector3(asked, 0, 0), Vector3(0, asked, 0)}, fault, dt_s);
        if (i > 0 && i < 3500) {
            REQUIRE(felt.force.norm() <= most_N);
            REQUIRE(felt.torque.norm() <= most_Nm * (1.0 + 1e-12));
            tightest = std::max(tightest, most_N > 0.0 ? felt.force.norm() / most_N : 0.0);
            tightest_turn =
                std::max(tightest_turn, most_Nm > 0.0 ? felt.torque.norm() / most_Nm : 0.0);
        }
        if (i > 3500) {
            REQUIRE(gate.find_most_N(dt_s) == 0.0);
            REQUIRE(gate.find_most_Nm(dt_s) == 0.0);
        }
    }
    CHECK(tightest == Approx(1.0));
    CHECK(tightest_turn == Approx(1.0));
    CHECK(gate.find_most_N(kNan) == 0.0);
}

TEST_CASE("safety: any fault fades in a straight line to zero, then engagement is needed again") {
    const Fault each[] = {Fault::device_read,   Fault::device_stale,    Fault::device_invalid,
                          Fault::command_stale, Fault::command_invalid, Fault::lesson_failed,
                          Fault::record_full,   Fault::device_write,    Fault::ended};
    for (const Fault fault : each) {
        const SafetySettings settings;
        SafetyGate gate = open_gate(settings, 4.0);
        for (int i = 1; i <= 99; ++i) {
            // The fault is over after one call; the fade goes on, whatever is commanded.
            const Fault now = i == 1 ? fault : Fault::none;
            const Wrench out = gate.pass(along_x(5.0), now, kDt_s);
            REQUIRE(out.force.x() ==
                    Approx(4.0 * (1.0 - i * kDt_s / settings.fade_s)).margin(kRounding));
            REQUIRE(gate.phase() == GatePhase::fading);
        }
        pass(gate, along_x(5.0));
        pass(gate, along_x(5.0));
        CHECK(gate.phase() == GatePhase::waiting);
        for (int i = 0; i < 1000; ++i) {
            REQUIRE(pass(gate, along_x(5.0)).force.norm() == 0.0);
        }
    }
}

TEST_CASE("safety: absurd commands and clocks that cannot be trusted fade, and none comes out") {
    const double bad[] = {kNan, kInfinity, 1e200, -1e7};
    for (const double value : bad) {
        SafetyGate gate = open_gate(SafetySettings{}, 4.0);
        const Wrench out =
            gate.pass({Vector3(0.0, value, 0.0), Vector3::Zero()}, Fault::none, kDt_s);
        CHECK(out.force.x() == Approx(4.0 * 0.99));
        CHECK(any(gate.faults() & Fault::command_invalid));
        CHECK(gate.phase() == GatePhase::fading);
        SafetyGate torque_gate = open_gate(SafetySettings{}, 4.0);
        (void)torque_gate.pass({Vector3::Zero(), Vector3(value, 0.0, 0.0)}, Fault::none, kDt_s);
        CHECK(torque_gate.phase() == GatePhase::fading);
    }
    for (const double dt_s : {kNan, -0.001, kInfinity}) {
        SafetyGate gate = open_gate(SafetySettings{}, 4.0);
        CHECK(gate.pass(along_x(4.0), Fault::none, dt_s).force.norm() == 0.0);
        CHECK(gate.phase() == GatePhase::waiting);
    }
    SafetyGate gate = open_gate(SafetySettings{}, 4.0);
    CHECK(gate.pass(along_x(0.0), Fault::none, 0.0).force.x() == 4.0);
}

TEST_CASE("safety: the emergency stop fades, latches, and ends by reset and new engagement") {
    SafetyGate gate = open_gate(SafetySettings{}, 4.0);
    CHECK(gate.pass(along_x(4.0), Fault::emergency_stop, kDt_s).force.x() == Approx(4.0 * 0.99));
    CHECK(gate.phase() == GatePhase::stopped);
    pass(gate, along_x(4.0), 100);
    for (int i = 0; i < 5000; ++i) {
        REQUIRE(pass(gate, along_x(0.0)).force.norm() == 0.0);
        REQUIRE(gate.phase() == GatePhase::stopped);
    }
    gate.reset();
    CHECK(gate.phase() == GatePhase::waiting);
    CHECK(pass(gate, along_x(4.0)).force.norm() == 0.0);
    // A stop in the middle of a fade goes on fading from there and latches too.
    SafetyGate fading = open_gate(SafetySettings{}, 4.0);
    pass(fading, along_x(4.0), 50, Fault::device_read);
    CHECK(fading.pass(along_x(4.0), Fault::emergency_stop, kDt_s).force.x() ==
          Approx(4.0 * (1.0 - 0.051 / 0.1)));
    CHECK(fading.phase() == GatePhase::stopped);
}

TEST_CASE("safety: the last check alone holds, whatever came before it") {
    const Wrench fine{Vector3(3.0, -4.0, 0.0), Vector3(0.0, 0.3, 0.0)};
    const Wrench kept = compute_last_check(fine, 5.0, 0.3);
    CHECK(kept.force == fine.force);
    CHECK(kept.torque == fine.torque);
    CHECK(compute_last_check(fine, 4.999, 0.3).force.norm() == 0.0);
    CHECK(compute_last_check(fine, 5.0, 0.299).force.norm() == 0.0);
    // Limits that are absurd or no numbers do not lift the hard caps.
    for (const double limit : {1e9, kInfinity, kNan}) {
        CHECK(compute_last_check(along_x(10.001), limit, limit).force.norm() == 0.0);
        CHECK(compute_last_check({Vector3::Zero(), Vector3(0.0, 0.0, 1.001)}, limit, limit)
                  .torque.norm() == 0.0);
    }
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e200}) {
        CHECK(compute_last_check(along_x(bad), 5.0, 0.3).force.norm() == 0.0);
        CHECK(
            compute_last_check({Vector3::Zero(), Vector3(0.0, bad, 0.0)}, 5.0, 0.3).torque.norm() ==
            0.0);
    }
    std::mt19937_64 random(11);
    std::int64_t n_bad = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const Wrench out = compute_last_check({any_vector(random), any_vector(random)},
                                              any_value(random), any_value(random));
        n_bad += !(out.force.norm() <= kHardForceCap_N && out.torque.norm() <= kHardTorqueCap_Nm);
    }
    CHECK(n_bad == 0);
}

TEST_CASE("safety: silenced in the middle of a stop's fade, nothing comes back") {
    SafetyGate gate{SafetySettings{}};
    pass(gate, along_x(0.1), 3000);
    REQUIRE(pass(gate, along_x(4.0), 1001).force.norm() > 3.9);
    pass(gate, along_x(4.0), 20, Fault::emergency_stop);
    CHECK(gate.is_fading());
    gate.silence();
    CHECK_FALSE(gate.is_fading());
    CHECK(gate.phase() == GatePhase::stopped);
    for (int i = 0; i < 200; ++i) {
        REQUIRE(pass(gate, along_x(4.0)).force.norm() == 0.0);
    }
}
