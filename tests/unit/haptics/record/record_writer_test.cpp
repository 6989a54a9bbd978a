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
}

}  // namespace

TEST_CASE("record: what is written is read again, every field of it") {
    const std::vector<std::byte> bytes = make_bytes(700);
    const Expected<Record> record = read_record(bytes);
    REQUIRE(record);
    CHECK(record->header.rate_Hz == 1000.0);
    CHECK(record->header.lesson == "gravity");
    CHECK_FALSE(record->cut_off);
    REQUIRE(record->samples.size() == 700);
    for (std::size_t i = 0; i < 700; i += 13) {
        check_same(record->samples[i], make_sample(i));
    }
    REQUIRE(record->events.size() == 7);
    CHECK(record->events[1].time_s == 0.150);
    CHECK(record->events[1].kind == RecordEventKind::caught);
    CHECK(record->events[1].body == 2);
    CHECK(record->events[1].text == "apple");
}

TEST_CASE("record: sizes are as the format says, and fields lie where it says") {
    const std::vector<std::byte> bytes = make_bytes(1);
    // header, a block of one sample, the end
    REQUIRE(bytes.size() == kRecordHeaderBytes + 16 + kRecordSampleBytes + 16 + 16);
    CHECK(std::memcmp(bytes.data(),
                      "\x89"
                      "FLCR\r\n\x1a",
                      8) == 0);
    CHECK(static_cast<int>(bytes[8]) == 4);  // version, least byte first
    CHECK(std::memcmp(&bytes[24], "gravity", 7) == 0);
    CHECK(std::memcmp(&bytes[kRecordHeaderBytes], "BLK1", 4) == 0);
    double z = 0.0;
    std::memcpy(&z, &bytes[kRecordHeaderBytes + 16 + 24 + 16], 8);
    CHECK(z == -0.3);
}

TEST_CASE("record: the same run makes the same bytes") {
    CHECK(make_bytes(1000) == make_bytes(1000));
}

TEST_CASE("record: long texts are cut at a character, and zeros end them") {
    RecordEncoder encoder(
        {1000.0, std::string(59, 'a') + "\xC3\xA9"});  // the e with its accent does not fit whole
    encoder.append(RecordEvent{0.0, RecordEventKind::note, kNoBody, std::string("a\0b", 3)});
    encoder.finish();
    const Expected<Record> record = read_record(encoder.take_bytes());
    REQUIRE(record);
    CHECK(record->header.lesson == std::string(59, 'a'));
    CHECK(record->events[0].text == "a");
}

TEST_CASE("record writer: a file is written, read, and bad places are refused") {
    std::string folder =
        (std::filesystem::temp_directory_path() / "fulcrum_record_XXXXXX").string();
    REQUIRE(mkdtemp(folder.data()) != nullptr);
    const std::string path = folder + "/run.flcr";
    {
        auto writer = RecordWriter::create(path, {2000.0, "kite"});
        REQUIRE(writer);
        auto ring = std::make_unique<RecordRing>();
        for (std::uint64_t i = 0; i < 300; ++i) {
            REQUIRE(ring->push(make_sample(i)));
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
            REQUIRE(writer->append(make_sample(300 + i)));
        }
        CHECK_FALSE(writer->append(make_sample(999)));
    }
    const Expected<Record> record = load_record(path);
    REQUIRE(record);
    CHECK_FALSE(record->cut_off);
    CHECK(record->samples.size() == 300);
    CHECK(record->events.size() == 1);
    CHECK_FALSE(RecordWriter::create(folder + "/no/such/run.flcr", {}));
    const Expected<Record> missing = load_record(folder + "/none.flcr");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().where.find("none.flcr") != std::string::npos);
    CHECK_FALSE(load_record(folder));
    std::filesystem::remove_all(folder);
}
