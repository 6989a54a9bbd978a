// The whole way under a virtual clock: hand, haptic loop, world loop, recorder, and the record played again.
#include "haptics/device/replay/replay_device.h"
#include "haptics/device/simulated/simulated_hand.h"
#include "haptics/dynamics/world_loop.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/record_writer.h"

#include <catch2/catch.hpp>

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

}  // namespace

TEST_CASE("record and replay: the same run twice gives the same bytes, and the weight was felt") {
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
}

TEST_CASE("record and replay: the recorded hand played again gives the same run to the bit") {
    const std::vector<std::byte> first = play_simulated();
    ReplayDevice replay(read_record(first).value());
    CHECK(play(replay, nullptr) == first);
}
