// Two hands whose world, lesson and devices keep no time at all, recorded, and repeated from the record alone.
#include "runtime/app/told_replay.h"

#include "haptics/math/split_mix.h"
#include "runtime/evidence/replay_check.h"
#include "tests/unit/runtime/app/two_hands_run.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr int kRounds = 8000;

HapticPlan make_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 100.0}};
    return plan;
}

using Run = TwoHands;

// What goes wrong with a device, when.
void spoil(int k, ScriptedDevice& device) {
    device.gives_pose = k < 3000 || k >= 3004;
    device.takes_wrench = k != 4300;
    device.age_s = k >= 4400 && k < 4450 ? 0.05 : 0.0003;
    if (k == 5000) {
        device.pose_D.position.y() = std::numeric_limits<double>::quiet_NaN();
    }
}

// A run in which nobody is in step with anybody: rounds come late, world and lesson whenever they like.
Record record_run(std::uint64_t* faults_seen) {
    ScriptedDevice first;
    ScriptedDevice second;
    auto run = std::make_unique<Run>(make_plan(), first, second);
    run->keep_told();
    SplitMix chance(7);
    RecordHeader header =
        make_header(first, {"weight", "spring", "brake"}, {"weight", "spring", "brake"});
    header.facts.push_back({kClockFact, kRealTime});
    RecordEncoder encoder(header);
    double now_s = 0.0;
    double lesson_s = 0.0;
    double world_s = 0.0;
    for (int k = 0; k < kRounds; ++k) {
        now_s += 0.001 + (chance.draw_chance() < 0.1 ? 0.002 * chance.draw_chance() : 0.0);
        const double swing_m = 0.02 * std::max(std::sin(0.003 * k), 0.0);
        first.pose_D.position = {swing_m, 0.001 * std::sin(0.1 * k), 0.0};
        second.pose_D.position = {0.0, -swing_m, 0.0};
        spoil(k, first);
        if (now_s >= lesson_s && (k < 6000 || k > 6200)) {
            lesson_s = now_s + 0.016 + 0.01 * chance.draw_chance();
            ForceCommand command;
            command.stamp_s = now_s - 0.004 * chance.draw_chance();
            command.lesson_alive = k < 6500 || k > 6520;
            command.fields[0].strength = 0.5 + 0.5 * chance.draw_chance();
            run->channels[0].command.publish(command);
            run->channels[1].command.publish(command);
        }
        if (now_s >= world_s) {
            world_s = now_s + 0.004 * chance.draw_chance();
            WorldFrame frame;
            frame.stamp_s = now_s;
            frame.carried_force_W = Vector3(0.0, -2.0 * std::max(std::sin(0.002 * k), 0.0), 0.0);
            run->channels[0].world.publish(frame);
            run->channels[1].world.publish(frame);
        }
        if (k == 1500) {
            run->channels[1].emergency_stop.press();
        }
        if (k == 1600) {
            run->channels[1].emergency_stop.release();
            run->channels[0].rearm.store(true);
        }
        run->channels[0].lesson_failed.store(k >= 7000 && k < 7010);
        if (k == 7800) {
            run->channels[0].ended.store(true);
        }
        run->hands.step(now_s);
        run->drain();
        for (std::size_t i = 0; i < 2; ++i) {
            encoder.append(i, run->rounds[i].back());
            run->told[i]->drain([&](const auto& told) { encoder.append(i, told); });
            *faults_seen |= static_cast<std::uint64_t>(run->rounds[i].back().sample.faults);
        }
    }
    encoder.finish();
    return value_of(read_record(encoder.take_bytes()));
}

}  // namespace

TEST_CASE("told replay: a run that kept its own time repeats to the bit from its record alone") {
    std::uint64_t faults_seen = 0;
    const auto whole = std::make_shared<const Record>(record_run(&faults_seen));
    const auto alone = std::make_shared<const Record>(*find_hand(*whole, 1));
    CHECK(tells_all(*whole));
    // All of it has happened.
    for (const Fault fault : {Fault::device_read, Fault::device_stale, Fault::device_invalid,
                              Fault::command_stale, Fault::emergency_stop, Fault::other_stopped,
                              Fault::lesson_failed, Fault::device_write, Fault::ended}) {
        CAPTURE(static_cast<std::uint32_t>(fault));
        CHECK((faults_seen & static_cast<std::uint64_t>(fault)) != 0);
    }
    double most_N = 0.0;
    for (const RecordSample& sample : whole->samples) {
        most_N = std::max(most_N, sample.applied_W.force.norm());
    }
    CHECK(most_N > 1.0);

    ReplayDevice first(*whole);
    ReplayDevice second(*alone);
    auto again = std::make_unique<Run>(make_plan(), first, second);
    std::array<HapticChannels, 2> heard;
    ToldReplay replay({{whole, &again->loops[0], &again->channels[0], &heard[0]},
                       {alone, &again->loops[1], &again->channels[1], &heard[1]}});
    CHECK(replay.n_rounds() == kRounds);
    for (int k = 0; k < kRounds; ++k) {
        replay.step(0.5 * k);  // whatever the clock says
        again->drain();
        for (std::size_t i = 0; i < 2; ++i) {
            CAPTURE(i, k);
            REQUIRE(same((i == 0 ? *whole : *alone).samples[static_cast<std::size_t>(k)],
                         again->rounds[i].back().sample));
            REQUIRE(heard[i].state_for_lesson.take());
            REQUIRE(heard[i].state_for_lesson.value().tick == static_cast<std::uint64_t>(k));
        }
    }
    // Behind its end rounds go on a period apart.
    replay.step(0.0);
    again->drain();
    CHECK(again->rounds[0].back().sample.time_s == Approx(whole->samples.back().time_s + 0.001));
    replay.silence(9.0);
}

TEST_CASE("told replay: without what was told it is another run") {
    std::uint64_t faults_seen = 0;
    Record untold = record_run(&faults_seen);
    untold.told.clear();
    const auto whole = std::make_shared<const Record>(untold);
    const auto alone = std::make_shared<const Record>(*find_hand(untold, 1));
    ReplayDevice first(*whole);
    ReplayDevice second(*alone);
    auto again = std::make_unique<Run>(make_plan(), first, second);
    std::array<HapticChannels, 2> heard;
    ToldReplay replay({{whole, &again->loops[0], &again->channels[0], &heard[0]},
                       {alone, &again->loops[1], &again->channels[1], &heard[1]}});
    int n_other = 0;
    for (int k = 0; k < kRounds; ++k) {
        replay.step(0.0);
        again->drain();
        n_other += same(whole->samples[static_cast<std::size_t>(k)], again->rounds[0].back().sample)
                       ? 0
                       : 1;
    }
    CHECK(n_other > 1000);
}
