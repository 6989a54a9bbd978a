#include "haptics/base/crc32.h"
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

constexpr std::ptrdiff_t kEndBlockBytes = 16 + 40;

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
    const std::size_t at = header_bytes();
    std::memcpy(&size, &bytes[at + 8], 4);
    const std::uint32_t checksum =
        compute_crc32(all.subspan(at + 16, size), compute_crc32(all.subspan(at + 4, 8)));
    put_u32(bytes, at + 12, checksum);
}

// Makes the header's checksum fit again after it was changed; `size` is the header's.
void mend_header(std::vector<std::byte>& bytes, std::size_t size) {
    put_u32(bytes, size - 4, compute_crc32(std::span(bytes).first(size - 4)));
}

}  // namespace

TEST_CASE("record: a force that was NaN can be kept, a pose cannot be NaN") {
    RecordEncoder encoder(RecordHeader{});
    RecordSample sample = make_sample(1);
    sample.commanded_W.force.x() = std::numeric_limits<double>::quiet_NaN();
    encoder.append(sample);
    encoder.finish();
    const Expected<Record> kept = read_record(encoder.take_bytes());
    REQUIRE(kept);
    CHECK(std::isnan(kept->samples[0].commanded_W.force.x()));
    RecordEncoder bad(RecordHeader{});
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
    CHECK(complaint(bytes).find("header is damaged: its checksum") != std::string::npos);
    for (const std::uint32_t size : {0U, 19U, 0x7FFFFFFFU}) {
        bytes = good;
        put_u32(bytes, 12, size);
        CHECK(complaint(bytes).find("cannot have this length") != std::string::npos);
    }
    bytes = good;
    put_u32(bytes, 12, static_cast<std::uint32_t>(bytes.size() + 1));
    CHECK(complaint(bytes).find("shorter than its own header") != std::string::npos);
    for (const double rate_Hz : {1e9, 0.0, std::numeric_limits<double>::quiet_NaN()}) {
        RecordEncoder fast({rate_Hz, "x", 0.0, 0.0, {}, {}, {}});
        fast.finish();
        CHECK(complaint(fast.take_bytes()).find("impossible rate") != std::string::npos);
    }
    RecordEncoder pull({1000.0, "x", -1.0, 0.0, {}, {}, {}});
    pull.finish();
    CHECK(complaint(pull.take_bytes()).find("impossible rate, lesson, limit") != std::string::npos);
}

// Wherever a count or a length in the header is changed, the header is refused or means something else: it is never read past its end.
TEST_CASE("record: a header whose lists cannot be is refused, with a checksum that fits") {
    const std::vector<std::byte> good = make_bytes(1);
    const std::size_t size = header_bytes();
    int refused = 0;
    for (std::size_t at = 16; at + 8 <= size; ++at) {
        for (const std::uint32_t value : {0U, 5U, 4097U, 0xFFFFFFFFU}) {
            auto bytes = good;
            put_u32(bytes, at, value);
            mend_header(bytes, size);
            refused += read_record(bytes).has_value() ? 0 : 1;
        }
    }
    CHECK(refused > 400);
    // A bell in the lesson's name, behind rate, two limits and the length.
    auto bytes = good;
    bytes[44] = std::byte{7};
    mend_header(bytes, size);
    CHECK(complaint(bytes).find("impossible rate, lesson") != std::string::npos);
}

TEST_CASE("record: those of versions 1 to 4 are read, each with the faults that it knows") {
    const auto record_of = [](Fault fault, std::uint32_t version) {
        RecordSample sample = make_sample(1);
        sample.faults = fault;
        return make_old_bytes(version, {sample, make_sample(2)},
                              {{0.5, RecordEventKind::answered, 2, "An egg."}});
    };
    const Fault last[] = {Fault::device_write, Fault::ended, Fault::too_much_energy,
                          Fault::clutched};
    for (std::uint32_t version = 1; version <= 4; ++version) {
        const auto read = read_record(record_of(last[version - 1], version));
        REQUIRE(read);
        CHECK(read->version == version);
        CHECK(read->header.lesson == "gravity");
        CHECK(read->header.effects.empty());
        REQUIRE(read->samples.size() == 2);
        CHECK(read->samples[0].faults == last[version - 1]);
        CHECK(read->samples[1].applied_W.torque == make_sample(2).applied_W.torque);
        CHECK(read->samples[1].touched_body == kNoBody);
        REQUIRE(read->shares_of(1).empty());
        REQUIRE(read->events.size() == 1);
        CHECK(read->events[0].text == "An egg.");
        CHECK(read->bodies.empty());
        if (version < 4) {
            CHECK(complaint(record_of(last[version], version)).find("impossible sample") !=
                  std::string::npos);
        }
    }
    CHECK(complaint(record_of(Fault::none, 0)).find("version 0") != std::string::npos);
    // What only today's version has is none in an old one.
    const auto late =
        make_old_bytes(4, {make_sample(1)}, {{0.5, RecordEventKind::gate, -1, "open"}});
    CHECK(complaint(late).find("impossible event") != std::string::npos);
    auto cut = record_of(Fault::none, 3);
    cut.resize(cut.size() - 33);  // the end and a byte of the events
    const auto recovered = recover_record(cut);
    REQUIRE(recovered);
    CHECK((recovered->cut_off && recovered->samples.size() == 2 && recovered->events.empty()));
}

