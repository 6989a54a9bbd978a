#include "runtime/evidence/record_csv.h"

#include "haptics/record/record_writer.h"
#include "tests/support/csv_reader.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
namespace fs = std::filesystem;

namespace {

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
