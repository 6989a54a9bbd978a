// Two hands on springs, recorded while they are stopped, lifted and left; then repeated from the record.
#include "runtime/app/replayed_stops.h"

#include "tests/unit/runtime/app/two_hands_run.h"

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

}  // namespace

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