TEST_CASE("record: hostile blocks are refused, each with its sentence") {
    const std::vector<std::byte> good = make_bytes(3);
    const std::size_t block = header_bytes();
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
    CHECK(complaint(bytes).find("impossible sample") != std::string::npos);
    // Second sample's time moved before the first's.
    bytes = good;
    const double early_s = -5.0;
    std::memcpy(&bytes[block + 16 + kFixtureSampleBytes + 8], &early_s, 8);
    mend_first_block(bytes);
    CHECK(complaint(bytes).find("impossible sample, number 1") != std::string::npos);
    bytes = good;
    put_u32(bytes, block + 16 + 224 + 8, 9);  // gate
    mend_first_block(bytes);
    CHECK(complaint(bytes).find("impossible sample, number 0") != std::string::npos);
    for (const std::uint32_t body : {64U, 0xFFFFFFFEU}) {
        bytes = good;
        put_u32(bytes, block + 16 + 224 + 12, body);  // touched
        mend_first_block(bytes);
        CHECK(complaint(bytes).find("impossible sample, number 0") != std::string::npos);
    }
    bytes = good;
    bytes.push_back(std::byte{0});
    CHECK(complaint(bytes).find("goes on after its end") != std::string::npos);
    bytes = good;
    bytes.resize(bytes.size() - kEndBlockBytes);
    CHECK(complaint(bytes).find("end is missing") != std::string::npos);
}

TEST_CASE("record: hostile events and bodies are refused, each with its sentence") {
    const auto of_event = [](RecordEvent event) {
        RecordEncoder encoder(make_header());
        encoder.append(event);
        encoder.finish();
        return encoder.take_bytes();
    };
    const std::size_t block = header_bytes();
    const RecordEvent event{0.5, RecordEventKind::answered, 2, "An egg."};
    REQUIRE(read_record(of_event(event)));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(complaint(of_event({nan, event.kind, 2, ""})).find("impossible event, number 0") !=
          std::string::npos);
    CHECK(complaint(of_event({0.5, static_cast<RecordEventKind>(20), 2, ""}))
              .find("impossible event, number 0") != std::string::npos);
    CHECK(complaint(of_event({0.5, event.kind, 64, ""})).find("impossible event, number 0") !=
          std::string::npos);
    for (const std::uint32_t length : {6U, 8U, 5000U, 0xFFFFFFFFU}) {
        auto bytes = of_event(event);
        put_u32(bytes, block + 16 + 16, length);
        mend_first_block(bytes);
        CHECK(complaint(bytes).find("impossible event") != std::string::npos);
    }
    const auto of_body = [](const RecordBody& body) {
        RecordEncoder encoder(make_header());
        encoder.append(body);
        encoder.finish();
        return encoder.take_bytes();
    };
    REQUIRE(read_record(of_body(make_body(4))));
    for (const std::int32_t who : {-1, kMaxBodies}) {
        RecordBody body = make_body(4);
        body.body = who;
        CHECK(complaint(of_body(body)).find("impossible body, number 0") != std::string::npos);
    }
    RecordBody nowhere = make_body(4);
    nowhere.state.where = static_cast<BodyWhere>(5);
    CHECK(complaint(of_body(nowhere)).find("impossible body, number 0") != std::string::npos);
    nowhere = make_body(4);
    nowhere.time_s = nan;
    CHECK(complaint(of_body(nowhere)).find("impossible body, number 0") != std::string::npos);
    auto bytes = of_body(make_body(4));
    put_u32(bytes, block + 8, kRecordBodyBytes - 1);
    mend_first_block(bytes);
    CHECK(complaint(bytes).find("impossible body") != std::string::npos);
}

TEST_CASE("record: an end that counts otherwise is refused") {
    std::vector<std::byte> three = make_bytes(3);
    const std::vector<std::byte> four = make_bytes(4);
    three.resize(three.size() - kEndBlockBytes);
    three.insert(three.end(), four.end() - kEndBlockBytes, four.end());
    CHECK(complaint(three).find("other numbers") != std::string::npos);
}

TEST_CASE("record: cut off at any byte, every whole block survives") {
    const std::vector<std::byte> whole = make_bytes(600);
    const std::size_t head = header_bytes();
    const std::size_t samples_block = 16 + kRecordBlockSamples * kFixtureSampleBytes;
    // 256 samples, 3 events, 3 bodies, 256 samples, 2 of each, then 88 samples, 1 of each and the end. An event of "apple" has 25
    // bytes.
    const auto others = [](std::size_t n) {
        return 16 + n * (16 + 4 + 5) + 16 + n * kRecordBodyBytes;
    };
    const std::size_t first_end = head + samples_block;
    const std::size_t second_end = first_end + others(3) + samples_block;
    const std::size_t third_end = second_end + others(2) + 16 + 88 * kFixtureSampleBytes;
    for (std::size_t size = 0; size < whole.size(); size += 131) {
        const std::vector<std::byte> bytes(whole.begin(), whole.begin() + std::ptrdiff_t(size));
        CHECK_FALSE(read_record(bytes));
        const Expected<Record> record = recover_record(bytes);
        REQUIRE(record.has_value() == (size >= head));
        if (record) {
            REQUIRE(record->cut_off);
            REQUIRE(record->samples.size() == (size < first_end    ? 0
                                               : size < second_end ? 256
                                               : size < third_end  ? 512
                                                                   : 600));
            REQUIRE(record->shares_W.size() == 2 * record->samples.size());
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
