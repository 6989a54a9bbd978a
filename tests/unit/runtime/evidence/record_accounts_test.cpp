#include "haptics/record/record_writer.h"
#include "runtime/evidence/force_account.h"
#include "runtime/evidence/record_csv.h"
#include "runtime/evidence/record_words.h"
#include "tests/support/csv_reader.h"
#include "tests/unit/runtime/rig.h"

#include <nlohmann/json.hpp>

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;

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

Record make_pushed_record() {
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

Record make_record(int n) {
    Record record;
    record.header.effects = {"weight", "force \"wind\", strong"};
    record.header.bodies = {"apple"};
    record.header.facts = {{"option.seed", "1"}};
    for (int k = 0; k < n; ++k) {
        RecordSample sample;
        sample.tick = static_cast<std::uint64_t>(k);
        sample.time_s = k / 3.0;
        sample.pose_D.position = Vector3(0.1, -1e-300, 1.0 / 3.0);
        sample.applied_W.force = Vector3(std::sqrt(2.0), -0.0, std::nan(""));
        sample.touched_body = k % 2 - 1;
        sample.faults = Fault::device_read | Fault::ended;
        record.samples.push_back(sample);
        record.shares_W.resize(record.shares_W.size() + 2);
        record.shares_W.back().torque.z() = 0.1 * k;
    }
    record.events = {{0.5, RecordEventKind::answered, kNoBody, "=1+1, \"he\" said"},
                     {0.6, RecordEventKind::caught, 0, ""}};
    record.bodies = {{0.25, 0, {Pose::at(Vector3(1, 2, 3)), Vector3::Zero(), BodyWhere::held}}};
    return record;
}

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::vector<std::string>> read_table(const std::string& text) {
    return value_of(parse_csv(text));
}

double number(const std::string& text) {
    return std::strtod(text.c_str(), nullptr);
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
    const Record record = make_pushed_record();
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
    const Record record = make_pushed_record();
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
    const std::string text = account_text(*find_account(make_pushed_record(), 0.503));
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
    const ForceAccount at = *find_account(make_pushed_record(), 0.503);
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
    std::vector<ForceAccount> accounts = {*find_account(make_pushed_record(), 0.503),
                                          *find_account(make_pushed_record(), 0.503)};
    accounts[1].hand = 1;
    const auto two = nlohmann::json::parse(accounts_json(accounts));
    REQUIRE(two["hands"].size() == 2);
    CHECK(two["hands"][0]["hand"] == 1);
    CHECK(two["hands"][1]["hand"] == 2);
    CHECK(nlohmann::json::parse(accounts_json({}))["hands"].empty());
}

TEST_CASE("record csv: every row has the header's cells, every number is read again to the bit") {
    const ScratchFolder folder;
    const Record record = make_record(5);
    const fs::path file = folder.path() / "run.csv";
    REQUIRE(export_record(record, file));
    const auto rows = read_table(text_of(file));
    REQUIRE(rows.size() == 6);
    for (const auto& row : rows) {
        CHECK(row.size() == 16 + 12 + 4 + 12);
    }
    CHECK(rows[0][0] == "tick");
    CHECK(rows[0][22] == "applied_force_x_N");
    CHECK(rows[0].back() == "force \"wind\", strong_torque_z_Nm");
    for (std::size_t i = 0; i < 5; ++i) {
        const auto& row = rows[i + 1];
        CHECK(number(row[1]) == record.samples[i].time_s);
        CHECK(number(row[4]) == -1e-300);
        CHECK(number(row[5]) == 1.0 / 3.0);
        CHECK(number(row[22]) == std::sqrt(2.0));
        CHECK(row[23] == "-0");
        CHECK(std::isnan(number(row[24])));
        CHECK(row[30] == "no pose from the device, run ended");
        CHECK(row[31] == (i % 2 == 0 ? "" : "apple"));
        CHECK(number(row.back()) == record.shares_of(i)[1].torque.z());
    }
}

TEST_CASE("record csv: events, bodies and facts stand beside, and no learner writes a formula") {
    const ScratchFolder folder;
    REQUIRE(export_record(make_record(1), folder.path() / "run.csv"));
    const auto events = read_table(text_of(folder.path() / "run.events.csv"));
    REQUIRE(events.size() == 3);
    CHECK(events[1] == std::vector<std::string>{"0.5", "answered", "", "'=1+1, \"he\" said"});
    CHECK(events[2][2] == "apple");
    const auto bodies = read_table(text_of(folder.path() / "run.bodies.csv"));
    REQUIRE(bodies.size() == 2);
    CHECK((bodies[1][1] == "apple" && bodies[1][2] == "held" && bodies[1][5] == "3"));
    CHECK(bodies[1].size() == bodies[0].size());
    const auto facts = read_table(text_of(folder.path() / "run.facts.csv"));
    CHECK(facts[1] == std::vector<std::string>{"option.seed", "1"});
}

TEST_CASE("record csv: what is stopped leaves nothing, and what was there stays") {
    const ScratchFolder folder;
    const fs::path file = folder.path() / "run.csv";
    check_says(
        error_of(export_record(make_record(5000), file, [](double share) { return share < 0.5; }))
            .message,
        {"stopped"});
    CHECK(fs::is_empty(folder.path()));
    std::ofstream(file) << "mine";
    CHECK_FALSE(export_record(make_record(5000), file, [](double) { return false; }));
    CHECK(text_of(file) == "mine");
    // A folder in the last table's way: none of the others takes its place.
    fs::create_directory(folder.path() / "run.facts.csv");
    check_says(error_of(export_record(make_record(5), file)).message, {"it is a folder"});
    CHECK(text_of(file) == "mine");
    CHECK_FALSE(fs::exists(folder.path() / "run.events.csv"));
    CHECK_FALSE(fs::exists(folder.path() / "run.csv.part"));
    CHECK_FALSE(export_record(make_record(1), folder.path() / "no" / "run.csv"));
    fs::remove(folder.path() / "run.facts.csv");
    REQUIRE(export_record(make_record(1), file));
    CHECK(text_of(file).starts_with("tick,"));
}

TEST_CASE("record words: a declared force has the lesson's name, one that has none its number") {
    LessonDescription lesson;
    lesson.forces = {{"breeze", {}, 3}};
    const EffectSlot slots[] = {
        {Effect::contact}, {Effect::field, 0}, {Effect::field, 1}, {Effect::brake}};
    const std::vector<std::string> words = effect_words(slots, lesson);
    CHECK(words == std::vector<std::string>{"contact", "force breeze", "force 2", "brake"});
}

TEST_CASE("record words: every phase, fault, event and place has a word of its own") {
    std::set<std::string_view> words;
    for (int i = 0; i <= static_cast<int>(GatePhase::stopped); ++i) {
        words.insert(gate_word(static_cast<GatePhase>(i)));
    }
    CHECK(words.size() == 5);
    words.clear();
    for (int i = 0; i <= static_cast<int>(kLastRecordEvent); ++i) {
        words.insert(event_word(static_cast<RecordEventKind>(i)));
    }
    CHECK(words.size() == static_cast<std::size_t>(kLastRecordEvent) + 1);
    CHECK(where_word(BodyWhere::landed) == "landed");
    CHECK(fault_words(Fault::none) == "none");
    CHECK(fault_words(Fault::device_read | Fault::too_much_energy) ==
          "no pose from the device, too much energy");
    std::set<std::string> faults;
    for (unsigned bit = 1; bit <= static_cast<unsigned>(Fault::other_stopped); bit *= 2) {
        faults.insert(fault_words(static_cast<Fault>(bit)));
    }
    CHECK((faults.size() == 14 && !faults.contains("none")));
}

TEST_CASE("record words: directions are a person's before the screen, the strongest first") {
    CHECK(direction_words({0, -2, 0}) == "down");
    CHECK(direction_words({0, 3, -1}) == "up");
    CHECK(direction_words({-2, 3, 0}) == "up and left");
    CHECK(direction_words({0, 0, 1}) == "towards you");
    CHECK(direction_words({1, 0, -1}) == "right and away from you");
    CHECK(direction_words({1, 1, 1}) == "right and up and towards you");
    // Half a right angle's half: what is nearer to the axis is along it.
    const double below = std::tan(22.0 * M_PI / 180.0);
    const double above = std::tan(23.0 * M_PI / 180.0);
    CHECK(direction_words({1, below, 0}) == "right");
    CHECK(direction_words({1, above, 0}) == "right and up");
    CHECK(direction_words(Vector3::Zero()) == "-");
    CHECK(direction_words({std::numeric_limits<double>::quiet_NaN(), 0, 0}) == "-");
    CHECK(main_axes({-2, 3, 0}) == std::vector<int>{2, -1});
    CHECK(main_axes({0, 0, std::numeric_limits<double>::infinity()}).empty());
}

TEST_CASE("record words: numbers are read again to the bit") {
    for (const double x : {0.1, 1.0 / 3.0, -1e-300, 5e-324, 12345678.9, 0.0}) {
        const std::string text = exact_text(x);
        CHECK(std::strtod(text.c_str(), nullptr) == x);
    }
    CHECK(exact_text(0.1) == "0.1");
}
