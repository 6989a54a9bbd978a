#include "haptics/link/felt_judge.h"

#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <functional>
#include <random>
#include <vector>

using namespace fulcrum;

namespace {

constexpr double kRound_s = 0.001;

// What it says first of rounds of an open gate.
FeltLimit judge_open(const FeltLimits& limits, int n_rounds,
                     const std::function<void(int, Wrench& asked, Wrench& felt)>& play) {
    FeltJudge judge;
    for (int i = 0; i < n_rounds; ++i) {
        FeltRound round{.gate = GatePhase::open, .dt_s = kRound_s};
        play(i, round.asked, round.felt);
        if (const FeltLimit broken = judge.judge(limits, round); broken != FeltLimit::none) {
            return broken;
        }
    }
    return FeltLimit::none;
}

Vector3 along(double force_N) {
    return {0.0, force_N, 0.0};
}

}  // namespace

TEST_CASE("felt judge: finds no fault with the gate as it ships, whatever is asked of it") {
    SafetySettings settings;
    settings.soft_start_s = 0.1;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const double slew_N_per_s : {500.0, 150.0}) {
        settings.max_slew_N_per_s = slew_N_per_s;
        const FeltLimits limits = felt_limits(settings);
        SafetyGate gate(settings);
        FeltJudge judge;
        FeltRound round;
        int n_open = 0;
        int n_closed = 0;
        for (int i = 0; i < 200'000; ++i) {
            const int course = i / 500 % 5;
            if (course == 0) {
                round.asked = {};
            } else if (course < 4 && i % (course * course * course) == 0) {
                round.asked.force =
                    7.0 * Vector3(uniform(random), uniform(random), uniform(random));
                round.asked.torque =
                    0.3 * Vector3(uniform(random), uniform(random), uniform(random));
            }
            const Fault fault = i % 2500 == 2250 ? Fault::device_read : Fault::none;
            round.dt_s = i % 97 == 0 ? 0.004 : kRound_s;
            const GatePhase before = gate.phase();
            round.felt = gate.pass(round.asked, fault, round.dt_s);
            round.gate = gate.phase();
            n_open += round.gate == GatePhase::open ? 1 : 0;
            n_closed += before == GatePhase::open && round.gate == GatePhase::fading ? 1 : 0;
            INFO("round " << i);
            REQUIRE(judge.judge(limits, round) == FeltLimit::none);
        }
        CHECK(n_open > 100'000);
        CHECK(n_closed > 40);
    }
}

TEST_CASE("felt judge: each limit that is passed is found") {
    FeltLimits limits;
    limits.force_N = 3.0;
    limits.torque_Nm = 0.2;
    limits.slew_Nm_per_s = 25.0;
    limits.transient_N = 2.0;
    const auto find = [&](double asked_N, double felt_N, double felt_Nm) {
        return judge_open(limits, 1, [&](int, Wrench& asked, Wrench& felt) {
            asked.force = along(asked_N);
            felt = {along(felt_N), Vector3(felt_Nm, 0.0, 0.0)};
        });
    };
    CHECK(find(3.0, 2.5, 0.02) == FeltLimit::none);
    CHECK(find(0.0, 3.001, 0.0) == FeltLimit::force);
    CHECK(find(0.0, kNan, 0.0) == FeltLimit::force);
    CHECK(find(0.0, 0.0, 0.201) == FeltLimit::torque);
    CHECK(find(0.0, 0.0, kNan) == FeltLimit::torque);
    CHECK(find(0.0, 0.0, 0.026) == FeltLimit::torque_slew);
    CHECK(find(3.0, 2.51, 0.0) == FeltLimit::transient);
    CHECK(find(-3.0, 1.51, 0.0) == FeltLimit::transient);
    limits.transient_N = 1.0;
    CHECK(find(3.0, 2.51, 0.0) == FeltLimit::slew);
    // To both sides for longer than the square may last, and to one for longer than the impulse.
    limits.transient_N = 2.0;
    const auto buzz = [](double newtons) {
        return [newtons](int i, Wrench&, Wrench& felt) {
            felt.force = along(i % 2 == 0 ? newtons : -newtons);
        };
    };
    CHECK(judge_open(limits, 1000, buzz(0.4)) == FeltLimit::none);
    CHECK(judge_open(limits, 1000, buzz(0.5)) == FeltLimit::ringing);
    limits.transient_N2s = 1.0;
    const auto push = [](Wrench&, Wrench& felt) { felt.force = along(1.5); };
    CHECK(judge_open(limits, 14, [&](int, Wrench& a, Wrench& f) { push(a, f); }) ==
          FeltLimit::none);
    CHECK(judge_open(limits, 20, [&](int, Wrench& a, Wrench& f) { push(a, f); }) ==
          FeltLimit::impulse);
}

TEST_CASE(
    "felt judge: where a gate is not open nothing comes beyond the slew, and what was may end") {
    const FeltLimits limits;
    const auto find = [&](GatePhase phase, double before_N, double now_N) {
        FeltJudge judge;
        const Wrench before{along(before_N), Vector3::Zero()};
        (void)judge.judge(limits, {.asked = before, .felt = before, .gate = GatePhase::open});
        return judge.judge(limits, {.felt = {along(now_N), Vector3::Zero()}, .gate = phase});
    };
    for (const GatePhase phase : {GatePhase::waiting, GatePhase::rising, GatePhase::fading}) {
        CHECK(find(phase, 0.0, 0.5) == FeltLimit::none);
        CHECK(find(phase, 0.0, 0.501) == FeltLimit::slew);
        CHECK(find(phase, 3.0, 0.0) == FeltLimit::none);
        CHECK(find(phase, 3.0, -0.1) == FeltLimit::slew);
    }
}
