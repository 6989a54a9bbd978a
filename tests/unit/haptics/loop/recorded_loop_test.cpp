#include "haptics/device/replay/replay_device.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/record_reader.h"
#include "haptics/record/record_writer.h"
#include "tests/unit/haptics/loop/haptic_loop_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

using namespace fulcrum;

namespace {

constexpr int kRounds = 6000;
constexpr double kDt_s = 0.001;

HapticPlan make_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3(0.0, 0.3, 0.0), 20.0, 0.5}};
    plan.workspace.pose_WD.position = Vector3(0.0, 0.3, 0.0);
    plan.workspace.scale = 1.7;
    return plan;
}

// Plays six seconds of a small lesson with `device` and gives the bytes of its record.
std::vector<std::byte> play(Device& device, LatestValue<HandTarget>* target) {
    auto haptics = std::make_unique<HapticChannels>();
    auto channels = std::make_unique<WorldChannels>();
    auto ring = std::make_unique<RecordRing>();
    haptics->record = ring.get();
    HapticLoop loop(make_plan(), device, *haptics);
    WorldPlan world_plan;
    world_plan.bodies = {{0.3, 0.3, 0.04, 0.01}};
    world_plan.catcher.present = true;
    WorldLoop world(world_plan, {}, *channels, *haptics);
    RecordHeader header;
    header.lesson = "gravity";
    header.effects.assign(loop.effects().size(), "effect");
    RecordEncoder encoder(header);
    for (int k = 0; k < kRounds; ++k) {
        const double now_s = k * kDt_s;
        if (k % 16 == 0) {
            ForceCommand command;
            command.stamp_s = now_s;
            command.lesson_alive = true;
            command.fields[0].anchor_W = make_plan().fields[0].anchor_W;
            haptics->command.publish(command);
        }
        if (k == 2500) {
            channels->commands.push({WorldCommand::Kind::drop, 0, Vector3(0.02, 1.0, 0.0)});
            encoder.append(RecordEvent{now_s, RecordEventKind::dropped, 0, "apple"});
        }
        if (target != nullptr) {
            HandTarget wanted;
            wanted.pose_D.position = 0.01 * Vector3(std::sin(0.002 * k), std::sin(0.003 * k), 0.0);
            target->publish(wanted);
        }
        if (k % 2 == 0) {
            world.step(now_s);
        }
        loop.step(now_s);
        RecordRound round;
        while (ring->pop(round)) {
            encoder.append(round);
        }
        WorldEvent event;
        while (channels->events.pop(event)) {
            encoder.append(RecordEvent{event.time_s, RecordEventKind::caught, event.body, ""});
        }
    }
    encoder.finish();
    return encoder.take_bytes();
}

std::vector<std::byte> play_simulated() {
    LatestValue<HandTarget> target;
    SimulatedHand hand(SimulatedHandSettings{}, target);
    return play(hand, &target);
}

HapticPlan make_audible_plan() {
    HapticPlan plan;
    plan.coupling = CouplingSettings{.stiffness_N_per_m = 400.0, .damping_Ns_per_m = 2.0};
    plan.solids.push_back({7, nullptr, {}});
    plan.solids[0].surface.audible = true;
    return plan;
}

// A loop that may be listened to, and a hand that dips into the floor ten times a second, deepest a centimetre.
struct Rings {
    std::unique_ptr<RecordRing> record = std::make_unique<RecordRing>();
    std::unique_ptr<TouchRing> touches = std::make_unique<TouchRing>();
};
struct Listened : Rings, Bench {
    Listened(bool has_sound, bool has_recorder)
        : Bench(make_audible_plan(), {.proxy = std::make_unique<FloorProxy>(),
                                      .record = has_recorder ? record.get() : nullptr,
                                      .touches = has_sound ? touches.get() : nullptr}) {}
    void step() {
        device.pose_D.position = Vector3(0.01, 0.01 * std::cos(62.8 * (now_s + kDt_s)), 0.0);
        run(1);
    }
};

}  // namespace

// The whole way under a virtual clock: hand, haptic loop, world loop, recorder, and the record played again.

