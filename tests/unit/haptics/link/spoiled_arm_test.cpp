#include "haptics/link/spoiled_arm.h"

#include "haptics/loop/haptic_loop.h"

#include <catch2/catch.hpp>

#include <memory>

using namespace fulcrum;

namespace {

// A spring holds the hand for so long while things break.
SpoiledCounts run_spoiled(std::uint64_t seed, double seconds) {
    LatestValue<HandTarget> target;
    target.publish({});
    SpoiledArm arm(seed, target);
    HapticPlan plan;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 400.0}};
    const auto channels = std::make_unique<HapticChannels>();
    HapticLoop loop(plan, arm, *channels);
    ForceCommand command;
    command.lesson_alive = true;
    double stopped_s = -1.0;
    for (int tick = 1; tick <= static_cast<int>(seconds * 1000.0); ++tick) {
        const double now_s = 0.001 * tick;
        // Out and in every other second, so that a gate that waits is let in again.
        command.stamp_s = now_s;
        command.fields[0].strength = tick % 2000 < 1600 ? 1.0 : 0.0;
        command.fields[0].anchor_W = {0.01, 0.005, 0.0};
        channels->command.publish(command);
        // Somebody lifts a stop when it is over.
        if (loop.state().gate == GatePhase::stopped && stopped_s < 0.0) {
            stopped_s = now_s;
        }
        if (stopped_s >= 0.0 && now_s - stopped_s > 3.0) {
            channels->rearm.store(true);
            stopped_s = -1.0;
        }
        loop.step(now_s);
    }
    return arm.counts();
}

}  // namespace

TEST_CASE("spoiled arm: whatever breaks, no limit is passed and every fade comes") {
    SpoiledCounts all;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const SpoiledCounts counts = run_spoiled(seed, 60.0);
        INFO("seed " << seed);
        CHECK(counts.broken_limits == 0);
        CHECK(counts.missed_fades == 0);
        CHECK(counts.peak_N <= 5.0);
        CHECK(counts.felt_rounds > 3000);
        all.fades += counts.fades;
        for (std::size_t i = 0; i < kSpoils; ++i) {
            all.happened[i] += counts.happened[i];
        }
    }
    // Each kind has occurred, and many found a force to fade.
    for (std::size_t i = 1; i < kSpoils; ++i) {
        INFO(name_of(static_cast<Spoil>(i)));
        CHECK(all.happened[i] >= 2);
    }
    CHECK(all.fades >= 20);
}

TEST_CASE("spoiled arm: one seed, one run, to the bit") {
    const SpoiledCounts once = run_spoiled(5, 20.0);
    for (int again = 0; again < 3; ++again) {
        CHECK(run_spoiled(5, 20.0).hash == once.hash);
    }
    CHECK(run_spoiled(6, 20.0).hash != once.hash);
}

TEST_CASE("spoiled arm: what breaks first is known from the seed alone") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        const FirstSpoil first = SpoiledArm::first_of(seed);
        INFO("seed " << seed << ", " << name_of(first.kind));
        const auto kind = static_cast<std::size_t>(first.kind);
        CHECK(run_spoiled(seed, first.at_s - 0.002).happened[kind] == 0);
        CHECK(run_spoiled(seed, first.at_s + 0.002).happened[kind] == 1);
    }
}
