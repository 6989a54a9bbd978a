#include "haptics/record/record_writer.h"

#include "tests/unit/haptics/record/record_fixture.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

using namespace fulcrum;

namespace {

void check_same(const RecordSample& a, const RecordSample& b) {
    CHECK(a.tick == b.tick);
    CHECK(a.time_s == b.time_s);
    CHECK(a.stamp_s == b.stamp_s);
    CHECK(a.pose_D.position == b.pose_D.position);
    CHECK(a.pose_D.orientation.coeffs() == b.pose_D.orientation.coeffs());
    CHECK(a.twist_W.linear == b.twist_W.linear);
    CHECK(a.twist_W.angular == b.twist_W.angular);
    CHECK(a.commanded_W.force == b.commanded_W.force);
    CHECK(a.commanded_W.torque == b.commanded_W.torque);
    CHECK(a.applied_W.force == b.applied_W.force);
    CHECK(a.applied_W.torque == b.applied_W.torque);
    CHECK(a.buttons == b.buttons);
    CHECK(a.faults == b.faults);
    CHECK(a.gate == b.gate);
    CHECK(a.touched_body == b.touched_body);
}

}  // namespace

TEST_CASE("record: what is written is read again, every field of it") {
    const std::vector<std::byte> bytes = make_bytes(700);
    const Expected<Record> record = read_record(bytes);
    REQUIRE(record);
    CHECK(record->header.rate_Hz == 1000.0);
    CHECK(record->header.lesson == "gravity");
    CHECK(record->header.max_force_N == 5.0);
    CHECK(record->header.max_torque_Nm == 0.3);
    CHECK(record->header.effects == make_header().effects);
    CHECK(record->header.bodies == make_header().bodies);
    CHECK(record->header.facts == make_header().facts);
    CHECK(record->version == kRecordVersion);
    CHECK_FALSE(record->cut_off);
    REQUIRE(record->samples.size() == 700);
    REQUIRE(record->shares_W.size() == 1400);
    for (std::size_t i = 0; i < 700; i += 13) {
        check_same(record->samples[i], make_sample(i));
        for (std::size_t k = 0; k < 2; ++k) {
            CHECK(record->shares_of(i)[k].force == make_shares(i)[k].force);
            CHECK(record->shares_of(i)[k].torque == make_shares(i)[k].torque);
        }
    }
    REQUIRE(record->bodies.size() == 7);
    for (std::size_t i = 0; i < 7; ++i) {
        const RecordBody expected = make_body(100 * i + 50);
        const RecordBody& body = record->bodies[i];
        CHECK((body.time_s == expected.time_s && body.body == expected.body));
        CHECK(body.state.where == expected.state.where);
        CHECK(body.state.pose_W.position == expected.state.pose_W.position);
        CHECK(body.state.pose_W.orientation.coeffs() == expected.state.pose_W.orientation.coeffs());
        CHECK(body.state.velocity_W == expected.state.velocity_W);
    }
    REQUIRE(record->events.size() == 7);
    CHECK(record->events[1].time_s == 0.150);
    CHECK(record->events[1].kind == RecordEventKind::caught);
    CHECK(record->events[1].body == 2);
    CHECK(record->events[1].text == "apple");
}

TEST_CASE("record: sizes are as the format says, and fields lie where it says") {
    const std::vector<std::byte> bytes = make_bytes(1);
    const std::size_t head = header_bytes();
    // header, a block of one sample, the end
    REQUIRE(bytes.size() == head + 16 + kFixtureSampleBytes + 16 + 40);
    CHECK(std::memcmp(bytes.data(),
                      "\x89"
                      "FLCR\r\n\x1a",
                      8) == 0);
    CHECK(static_cast<int>(bytes[8]) == 8);  // version, least byte first
    CHECK(static_cast<std::size_t>(bytes[12]) == head);
    CHECK(static_cast<int>(bytes[40]) == 7);  // the lesson's length, behind three numbers
    CHECK(std::memcmp(&bytes[44], "gravity", 7) == 0);
    CHECK(std::memcmp(&bytes[head], "BLK1", 4) == 0);
    double number = 0.0;
    std::memcpy(&number, &bytes[head + 16 + 24 + 16], 8);
    CHECK(number == -0.3);  // z of the pose
    std::memcpy(&number, &bytes[head + 16 + kRecordSampleBytes + 8], 8);
    CHECK(number == -9.0);  // y of the first effect's force
}

