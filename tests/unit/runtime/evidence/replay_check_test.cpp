#include "runtime/evidence/replay_check.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr int kRounds = 100;

RecordRound make_round(int k) {
    RecordRound round;
    round.sample.tick = static_cast<std::uint64_t>(k);
    round.sample.time_s = 0.001 * k;
    round.shares.n = 2;
    round.shares.each_W[0].force = Vector3(0.1 * k, 0.0, 0.0);
    round.shares.each_W[1].force = Vector3(0.0, -1.0, 0.0);
    round.sample.commanded_W.force = Vector3(0.1 * k, -1.0, 0.0);
    round.sample.applied_W = round.sample.commanded_W;
    return round;
}

RecordHeader make_header() {
    RecordHeader header;
    header.effects = {"contact", "weight"};
    header.facts = {{"program.version", "0.1.0"}, {"program.build", "aa"},
                    {"lesson.lesson.lua", "11"},  {"asset.egg.glb", "22"},
                    {"option.seed", "1"},         {"option.hand", "simulated"},
                    {"limit.site N", "5"},        {"plan.weight of egg N", "0.5"}};
    return header;
}

std::shared_ptr<const Record> make_record() {
    Record record;
    record.header = make_header();
    for (int k = 0; k < kRounds; ++k) {
        const RecordRound round = make_round(k);
        record.samples.push_back(round.sample);
        record.shares_W.push_back(round.shares.each_W[0]);
        record.shares_W.push_back(round.shares.each_W[1]);
    }
    return std::make_shared<const Record>(std::move(record));
}

// A run in which every round from 40 on is spoiled.
ReplayCheck play(const std::function<void(RecordRound&)>& spoil,
                 RecordHeader header = make_header()) {
    ReplayCheck check(make_record(), std::move(header));
    for (int k = 0; k < kRounds; ++k) {
        RecordRound round = make_round(k);
        if (k >= 40) {
            spoil(round);
        }
        check.take(round);
    }
    return check;
}

std::string why(const char* name, const char* value) {
    RecordHeader now = make_header();
    for (RecordFact& fact : now.facts) {
        if (fact.name == name) {
            fact.value = value;
        }
    }
    return explain_difference(make_header(), now);
}

}  // namespace

TEST_CASE("replay check: the same rounds are the same; those beyond the record do not count") {
    ReplayCheck check = play([](RecordRound&) {});
    check.take(make_round(kRounds));
    CHECK(check.report().same());
    CHECK(check.report().n_compared == kRounds);
    CHECK(check.sentence() == "All forces are the record's, bit for bit, in 100 rounds.");
    ReplayCheck part(make_record(), make_header());
    CHECK(part.sentence().find("No round") == 0);
    CHECK_FALSE(part.report().same());
    part.take(make_round(0));
    CHECK(part.sentence() ==
          "In 1 of 100 rounds of the record the forces are the same, bit for bit; the others were "
          "not repeated.");
    Record damaged = *make_record();
    damaged.cut_off = true;
    damaged.fault = "the record is damaged";
    ReplayCheck of_damaged(std::make_shared<const Record>(damaged), make_header());
    for (int i = 0; i < kRounds; ++i) {
        of_damaged.take(make_round(i));
    }
    CHECK(of_damaged.sentence() ==
          "In 100 rounds of the record the forces are the same, bit for bit, but there is no more "
          "of it to be read: the record is damaged.");
}

TEST_CASE("replay check: one bit is enough, also of a zero's sign and of what is no number") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(play([](RecordRound& r) {
                    r.sample.applied_W.force.x() =
                        std::nextafter(r.sample.applied_W.force.x(), 1e9);
                })
                    .report()
                    .same());
    CHECK_FALSE(play([](RecordRound& r) { r.sample.applied_W.force.z() = -0.0; }).report().same());
    Record odd = *make_record();
    RecordRound round = make_round(0);
    odd.samples.resize(1);
    odd.shares_W.resize(2);
    odd.samples[0].commanded_W.force.x() = round.sample.commanded_W.force.x() = nan;
    ReplayCheck check(std::make_shared<const Record>(odd), make_header());
    check.take(round);
    CHECK(check.report().same());
}

TEST_CASE("replay check: what differs first in a round is named, with when and by how much") {
    const ReplayCheck weight = play([](RecordRound& r) {
        r.shares.each_W[1].force.y() = -1.5;
        r.sample.commanded_W.force.y() = -1.5;
        r.sample.applied_W.force.y() = -1.5;
    });
    CHECK(weight.report().first == Difference::effect);
    CHECK(weight.report().effect == "weight");
    CHECK(weight.report().tick == 40);
    CHECK(weight.report().n_different == 60);
    CHECK(weight.report().most_N == Approx(0.5));
    CHECK(
        weight.sentence().find("At 0.0400 s (round 40) the share of weight is the first thing that "
                               "differs from the record: 1.5 N down where it was 1 N down, 0.5 N "
                               "apart; the applied force differs in 60 of 100 rounds, by up to "
                               "0.5 N.") == 0);
    // An effect that is there and not yet felt is told all the same; so is a torque.
    const ReplayCheck unfelt = play([](RecordRound& r) { r.shares.each_W[0].torque.z() = 0.25; });
    CHECK(unfelt.report().effect == "contact");
    CHECK(unfelt.report().n_different == 0);
    check_says(unfelt.sentence(), {"0.25 Nm where it was 0 Nm"});
    CHECK(play([](RecordRound& r) { r.sample.commanded_W.force.x() += 1.0; }).report().first ==
          Difference::commanded);
    CHECK(play([](RecordRound& r) { r.sample.applied_W.torque.x() += 1.0; }).report().first ==
          Difference::applied);
    CHECK(play([](RecordRound& r) {
              r.sample.pose_D.position.x() += 1.0;
              r.shares.each_W[0].force.x() += 1.0;
          })
              .report()
              .first == Difference::hand);
    CHECK(play([](RecordRound& r) { r.sample.time_s += 1e-9; }).report().first == Difference::time);
    CHECK(play([](RecordRound& r) { r.sample.gate = GatePhase::fading; }).report().first ==
          Difference::state);
}

