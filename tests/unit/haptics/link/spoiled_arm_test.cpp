#include "haptics/link/spoiled_arm.h"

#include "haptics/loop/haptic_loop.h"
#include "tests/support/bad_numbers.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

using namespace fulcrum;

namespace {

// What is asked of the hand in a round.
using Ask = void (*)(int tick, ForceCommand& command);

// Out and in every other second, so that a gate that waits is let in again.
bool is_on(int tick) {
    return tick % 2000 < 1600;
}

// Things break for so long, while the plan's fields pull as `ask` says; a stop is lifted after three seconds.
SpoiledCounts run_arm(HapticPlan plan, SpoiledArm& arm, Ask ask, double seconds) {
    const auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, arm, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    double stopped_s = -1.0;
    for (int tick = 1; tick <= static_cast<int>(seconds * 1000.0); ++tick) {
        const double now_s = 0.001 * tick;
        command.stamp_s = now_s;
        ask(tick, command);
        channels->command.publish(command);
        stopped_s = loop.state().gate != GatePhase::stopped ? -1.0
                    : stopped_s < 0.0                       ? now_s
                                                            : stopped_s;
        if (stopped_s >= 0.0 && now_s - stopped_s > 3.0) {
            channels->rearm.store(true);
        }
        loop.step(now_s);
    }
    return arm.counts();
}

// The arm's own limits are those of any arm, and it is told the run's. A spring holds the hand; `watched_N`: what is held against it, where
// it is not the plan's own limit.
SpoiledCounts run_spoiled(std::uint64_t seed, double seconds, double limit_N = 5.0,
                          double watched_N = 0.0, const SafetySettings& run = {}) {
    LatestValue<HandTarget> target;
    target.publish({.sees_thing = seed % 2 == 0});
    HapticPlan plan;
    plan.safety = run;
    plan.safety.max_force_N = limit_N;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 400.0}};
    SpoiledArm arm(seed, target);
    arm.keep_limits(plan.safety);
    SafetySettings watched = plan.safety;
    watched.max_force_N = watched_N > 0.0 ? watched_N : limit_N;
    arm.watch_limits(watched);
    const auto pull = [](int tick, ForceCommand& command) {
        command.fields[0].strength = is_on(tick) ? 1.0 : 0.0;
        command.fields[0].anchor_W = {0.01, 0.005, 0.0};
    };
    return run_arm(plan, arm, pull, seconds);
}

// The same with an arm of seven joints, which a torque turns as well.
SpoiledCounts run_wam(std::uint64_t seed, double seconds) {
    LatestValue<HandTarget> target;
    target.publish({});
    HapticPlan plan;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 200.0}};
    plan.lesson_force = true;
    SpoiledArm arm(seed, target, ArmServerSettings{}.safety, SpoiledModel::wam);
    arm.keep_limits(plan.safety);
    const auto pull = [](int tick, ForceCommand& command) {
        command.fields[0].strength = is_on(tick) ? 1.0 : 0.0;
        command.linearised.stamp_s = command.stamp_s;
        // More than may be felt.
        command.linearised.torque_W = Vector3(0.0, is_on(tick) ? 0.5 : 0.0, 0.0);
    };
    return run_arm(plan, arm, pull, seconds);
}

// What several seeds showed together.
struct SeenInAll {
    std::array<std::uint64_t, kSpoils> happened{};
    std::array<std::uint64_t, kSpoils> faded{};
    std::array<std::uint64_t, kHandDeeds> deeds{};
    std::uint64_t fades = 0;
    std::uint64_t turned_rounds = 0;
    double peak_Nm = 0.0;
};

// Each seed keeps every limit, and has every fade.
SeenInAll check_seeds(SpoiledCounts (*run)(std::uint64_t seed), std::uint64_t seeds) {
    SeenInAll all;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const SpoiledCounts counts = run(seed);
        INFO("seed " << seed << ": " << name_of(counts.broken) << ", during "
                     << name_of(counts.bad_in) << ", after " << counts.bad_since_s << " s");
        CHECK(counts.broken_limits == 0);
        CHECK(counts.missed_fades == 0);
        CHECK(counts.peak_N <= SafetySettings{}.max_force_N);
        CHECK(counts.peak_Nm <= SafetySettings{}.max_torque_Nm);
        CHECK(counts.felt_rounds > 3000);
        CHECK(counts.stamps_back == 0);
        all.fades += counts.fades;
        all.turned_rounds += counts.turned_rounds;
        all.peak_Nm = std::max(all.peak_Nm, counts.peak_Nm);
        for (std::size_t i = 0; i < kSpoils; ++i) {
            all.happened[i] += counts.happened[i];
            all.faded[i] += counts.faded[i];
        }
        for (std::size_t i = 0; i < kHandDeeds; ++i) {
            all.deeds[i] += counts.deeds[i];
        }
    }
    // Each kind has occurred, and those that must have found a force to fade.
    for (std::size_t i = 1; i < kSpoils; ++i) {
        INFO(name_of(static_cast<Spoil>(i)));
        CHECK(all.happened[i] >= 1);
        CHECK((all.faded[i] >= 1) == must_fade(static_cast<Spoil>(i)));
    }
    return all;
}

}  // namespace