TEST_CASE("record: the same run makes the same bytes") {
    CHECK(make_bytes(1000) == make_bytes(1000));
}

TEST_CASE("record: long texts are cut at a character, and what cannot stand on a line is blank") {
    RecordHeader header;
    // the e with its accent does not fit whole
    header.lesson = std::string(kRecordTextBytes - 1, 'a') + "\xC3\xA9";
    header.facts = {{"lesson.odd\nname", ""}};
    RecordEncoder encoder(header);
    encoder.append(RecordEvent{0.0, RecordEventKind::note, kNoBody, std::string("a\0b\tc", 5)});
    encoder.finish();
    const Expected<Record> record = read_record(encoder.take_bytes());
    REQUIRE(record);
    CHECK(record->header.lesson == std::string(kRecordTextBytes - 1, 'a'));
    CHECK(record->header.facts[0].name == "lesson.odd name");
    CHECK(record->events[0].text == "a b c");
}

TEST_CASE("record: lists longer than the format holds are shortened, missing shares are zero") {
    RecordHeader header;
    header.effects.assign(kMostEffects + 3, "e");
    header.bodies.assign(kMaxBodies + 3, "b");
    header.facts.assign(kRecordFacts + 3, {"f", "1"});
    RecordEncoder encoder(header);
    const std::vector<Wrench> one = {{Vector3(1, 2, 3), Vector3(4, 5, 6)}};
    encoder.append(make_sample(1), one);
    encoder.finish();
    const Expected<Record> record = read_record(encoder.take_bytes());
    REQUIRE(record);
    CHECK(record->header.effects.size() == kMostEffects);
    CHECK(record->header.bodies.size() == kMaxBodies);
    CHECK(record->header.facts.size() == kRecordFacts);
    CHECK(record->shares_of(0)[0].torque.z() == 6.0);
    CHECK(record->shares_of(0)[kMostEffects - 1].force.norm() == 0.0);
}

TEST_CASE("record: a round with more shares than there are places keeps what it can have") {
    RecordEncoder encoder(make_header());
    RecordRound round;
    round.sample = make_sample(1);
    round.shares.n = 1000;
    encoder.append(round);
    encoder.finish();
    CHECK(read_record(encoder.take_bytes()));
}

TEST_CASE("record writer: a file is written, read, and bad places are refused") {
    std::string folder =
        (std::filesystem::temp_directory_path() / "fulcrum_record_XXXXXX").string();
    REQUIRE(mkdtemp(folder.data()) != nullptr);
    const std::string path = folder + "/run.flcr";
    {
        auto writer = RecordWriter::create(path, make_header());
        REQUIRE(writer);
        auto ring = std::make_unique<RecordRing>();
        for (std::uint64_t i = 0; i < 300; ++i) {
            REQUIRE(ring->push({make_sample(i), {}}));
        }
        REQUIRE(writer->drain(*ring));
        REQUIRE(writer->append(RecordEvent{0.5, RecordEventKind::note, kNoBody, "half"}));
        // A crash here would leave the first block.
        const Expected<Record> so_far = load_record(path);
        REQUIRE(so_far);
        CHECK(so_far->cut_off);
        CHECK(so_far->samples.size() == 256);
        REQUIRE(writer->finish());
        // The file is closed: a further block has nowhere to go.
        for (std::uint64_t i = 0; i + 1 < kRecordBlockSamples; ++i) {
            REQUIRE(writer->append(RecordRound{make_sample(300 + i), {}}));
        }
        CHECK_FALSE(writer->append(RecordRound{make_sample(999), {}}));
    }
    const Expected<Record> record = load_record(path);
    REQUIRE(record);
    CHECK_FALSE(record->cut_off);
    CHECK(record->samples.size() == 300);
    CHECK(record->events.size() == 1);
    // It is its owner's alone, and what is put in the place of an older file as well.
    namespace fs = std::filesystem;
    const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
    CHECK(fs::status(path).permissions() == own);
    fs::permissions(path, fs::perms::all);
    REQUIRE(RecordWriter::create(path, {}));
    CHECK(fs::status(path).permissions() == own);
    CHECK_FALSE(RecordWriter::create(folder + "/no/such/run.flcr", {}));
    const Expected<Record> missing = load_record(folder + "/none.flcr");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().where.find("none.flcr") != std::string::npos);
    CHECK_FALSE(load_record(folder));
    std::filesystem::remove_all(folder);
}