TEST_CASE("replay check: where effects are others, forces alone are compared") {
    RecordHeader header = make_header();
    header.effects = {"tool", "weight"};
    CHECK(
        play([](RecordRound& r) { r.shares.each_W[0].force.x() += 1.0; }, header).report().same());
}

TEST_CASE("replay check: the headers say why") {
    CHECK(explain_difference(make_header(), make_header()).empty());
    CHECK(why("program.version", "0.2.0") ==
          "the program is another one (version is 0.2.0 and was 0.1.0)");
    CHECK(why("program.build", "bb") == "the program was built anew since");
    CHECK(why("lesson.lesson.lua", "12") == "the lesson's files have changed (lesson.lua)");
    CHECK(why("asset.egg.glb", "23") == "models or pictures have changed (egg.glb)");
    CHECK(why("option.seed", "2") == "options differ (seed is 2 and was 1)");
    CHECK(why("option.hand", "replay").empty());
    CHECK(why("limit.site N", "3") == "limits differ (site N is 3 and was 5)");
    CHECK(why("plan.weight of egg N", "0.6") ==
          "the plan differs (weight of egg N is 0.6 and was 0.5)");
    RecordHeader now = make_header();
    for (RecordFact& fact : now.facts) {
        fact.value += "x";
    }
    // What follows from something else is not told beside it.
    check_lacks(explain_difference(make_header(), now), {"plan"});
    check_says(explain_difference(make_header(), now), {"; limits differ"});
    // Many of a kind are counted, and what stands in one of them alone is no difference.
    RecordHeader was;
    RecordHeader is;
    for (int i = 0; i < 6; ++i) {
        was.facts.push_back({"lesson." + std::to_string(i), "a"});
        is.facts.push_back({"lesson." + std::to_string(i), "b"});
    }
    was.facts.push_back({"lesson.gone", "a"});
    CHECK(explain_difference(was, is) == "the lesson's files have changed (0, 1, 2 and 3 more)");
    Record early;
    early.version = 3;
    early.samples = {make_round(1).sample};
    ReplayCheck old(std::make_shared<const Record>(std::move(early)), make_header());
    old.take(make_round(2));
    RecordRound other = make_round(1);
    other.sample.applied_W.force.x() += 1.0;
    old.take(other);
    check_says(old.sentence(), {"earlier version"});
}

namespace {

// Of a run in real time, in which `spoil` changed the record.
ReplayCheck play_real_time(const std::function<void(Record&)>& spoil,
                           const char* effect = "contact") {
    Record record = *make_record();
    record.header.effects[0] = effect;
    record.header.facts.push_back({kClockFact, kRealTime});
    RecordHeader now = record.header;
    now.facts.back().value = "virtual";
    spoil(record);
    ReplayCheck check(std::make_shared<const Record>(record), now);
    for (int k = 0; k < kRounds; ++k) {
        check.take(make_round(k));
    }
    return check;
}

void change_force(Record& record) {
    record.shares_W[20].force.x() += 0.5;
}

bool says(const ReplayCheck& check, const char* words) {
    INFO(check.sentence());
    return check.sentence().find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("replay check: of a run in real time it says what the record told, and what not") {
    const ReplayCheck same = play_real_time([](Record&) {});
    CHECK(same.report().same());
    CHECK(says(same, "what lesson and world said in each round was taken from the record."));
    // That it is repeated under a virtual clock explains nothing.
    CHECK(says(play_real_time(change_force), "are the record's."));
    const auto old = [](Record& record) {
        record.version = kFirstToldVersion - 1;
        change_force(record);
    };
    CHECK(says(play_real_time(old),
               "a record of version 7 does not tell what world and lesson said"));
    const auto lost = [](Record& record) {
        record.samples.erase(record.samples.begin() + 5, record.samples.begin() + 8);
        record.shares_W.erase(record.shares_W.begin() + 10, record.shares_W.begin() + 16);
        record.shares_W[20].force.x() += 0.5;
    };
    CHECK(says(play_real_time(lost), "The record lost 3 rounds"));
    const auto hurried = [](Record& record) {
        record.header.facts.push_back({kToolTimeFact, "500"});
        change_force(record);
    };
    CHECK(says(play_real_time(hurried, "tool"),
               "The tool had 500 us of each step then and ended its search by the clock"));
    CHECK_FALSE(says(play_real_time(hurried, "contact"), "The tool had"));
}

TEST_CASE("replay check: a record tells all where it is of a run in real time and new enough") {
    Record record = *make_record();
    CHECK_FALSE(tells_all(record));
    record.header.facts.push_back({kClockFact, kRealTime});
    CHECK(tells_all(record));
    record.version = kFirstToldVersion - 1;
    CHECK_FALSE(tells_all(record));
    record.version = kRecordVersion;
    record.header.facts.back().value = "virtual";
    CHECK_FALSE(tells_all(record));
}
