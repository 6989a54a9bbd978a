#include "haptics/record/record_reader.h"

#include "tests/support/bad_numbers.h"
#include "tests/unit/haptics/record/record_fixture.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <random>
#include <span>

using namespace fulcrum;

namespace {
constexpr std::ptrdiff_t kEndBlockBytes = 16 + 40;

// What is done to the bytes of a record of three rounds, and what is said then.
struct Damage {
    const char* said;
    std::function<void(std::vector<std::byte>&)> happens;
};

void check_each(const std::vector<Damage>& all) {
    for (const Damage& damage : all) {
        CAPTURE(damage.said);
        std::vector<std::byte> bytes = make_bytes(3);
        damage.happens(bytes);
        CHECK(find_complaint(bytes).find(damage.said) != std::string::npos);
    }
}
std::function<void(std::vector<std::byte>&)> put(std::size_t at, std::uint32_t value) {
    return [=](std::vector<std::byte>& bytes) { put_u32(bytes, at, value); };
}
// A block's fields need its checksum to fit, or nobody would look at them.
std::function<void(std::vector<std::byte>&)> put_mended(std::size_t at, std::uint32_t value) {
    return [=](std::vector<std::byte>& bytes) {
        put_u32(bytes, at, value);
        mend_block(bytes, header_bytes());
    };
}
std::function<void(std::vector<std::byte>&)> flip(std::size_t at, unsigned bits) {
    return [=](std::vector<std::byte>& bytes) { bytes[at] ^= static_cast<std::byte>(bits); };
}

// One thing alone, written.
template <class T>
std::vector<std::byte> write_alone(const T& one, const RecordHeader& header = make_header()) {
    RecordEncoder encoder(header);
    encoder.append(one);
    encoder.finish();
    return encoder.take_bytes();
}
std::vector<std::byte> write_header(const RecordHeader& header) {
    RecordEncoder encoder(header);
    encoder.finish();
    return encoder.take_bytes();
}

}  // namespace

TEST_CASE(
    "record: a NaN force is kept, a NaN pose is not; an end that counts otherwise is refused") {
    RecordSample sample = make_sample(1);
    sample.commanded_W.force.x() = kNan;
    const Expected<Record> kept = read_record(write_alone(sample, RecordHeader{}));
    REQUIRE(kept);
    CHECK(std::isnan(kept->samples[0].commanded_W.force.x()));
    sample.pose_D.position.x() = kInfinity;
    CHECK(find_complaint(write_alone(sample, RecordHeader{})).find("impossible sample") !=
          std::string::npos);
    std::vector<std::byte> three = make_bytes(3);
    const std::vector<std::byte> four = make_bytes(4);
    three.resize(three.size() - kEndBlockBytes);
    three.insert(three.end(), four.end() - kEndBlockBytes, four.end());
    CHECK(find_complaint(three).find("other numbers") != std::string::npos);
}

TEST_CASE("record: hostile headers are refused, each with its sentence") {
    check_each(
        {{"shorter", [](std::vector<std::byte>& bytes) { bytes.clear(); }},
         {"shorter", [](std::vector<std::byte>& bytes) { bytes.resize(50); }},
         {"no Fulcrum record", [](std::vector<std::byte>& bytes) { bytes[0] = std::byte{'P'}; }},
         {"version 99", put(8, 99)},
         {"header is damaged: its checksum", flip(20, 1)},
         {"cannot have this length", put(kHeaderSizeAt, 0)},
         {"cannot have this length", put(kHeaderSizeAt, 19)},
         {"cannot have this length", put(kHeaderSizeAt, 0x7FFFFFFFU)},
         {"shorter than its own header",
          put(kHeaderSizeAt, static_cast<std::uint32_t>(make_bytes(3).size() + 1))}});
    for (const double rate_Hz : {1e9, 0.0, kNan}) {
        CHECK(find_complaint(write_header({rate_Hz, "x", 0.0, 0.0, {}, {}, {}}))
                  .find("impossible rate") != std::string::npos);
    }
    CHECK(find_complaint(write_header({1000.0, "x", -1.0, 0.0, {}, {}, {}}))
              .find("impossible rate, lesson, limit") != std::string::npos);
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
            mend_header(bytes);
            refused += read_record(bytes).has_value() ? 0 : 1;
        }
    }
    CHECK(refused > 400);
    // A bell in the lesson's name, behind rate, two limits and the length.
    auto bytes = good;
    bytes[44] = std::byte{7};
    mend_header(bytes);
    CHECK(find_complaint(bytes).find("impossible rate, lesson") != std::string::npos);
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
            CHECK(find_complaint(record_of(last[version], version)).find("impossible sample") !=
                  std::string::npos);
        }
    }
    CHECK(find_complaint(record_of(Fault::none, 0)).find("version 0") != std::string::npos);
    // What only today's version has is none in an old one.
    const auto late =
        make_old_bytes(4, {make_sample(1)}, {{0.5, RecordEventKind::gate, -1, "open"}});
    CHECK(find_complaint(late).find("impossible event") != std::string::npos);
    auto cut = record_of(Fault::none, 3);
    cut.resize(cut.size() - 33);  // the end and a byte of the events
    const auto recovered = recover_record(cut);
    REQUIRE(recovered);
    CHECK((recovered->cut_off && recovered->samples.size() == 2 && recovered->events.empty()));
    CHECK(recovered->fault == "the record is cut off in the middle of a block");
    auto flipped = record_of(Fault::none, 3);
    flipped[flipped.size() - 40] ^= std::byte{1};
    const auto damaged = recover_record(flipped);
    REQUIRE(damaged);
    CHECK((damaged->cut_off && damaged->samples.size() == 2));
    CHECK(damaged->fault == "the record is damaged: a block's checksum does not fit");
}

