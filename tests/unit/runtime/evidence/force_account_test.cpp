#include "runtime/evidence/force_account.h"

#include "tests/unit/runtime/rig.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;

namespace {

constexpr double kRounding = 1e-12;
const std::vector<std::string> kNames = {"contact", "weight"};

Wrench push(double x, double y, double z = 0.0) {
    return {Vector3(x, y, z), Vector3::Zero()};
}

ForceAccount account(const Wrench& felt_W, GatePhase gate, Fault faults = Fault::none,
                     double most_N = 5.0) {
    const std::vector<Wrench> shares = {push(0.0, 8.0), push(0.0, -2.0)};
    return make_account(kNames, shares, push(0.0, 6.0), felt_W, gate, faults, {most_N, 0.3});
}

void check_sum(const ForceAccount& a) {
    const Vector3 sum_W = a.asked_W.force + a.limit_W.force + a.gate_W.force;
    CHECK((sum_W - a.felt_W.force).norm() < kRounding);
    double percent = 0.0;
    for (const ForcePart& part : a.effects) {
        percent += percent_of(part.wrench_W.force, a.felt_W.force);
    }
    percent += percent_of(a.limit_W.force, a.felt_W.force);
    percent += percent_of(a.gate_W.force, a.felt_W.force);
    CHECK(percent == Approx(a.felt_W.force.norm() > 0.0 ? 100.0 : 0.0));
}

Record make_record() {
    Record record;
    record.header.lesson = "gravity";
    record.header.rate_Hz = 1000.0;
    record.header.max_force_N = 5.0;
    record.header.max_torque_Nm = 0.3;
    record.header.effects = kNames;
    record.header.bodies = {"apple"};
    for (int k = 0; k < 10; ++k) {
        RecordSample sample;
        sample.tick = static_cast<std::uint64_t>(k);
        sample.time_s = 0.5 + 0.001 * k;
        sample.commanded_W = push(0.1 * k, -1.0);
        sample.applied_W = push(0.1 * k, -0.5);
        sample.gate = GatePhase::rising;
        sample.touched_body = k == 3 ? 0 : k == 4 ? 5 : kNoBody;
        record.samples.push_back(sample);
        record.shares_W.push_back(push(0.1 * k, 0.0));
        record.shares_W.push_back(push(0.0, -1.0));
    }
    return record;
}

}  // namespace

TEST_CASE("force account: the limit takes what is above it, in its direction; the gate the rest") {
    const ForceAccount open = account(push(0.0, 5.0), GatePhase::open);
    CHECK(open.limit_W.force.y() == Approx(-1.0));
    CHECK(open.gate_W.force.norm() < kRounding);
    check_sum(open);
    const ForceAccount rising = account(push(0.0, 2.0), GatePhase::rising);
    CHECK(rising.limit_W.force.y() == Approx(-1.0));
    CHECK(rising.gate_W.force.y() == Approx(-3.0));
    check_sum(rising);
    const ForceAccount below = account(push(0.0, 6.0), GatePhase::open, Fault::none, 9.0);
    CHECK(below.limit_W.force.norm() == 0.0);
    check_sum(below);
    // A limit that is not known takes nothing.
    CHECK(account(push(0.0, 6.0), GatePhase::open, Fault::none, 0.0).limit_W.force.norm() == 0.0);
}

TEST_CASE("force account: where a gate is shut or a fault holds, the gate takes all") {
    for (const GatePhase gate : {GatePhase::waiting, GatePhase::fading, GatePhase::stopped}) {
        const ForceAccount shut = account(push(0.0, 0.0), gate);
        CHECK(shut.limit_W.force.norm() == 0.0);
        CHECK(shut.gate_W.force.y() == -6.0);
        check_sum(shut);
    }
    const ForceAccount fading = account(push(0.0, 1.0), GatePhase::open, Fault::hand_too_fast);
    CHECK(fading.limit_W.force.norm() == 0.0);
    check_sum(fading);
}

TEST_CASE("force account: a torque above its limit is cut like a force") {
    const Wrench asked{Vector3::Zero(), Vector3(0.0, 0.0, 0.6)};
    const ForceAccount turned =
        make_account({}, {}, asked, {Vector3::Zero(), Vector3(0.0, 0.0, 0.3)}, GatePhase::open,
                     Fault::none, {5.0, 0.3});
    CHECK(turned.limit_W.torque.z() == Approx(-0.3));
    CHECK(turned.gate_W.torque.norm() < kRounding);
}

