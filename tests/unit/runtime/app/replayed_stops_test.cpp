// Two hands on springs, recorded while they are stopped, lifted and left; then repeated from the record.
#include "runtime/app/replayed_stops.h"

#include "haptics/device/replay/recorded_traits.h"
#include "haptics/device/replay/replay_device.h"
#include "haptics/loop/hands_loop.h"
#include "haptics/record/record_writer.h"
#include "tests/support/scripted_device.h"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <functional>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr int kRounds = 6000;

HapticPlan make_springs() {
    HapticPlan plan;
    plan.expects_lesson = false;
    plan.fields = {FieldPlan{FieldKind::spring, Vector3::Zero(), 100.0}};
    return plan;
}

// Both loops in one round, what they do kept.
struct Run {
    Run(Device& first, Device& second)
        : loops{HapticLoop(make_springs(), first, channels[0]),
                HapticLoop(make_springs(), second, channels[1])},
          hands(std::array{HandInRound{&loops[0], &channels[0]},
                           HandInRound{&loops[1], &channels[1]}}) {
        for (std::size_t i = 0; i < 2; ++i) {
            channels[i].record = &rings[i];
        }
    }
    void play(PeriodicTask& task, const std::function<void(int)>& before = {}) {
        for (int k = 0; k < kRounds; ++k) {
            if (before) {
                before(k);
            }
            task.step(0.001 * k);
            for (std::size_t i = 0; i < 2; ++i) {
                for (RecordRound round; rings[i].pop(round);) {
                    rounds[i].push_back(round);
                }
            }
        }
    }
    std::array<HapticChannels, 2> channels;
    std::array<RecordRing, 2> rings;
    std::array<HapticLoop, 2> loops;
    HandsLoop hands;
    std::array<std::vector<RecordRound>, 2> rounds;
};

Record record_of(const Run& run, const ScriptedDevice& first, const ScriptedDevice& second) {
    RecordHeader header;
    header.lesson = "springs";
    header.effects = {"spring"};
    list_traits(first.traits(), header.facts);
    header.more_hands = {{5.0, 0.3, {"spring", "brake"}}};
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
    auto read = read_record(encoder.take_bytes());
    REQUIRE(read);
    return std::move(*read);
}

bool same(const RecordSample& a, const RecordSample& b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    bool same = a.tick == b.tick && a.faults == b.faults && a.gate == b.gate;
    for (int i = 0; i < 3; ++i) {
        same = same && bits(a.applied_W.force[i]) == bits(b.applied_W.force[i]) &&
               bits(a.commanded_W.force[i]) == bits(b.commanded_W.force[i]);
    }
    return same;
}

}  // namespace

TEST_CASE("replayed stops: stops, lifts and leaving of two hands are repeated to the bit") {
    ScriptedDevice first;
    ScriptedDevice second;
    second.traits_.max_force_N = 2.5;
    auto run = std::make_unique<Run>(first, second);
    run->play(run->hands, [&](int k) {
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
    auto again = std::make_unique<Run>(first_again, second_again);
    ReplayedStops stops({{whole, &again->channels[0]}, {alone, &again->channels[1]}}, again->hands);
    again->play(stops);
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
    auto bare = std::make_unique<Run>(bare_first, bare_second);
    bare->play(bare->hands);
    CHECK_FALSE(same(record.samples[700], bare->rounds[0][700].sample));
}

TEST_CASE("replayed stops: a record without a round stops nobody") {
    ScriptedDevice first;
    ScriptedDevice second;
    auto run = std::make_unique<Run>(first, second);
    ReplayedStops stops({{std::make_shared<const Record>(), &run->channels[0]}}, run->hands);
    run->play(stops);
    CHECK(run->rounds[0].size() == kRounds);
    CHECK_FALSE(any(run->rounds[0].back().sample.faults));
    stops.silence(7.0);
    CHECK(first.written_D.force.norm() == 0.0);
}