TEST_CASE("record: hostile blocks are refused, each with its sentence") {
    const std::size_t block = header_bytes();
    const std::size_t sample = block + kBlockHead;
    check_each({
        {"does not begin", put(block, 0)},
        {"claims 4294967295", put(block + 8, 0xFFFFFFFF)},
        {"cut off in the middle", put(block + 8, 10'000'000)},
        {"checksum", flip(block + 100, 4)},
        {"unknown kind 77", put_mended(block + 4, 77)},
        {"impossible sample", put_mended(block + 8, 239)},
        // The second sample's time moved before the first's: -5 s.
        {"impossible sample, number 1", put_mended(sample + kFixtureSampleBytes + 12, 0xC0140000U)},
        {"impossible sample, number 0", put_mended(sample + 224 + 8, 9)},    // gate
        {"impossible sample, number 0", put_mended(sample + 224 + 12, 64)},  // touched
        {"impossible sample, number 0", put_mended(sample + 224 + 12, 0xFFFFFFFEU)},
        {"goes on after its end",
         [](std::vector<std::byte>& bytes) { bytes.push_back(std::byte{0}); }},
        {"end is missing",
         [](std::vector<std::byte>& bytes) { bytes.resize(bytes.size() - kEndBlockBytes); }},
    });
}

TEST_CASE("record: hostile events and bodies are refused, each with its sentence") {
    const std::size_t block = header_bytes();
    const auto refuses = [](const std::vector<std::byte>& bytes, const char* sentence) {
        return find_complaint(bytes).find(sentence) != std::string::npos;
    };
    const RecordEvent event{0.5, RecordEventKind::answered, 2, "An egg."};
    REQUIRE(read_record(write_alone(event)));
    for (const RecordEvent& bad : {RecordEvent{kNan, event.kind, 2, ""},
                                   RecordEvent{0.5, static_cast<RecordEventKind>(20), 2, ""},
                                   RecordEvent{0.5, event.kind, 64, ""}}) {
        CHECK(refuses(write_alone(bad), "impossible event, number 0"));
    }
    for (const std::uint32_t length : {6U, 8U, 5000U, 0xFFFFFFFFU}) {
        auto bytes = write_alone(event);
        put_mended(block + kBlockHead + 16, length)(bytes);
        CHECK(refuses(bytes, "impossible event"));
    }
    REQUIRE(read_record(write_alone(make_body(4))));
    std::array<RecordBody, 4> bodies;
    bodies.fill(make_body(4));
    bodies[0].body = -1;
    bodies[1].body = kMaxBodies;
    bodies[2].state.where = static_cast<BodyWhere>(5);
    bodies[3].time_s = kNan;
    for (const RecordBody& bad : bodies) {
        CHECK(refuses(write_alone(bad), "impossible body, number 0"));
    }
    auto bytes = write_alone(make_body(4));
    put_mended(block + 8, kRecordBodyBytes - 1)(bytes);
    CHECK(refuses(bytes, "impossible body"));
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