TEST_CASE("force account: per cent are of what is felt, negative against it, none across it") {
    CHECK(percent_of({0, -3, 0}, {0, -2, 0}) == Approx(150.0));
    CHECK(percent_of({0, 1, 0}, {0, -2, 0}) == Approx(-50.0));
    CHECK(percent_of({7, 0, 0}, {0, -2, 0}) == 0.0);
    CHECK(percent_of({7, 0, 0}, Vector3::Zero()) == 0.0);
}

TEST_CASE("force account: of a record the newest round that is not later is told") {
    const Record record = make_record();
    const auto at = value_of(find_account(record, 0.5039));
    CHECK(at.tick == 3);
    CHECK(at.touched == "apple");
    CHECK(at.effects[0].name == "contact");
    CHECK(at.effects[0].wrench_W.force.x() == Approx(0.3));
    check_sum(at);
    CHECK(find_account(record, 0.5041)->touched == "body 6");
    CHECK(find_account(record, 0.5)->tick == 0);
    CHECK(find_account(record, 0.5099)->tick == 9);
}

TEST_CASE("force account: a time outside the record and a record without shares are refused") {
    const Record record = make_record();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double time_s : {0.4999, 0.5101, -1.0, nan}) {
        const auto refused = error_of(find_account(record, time_s));
        check_says(refused.message, {"has no round at"});
        CHECK(refused.what_to_do == "give --force a time from 0.5 to 0.509");
    }
    Record old = record;
    old.version = 3;
    old.header.effects.clear();
    check_says(find_account(old, 0.502).error().message, {"version 3"});
    old.version = kRecordVersion;
    check_says(find_account(old, 0.502).error().message, {"no effect"});
    Record empty = record;
    empty.samples.clear();
    CHECK_FALSE(find_account(empty, 0.5));
}

TEST_CASE("force account: the table says who, how much, where to and what was taken") {
    const std::string text = account_text(*find_account(make_record(), 0.503));
    INFO(text);
    CHECK(text.find("gravity at 0.5030 s (round 3): the hand feels 0.583 N down and right.") == 0);
    check_says(text, {"It touches apple.", "weight                    1.0000  down",
                      "the gate, rising          0.5000  up"});
    CHECK(text.find("newton m") == std::string::npos);  // nothing turns
    ForceAccount faulty = account(push(0.0, 0.0), GatePhase::waiting, Fault::command_stale);
    faulty.asked_W.torque.x() = 0.1;
    const std::string told = account_text(faulty);
    check_says(told, {"the hand feels nothing.\nNothing is touched.",
                      "The force fades: lesson or world silent.", "newton m"});
    CHECK(told.find('%') == std::string::npos);
}

TEST_CASE("force account: the JSON holds the numbers to the bit") {
    const ForceAccount at = *find_account(make_record(), 0.503);
    const auto whole = nlohmann::json::parse(accounts_json({&at, 1}));
    CHECK(whole["version"] == 2);
    CHECK(whole["lesson"] == "gravity");
    REQUIRE(whole["hands"].size() == 1);
    const auto& json = whole["hands"][0];
    CHECK(json["round"] == 3);
    CHECK(json["touched"] == "apple");
    CHECK(json["hand"] == 1);
    CHECK(json["gate"] == "rising");
    CHECK(json["effects"].size() == 2);
    CHECK(json["effects"][0]["force_N"][0].get<double>() == at.effects[0].wrench_W.force.x());
    CHECK(json["felt"]["percent"].get<double>() == Approx(100.0));
    CHECK(json["taken_by_gate"]["force_N"][1].get<double>() == 0.5);
}

TEST_CASE("force account: of several hands the JSON is one document, of none too") {
    std::vector<ForceAccount> accounts = {*find_account(make_record(), 0.503),
                                          *find_account(make_record(), 0.503)};
    accounts[1].hand = 1;
    const auto two = nlohmann::json::parse(accounts_json(accounts));
    REQUIRE(two["hands"].size() == 2);
    CHECK(two["hands"][0]["hand"] == 1);
    CHECK(two["hands"][1]["hand"] == 2);
    CHECK(nlohmann::json::parse(accounts_json({}))["hands"].empty());
}