TEST_CASE("record and replay: a run repeated, or its hand replayed, is the same to the bit") {
    const std::vector<std::byte> first = play_simulated();
    CHECK(first == play_simulated());
    const Expected<Record> record = read_record(first);
    REQUIRE(record);
    REQUIRE(record->samples.size() == kRounds);
    REQUIRE(record->events.size() == 2);
    CHECK(record->events[1].kind == RecordEventKind::caught);
    const RecordSample& last = record->samples.back();
    CHECK(last.gate == GatePhase::open);
    CHECK(last.applied_W.force.y() < -2.0);
    // The force has moved the hand: it hangs f / k below where it wants to be.
    const double wanted_m = 0.01 * std::sin(0.003 * (kRounds - 1));
    CHECK(last.pose_D.position.y() < wanted_m - 0.005);
    ReplayDevice replay(read_record(first).value());
    CHECK(play(replay, nullptr) == first);
}

// Readers of the haptic loop that are too slow: sound, lesson, world and recorder read nothing for seconds. The loop waits for none of
// them and counts what was lost; what comes after they woke is whole. Only a record that is full fades the force, as every fault does.

TEST_CASE("slow readers: nobody listens for 15 s, each force is the same, and losses are counted") {
    constexpr std::uint64_t kRoundsAsleep = 15000;
    Listened slow(true, false);
    Listened alone(false, false);
    std::uint64_t n_pressed = 0;
    for (std::uint64_t i = 0; i < kRoundsAsleep; ++i) {
        slow.step();
        alone.step();
        REQUIRE(slow.written_N() == alone.written_N());
        REQUIRE(slow.state().faults == Fault::none);
        n_pressed += slow.written_N().y() > 1.0 ? 1 : 0;
    }
    CHECK(n_pressed > kRoundsAsleep / 4);
    // The newest state is the newest.
    REQUIRE(slow.channels->state_for_lesson.take());
    CHECK(slow.channels->state_for_lesson.value().tick == kRoundsAsleep - 1);
    REQUIRE(slow.channels->state_for_world.take());
    CHECK(slow.channels->state_for_world.value().tick == kRoundsAsleep - 1);
    // Of the touches those that fitted were kept, the oldest, in order; from then on every one is kept again.
    const std::uint64_t n_lost = slow.touches->dropped();
    CHECK(n_lost > 0);
    TouchSample touch;
    double last_s = -1.0;
    std::size_t n_touches = 0;
    for (; slow.touches->pop(touch); ++n_touches) {
        REQUIRE(touch.time_s > last_s);
        last_s = touch.time_s;
    }
    CHECK(n_touches == kTouchRingCapacity);
    for (int i = 0; i < 200; ++i) {
        slow.step();
    }
    REQUIRE(slow.touches->pop(touch));
    CHECK(touch.time_s > last_s + 1.0);
    CHECK(slow.touches->dropped() == n_lost);
}

TEST_CASE("slow readers: a recorder that sleeps costs the force and no round; awake, all is back") {
    constexpr std::uint64_t kRoundsAsleep = 3 * kRecordRingCapacity;
    Listened slow(false, true);
    for (std::uint64_t i = 0; i < kRoundsAsleep; ++i) {
        slow.step();
        REQUIRE(slow.device.n_writes == static_cast<int>(i + 1));
        // Told from the round after the first that was lost.
        REQUIRE(slow.state().faults ==
                (i > kRecordRingCapacity ? Fault::record_full : Fault::none));
    }
    CHECK(slow.state().gate == GatePhase::waiting);
    CHECK(slow.written_N().norm() == 0.0);
    CHECK(slow.record->dropped() == kRoundsAsleep - kRecordRingCapacity);
    // It wakes: what was kept is the oldest, and nothing is missing in it.
    RecordRound round;
    for (std::uint64_t tick = 0; tick < kRecordRingCapacity; ++tick) {
        REQUIRE(slow.record->pop(round));
        REQUIRE(round.sample.tick == tick);
    }
    CHECK_FALSE(slow.record->pop(round));
    // From here on every round is kept again, and the force comes back.
    const std::uint64_t n_lost = slow.record->dropped();
    double most_N = 0.0;
    for (std::uint64_t i = 0; i < 6000; ++i) {
        slow.step();
        REQUIRE(slow.record->pop(round));
        REQUIRE(round.sample.tick == kRoundsAsleep + i);
        most_N = std::max(most_N, slow.written_N().y());
    }
    CHECK(most_N > 1.0);
    CHECK(slow.record->dropped() == n_lost);
}
