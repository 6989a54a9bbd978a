#include "haptics/record/record.h"
#include "tests/unit/haptics/record/record_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <span>

using namespace fulcrum;

namespace {

// What the reader says about these bytes.
std::string complaint(const std::vector<std::byte>& bytes) {
    const Expected<Record> record = read_record(bytes);
    REQUIRE_FALSE(record);
    CHECK_FALSE(record.error().message.empty());
    return record.error().message;
}

void put_u32(std::vector<std::byte>& bytes, std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) {
        bytes[at + i] = static_cast<std::byte>(value >> (8 * i));
    }
}

// Makes the first block's checksum fit again after its payload was changed.
void mend_first_block(std::vector<std::byte>& bytes) {
    const std::span<const std::byte> all(bytes);
    std::uint32_t size = 0;
    std::memcpy(&size, &bytes[kRecordHeaderBytes + 8], 4);
    const std::uint32_t checksum =
        compute_crc32(all.subspan(kRecordHeaderBytes + 16, size),
                      compute_crc32(all.subspan(kRecordHeaderBytes + 4, 8)));
    put_u32(bytes, kRecordHeaderBytes + 12, checksum);
}

}  // namespace

TEST_CASE("record: a force that was NaN can be kept, a pose cannot be NaN") {
    RecordEncoder encoder({1000.0, "x"});
    RecordSample sample = make_sample(1);
    sample.commanded_W.force.x() = std::numeric_limits<double>::quiet_NaN();
    encoder.append(sample);
    encoder.finish();
    const Expected<Record> kept = read_record(encoder.take_bytes());
    REQUIRE(kept);
    CHECK(std::isnan(kept->samples[0].commanded_W.force.x()));
    RecordEncoder bad({1000.0, "x"});
    sample.pose_D.position.x() = std::numeric_limits<double>::infinity();
    bad.append(sample);
    bad.finish();
    CHECK(complaint(bad.take_bytes()).find("impossible sample") != std::string::npos);
}

TEST_CASE("record: hostile headers are refused, each with its sentence") {
    const std::vector<std::byte> good = make_bytes(3);
    CHECK(complaint({}).find("shorter") != std::string::npos);
    std::vector<std::byte> bytes(good.begin(), good.begin() + 50);
    CHECK(complaint(bytes).find("shorter") != std::string::npos);
    bytes = good;
    bytes[0] = std::byte{'P'};
    CHECK(complaint(bytes).find("no Fulcrum record") != std::string::npos);
    bytes = good;
    put_u32(bytes, 8, 99);
    CHECK(complaint(bytes).find("version 99") != std::string::npos);
    bytes = good;
    bytes[20] ^= std::byte{1};
    CHECK(complaint(bytes).find("header is damaged") != std::string::npos);
    RecordEncoder fast({1e9, "x"});
    fast.finish();
    CHECK(complaint(fast.take_bytes()).find("impossible rate") != std::string::npos);
    RecordEncoder bell({1000.0, "x\ay"});
    bell.finish();
    CHECK(complaint(bell.take_bytes()).find("impossible rate or lesson") != std::string::npos);
}

TEST_CASE("record: one of version 1 is read, without the fault that it cannot know") {
    const auto record_of = [](Fault fault, std::uint32_t version) {
        RecordEncoder encoder({1000.0, "gravity"});
        RecordSample sample = make_sample(1);
        sample.faults = fault;
        encoder.append(sample);
        encoder.finish();
        std::vector<std::byte> bytes = encoder.take_bytes();
        put_u32(bytes, 8, version);
        put_u32(bytes, kRecordHeaderBytes - 4,
                compute_crc32(std::span(bytes).first(kRecordHeaderBytes - 4)));
        return bytes;
    };
    for (const std::uint32_t version : {1U, 2U}) {
        const auto read = read_record(record_of(Fault::device_write, version));
        REQUIRE(read);
        CHECK(read->samples.front().faults == Fault::device_write);
    }
    const auto left = read_record(record_of(Fault::ended, 2));
    REQUIRE(left);
    CHECK(left->samples.front().faults == Fault::ended);
    CHECK(complaint(record_of(Fault::ended, 1)).find("impossible sample") != std::string::npos);
    CHECK(complaint(record_of(static_cast<Fault>(1U << 10), 2)).find("impossible sample") !=
          std::string::npos);
    REQUIRE(read_record(record_of(Fault::clutched, 4)));
    CHECK(complaint(record_of(Fault::clutched, 3)).find("impossible sample") != std::string::npos);
    CHECK(complaint(record_of(Fault::none, 0)).find("version 0") != std::string::npos);
}

