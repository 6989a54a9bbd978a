#include "haptics/math/split_mix.h"
#include "haptics/record/record_reader.h"
#include "runtime/app/replayed_input.h"
#include "runtime/app/replayed_stops.h"
#include "runtime/app/told_replay.h"
#include "runtime/evidence/replay_check.h"
#include "tests/unit/runtime/app/two_hands_run.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr int kRounds = 6000;

HapticPlan make_springs() {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 100.0}};
    return plan;
}

using Run = TwoHands;

// With this before each round.
void play(Run& run, PeriodicTask& task, const std::function<void(int)>& before = {}) {
    for (int k = 0; k < kRounds; ++k) {
        if (before) {
            before(k);
        }
        task.step(0.001 * k);
        run.drain();
    }
}

Record record_of(const Run& run, const ScriptedDevice& first, const ScriptedDevice& second) {
    RecordHeader header = make_header(first, {"spring"}, {"spring", "brake"});
    std::vector<RecordFact> own;
    list_traits(second.traits(), own);
    for (const RecordFact& fact : own) {
        header.facts.push_back({fact_prefix(1) + fact.name, fact.value});
    }
    RecordEncoder encoder(header);
    for (std::size_t k = 0; k < run.rounds[0].size(); ++k) {
        encoder.append(run.rounds[0][k]);
        encoder.append(1, run.rounds[1][k]);
    }
    encoder.finish();
    return value_of(read_record(encoder.take_bytes()));
}

constexpr int kToldRounds = 8000;

HapticPlan make_plan() {
    HapticPlan plan;
    plan.carries_weight = true;
    plan.expects_world = true;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 100.0}};
    return plan;
}

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
    for (int k = 0; k < kToldRounds; ++k) {
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

TEST_CASE("replayed input: each key, notch and word comes once, in the frame of its time") {
    Record record;
    record.events = {{0.1, RecordEventKind::pressed, kNoBody, "left"},
                     {0.1, RecordEventKind::wheel, kNoBody, "-1.5"},
                     {0.1, RecordEventKind::gate, kNoBody, "open"},
                     {0.1, RecordEventKind::wheel, kNoBody, "0.25"},
                     {0.2, RecordEventKind::answered, kNoBody, "An egg."},
                     {0.2, RecordEventKind::answered, kNoBody, "An apple."},
                     {0.2, RecordEventKind::pressed, kNoBody, "space"}};
    ReplayedInput replayed(std::make_shared<const Record>(record));
    SessionInput input;
    input.clock_s = 0.05;
    replayed.add_to(input);
    CHECK((input.keys.empty() && !input.heard && input.wheel == 0.0));
    input.clock_s = 0.1;
    replayed.add_to(input);
    CHECK(input.keys == std::vector<std::string>{"left"});
    CHECK(input.wheel == -1.25);
    SessionInput next;
    next.clock_s = 0.3;
    replayed.add_to(next);
    CHECK(next.heard == "An egg.");
    CHECK(next.keys.empty());
    // One answer a frame; and what somebody says now goes before.
    SessionInput busy;
    busy.clock_s = 0.35;
    busy.heard = "I say.";
    replayed.add_to(busy);
    CHECK(busy.heard == "I say.");
    SessionInput last;
    last.clock_s = 0.4;
    replayed.add_to(last);
    CHECK(last.heard == "An apple.");
    CHECK(last.keys == std::vector<std::string>{"space"});
    SessionInput after;
    after.clock_s = 9.0;
    replayed.add_to(after);
    CHECK((after.keys.empty() && !after.heard));
}

TEST_CASE("replayed stops: stops, lifts and leaving of two hands are repeated to the bit") {
    ScriptedDevice first;
    ScriptedDevice second;
    second.traits_.max_force_N = 2.5;
    auto run = std::make_unique<Run>(make_springs(), first, second);
    play(*run, run->hands, [&](int k) {
        // Calm from time to time, so that the gates open again.
        const double swing_m = 0.02 * std::max(std::sin(0.003 * k), 0.0);
        first.pose_D.position = {swing_m, 0.001 * std::sin(0.1 * k), 0.0};
        second.pose_D.position = {0.0, -swing_m, 0.0};
        if (k == 600) {
            run->channels[0].emergency_stop.press();  // a key, held
        }
        if (k == 900) {
            run->channels[0].emergency_stop.release();
            run->channels[0].rearm.store(true);
        }
        if (k == 2000) {
            run->channels[1].emergency_stop.press();  // at the second arm, held
        }
        if (k == 2100) {
            run->channels[1].emergency_stop.release();
            run->channels[0].rearm.store(true);
        }
        if (k == 3600) {
            run->channels[1].emergency_stop.tap();  // at the second arm
        }
        if (k == 3650) {
            run->channels[0].rearm.store(true);  // while it fades
        }
        if (k == 5200) {
            run->channels[0].ended.store(true);
        }
    });
    const Record record = record_of(*run, first, second);
    REQUIRE(record.samples.size() == kRounds);
    REQUIRE(record.more_hands[0].samples.size() == kRounds);
    // All of it has happened.
    int n_stopped = 0;
    double most_N = 0.0;
    for (const RecordSample& sample : record.more_hands[0].samples) {
        n_stopped += sample.gate == GatePhase::stopped ? 1 : 0;
        most_N = std::max(most_N, sample.applied_W.force.norm());
    }
    CHECK(n_stopped > 300);
    CHECK(most_N > 1.0);
    CHECK(any(record.samples.back().faults & Fault::ended));

    const auto alone = std::make_shared<const Record>(*find_hand(record, 1));
    const auto whole = std::make_shared<const Record>(record);
    ReplayDevice first_again(*whole);
    ReplayDevice second_again(*alone);
    CHECK(second_again.traits().max_force_N == 2.5);
    auto again = std::make_unique<Run>(make_springs(), first_again, second_again);
    ReplayedStops stops({{whole, &again->channels[0]}, {alone, &again->channels[1]}}, again->hands);
    play(*again, stops);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& was = i == 0 ? record.samples : record.more_hands[0].samples;
        for (std::size_t k = 0; k < kRounds; ++k) {
            CAPTURE(i, k);
            REQUIRE(same(was[k], again->rounds[i][k].sample));
        }
    }
    // And without them it is another run.
    ReplayDevice bare_first(*whole);
    ReplayDevice bare_second(*alone);
    auto bare = std::make_unique<Run>(make_springs(), bare_first, bare_second);
    play(*bare, bare->hands);
    CHECK_FALSE(same(record.samples[700], bare->rounds[0][700].sample));
}

TEST_CASE("replayed stops: a record without a round stops nobody") {
    ScriptedDevice first;
    ScriptedDevice second;
    auto run = std::make_unique<Run>(make_springs(), first, second);
    ReplayedStops stops({{std::make_shared<const Record>(), &run->channels[0]}}, run->hands);
    play(*run, stops);
    CHECK(run->rounds[0].size() == kRounds);
    CHECK_FALSE(any(run->rounds[0].back().sample.faults));
    stops.silence(7.0);
    CHECK(first.written_D.force.norm() == 0.0);
}

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
    CHECK(replay.n_rounds() == kToldRounds);
    for (int k = 0; k < kToldRounds; ++k) {
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
    for (int k = 0; k < kToldRounds; ++k) {
        replay.step(0.0);
        again->drain();
        n_other += same(whole->samples[static_cast<std::size_t>(k)], again->rounds[0].back().sample)
                       ? 0
                       : 1;
    }
    CHECK(n_other > 1000);
}