TEST_CASE("spoiled arm: whatever breaks, of seven joints too, no limit is passed and all fade") {
    const SeenInAll all =
        check_seeds([](std::uint64_t seed) { return run_spoiled(seed, 60.0); }, 12);
    CHECK(all.fades >= 20);
    CHECK(std::accumulate(all.faded.begin(), all.faded.end(), std::uint64_t{0}) == all.fades);
    for (const std::uint64_t n : all.deeds) {
        CHECK(n >= 10);
    }
    const SeenInAll of_wam =
        check_seeds([](std::uint64_t seed) { return run_wam(seed, 60.0); }, 10);
    CHECK(of_wam.turned_rounds > 20000);
    CHECK(of_wam.peak_Nm > 0.29);
    CHECK(run_wam(3, 5.0).hash == run_wam(3, 5.0).hash);
}

TEST_CASE("spoiled arm: the run's own limit is watched, and after a loss its own slew holds") {
    const SpoiledCounts kept = run_spoiled(3, 40.0, 2.0);
    CHECK(kept.broken_limits == 0);
    CHECK(kept.peak_N > 1.9);
    CHECK(kept.peak_N <= 2.0);
    // Of a gate that let more through than it may.
    const SpoiledCounts passed = run_spoiled(3, 40.0, 2.0, 1.0);
    CHECK(passed.broken_limits > 100);
    CHECK(passed.broken == FeltLimit::force);
    CHECK(passed.bad_since_s > 0.0);
    constexpr double kLimit_N = 5.0;
    constexpr double kSlew_N_per_s = 100.0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        INFO("seed " << seed);
        const SpoiledCounts counts =
            run_spoiled(seed, 40.0, kLimit_N, kLimit_N, {.max_slew_N_per_s = kSlew_N_per_s});
        CHECK(counts.broken_limits == 0);
        CHECK(counts.felt_rounds > 2000);
    }
}

TEST_CASE("spoiled arm: limits are the least of run and arm") {
    LatestValue<HandTarget> target;
    SpoiledArm arm(1, target, {.max_force_N = 4.0, .max_torque_Nm = 0.2});
    SafetySettings run{.max_force_N = 3.0, .max_torque_Nm = 0.3};
    arm.keep_limits(run);
    const FeltLimits limits = arm.limits();
    CHECK(limits.force_N == 3.0);
    CHECK(limits.torque_Nm == 0.2);
    CHECK(limits.slew_N_per_s == 500.0);
    CHECK(limits.slew_Nm_per_s == Approx(500.0 * 0.2 / 4.0));  // the arm's; the run's is higher
    arm.keep_limits({.max_force_N = 3.0, .max_torque_Nm = 0.1, .max_slew_N_per_s = 200.0});
    CHECK(arm.limits().slew_N_per_s == 200.0);
    CHECK(arm.limits().slew_Nm_per_s == Approx(200.0 * 0.1 / 3.0));
    CHECK(arm.limits().transient_N == Approx(4.0 * 200.0 / 500.0));
}

TEST_CASE("spoiled arm: one seed, one run, to the bit; what breaks first is known from it alone") {
    const SpoiledCounts once = run_spoiled(5, 20.0);
    for (int again = 0; again < 3; ++again) {
        CHECK(run_spoiled(5, 20.0).hash == once.hash);
    }
    CHECK(run_spoiled(6, 20.0).hash != once.hash);
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const FirstSpoil first = SpoiledArm::first_of(seed);
        INFO("seed " << seed << ", " << name_of(first.kind));
        const auto kind = static_cast<std::size_t>(first.kind);
        CHECK(run_spoiled(seed, first.at_s - 0.002).happened[kind] == 0);
        CHECK(run_spoiled(seed, first.at_s + 0.002).happened[kind] == 1);
    }
}