TEST_CASE("record: hostile blocks are refused, each with its sentence") {
    const std::vector<std::byte> good = make_bytes(3);
    const std::size_t block = kRecordHeaderBytes;
    auto bytes = good;
    bytes[block] = std::byte{0};
    CHECK(complaint(bytes).find("does not begin") != std::string::npos);
    bytes = good;
    put_u32(bytes, block + 8, 0xFFFFFFFF);
    CHECK(complaint(bytes).find("claims 4294967295") != std::string::npos);
    bytes = good;
    put_u32(bytes, block + 8, 10'000'000);
    CHECK(complaint(bytes).find("cut off in the middle") != std::string::npos);
    bytes = good;
    bytes[block + 100] ^= std::byte{4};
    CHECK(complaint(bytes).find("checksum") != std::string::npos);
    bytes = good;
    put_u32(bytes, block + 4, 77);
    mend_first_block(bytes);
    CHECK(complaint(bytes).find("unknown kind 77") != std::string::npos);
    bytes = good;
    put_u32(bytes, block + 8, 239);
    mend_first_block(bytes);
    CHECK(complaint(bytes).find("no whole number") != std::string::npos);
    // Second sample's time moved before the first's.
    bytes = good;
    const double early_s = -5.0;
    std::memcpy(&bytes[block + 16 + kRecordSampleBytes + 8], &early_s, 8);
    mend_first_block(bytes);
    CHECK(complaint(bytes).find("impossible sample, number 1") != std::string::npos);
    bytes = good;
    put_u32(bytes, block + 16 + 224 + 8, 9);  // gate
    mend_first_block(bytes);
    CHECK(complaint(bytes).find("impossible sample, number 0") != std::string::npos);
    bytes = good;
    bytes.push_back(std::byte{0});
    CHECK(complaint(bytes).find("goes on after its end") != std::string::npos);
    bytes = good;
    bytes.resize(bytes.size() - 32);
    CHECK(complaint(bytes).find("end is missing") != std::string::npos);
}

TEST_CASE("record: an end that counts otherwise is refused") {
    std::vector<std::byte> three = make_bytes(3);
    const std::vector<std::byte> four = make_bytes(4);
    three.resize(three.size() - 32);
    three.insert(three.end(), four.end() - 32, four.end());
    CHECK(complaint(three).find("other numbers") != std::string::npos);
}

TEST_CASE("record: cut off at any byte, every whole block survives") {
    const std::vector<std::byte> whole = make_bytes(600);
    const std::size_t first_block_end =
        kRecordHeaderBytes + 16 + kRecordBlockSamples * kRecordSampleBytes;
    for (std::size_t size = 0; size < whole.size(); size += 131) {
        const std::vector<std::byte> bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size));
        CHECK_FALSE(read_record(bytes));
        const Expected<Record> record = recover_record(bytes);
        REQUIRE(record.has_value() == (size >= kRecordHeaderBytes));
        if (record) {
            REQUIRE(record->cut_off);
            // 256 samples, 3 events, 256 samples, 2 events, then 88 samples, 1 event and the end.
            const std::size_t second_block_end =
                first_block_end + 16 + 3 * kRecordEventBytes + first_block_end - kRecordHeaderBytes;
            const std::size_t third_block_end =
                second_block_end + 16 + 2 * kRecordEventBytes + 16 + 88 * kRecordSampleBytes;
            REQUIRE(record->samples.size() == (size < first_block_end    ? 0
                                               : size < second_block_end ? 256
                                               : size < third_block_end  ? 512
                                                                         : 600));
        }
    }
    const Expected<Record> record = recover_record(whole);
    REQUIRE(record);
    CHECK_FALSE(record->cut_off);
    CHECK(record->samples.size() == 600);
}

TEST_CASE("record: random damage never crashes the reader, and damage it accepts is none") {
    const std::vector<std::byte> good = make_bytes(40);
    std::mt19937_64 random(3);
    int accepted = 0;
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::byte> bytes = good;
        const auto n_changes = 1 + random() % 4;
        for (std::uint64_t k = 0; k < n_changes; ++k) {
            bytes[random() % bytes.size()] ^= static_cast<std::byte>(1 + random() % 255);
        }
        if (random() % 4 == 0) {
            bytes.resize(random() % bytes.size());
        }
        accepted += read_record(bytes) && bytes != good;
        (void)recover_record(bytes);
    }
    CHECK(accepted == 0);
    for (int i = 0; i < 20000; ++i) {
        std::vector<std::byte> noise(random() % 400);
        for (std::byte& byte : noise) {
            byte = static_cast<std::byte>(random());
        }
        CHECK_FALSE(read_record(noise));
    }
}
