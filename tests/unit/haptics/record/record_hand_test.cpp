// Records of several hands, and those of version 5, which knew one.
#include "haptics/record/record_reader.h"
#include "tests/unit/haptics/record/record_fixture.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <span>

using namespace fulcrum;

namespace {

RecordHeader make_two_hands() {
    RecordHeader header = make_header();
    header.more_hands = {{2.5, 0.1, {"contact", "texture", "brake"}}};
    header.facts.push_back({"device.name", "an arm"});
    header.facts.push_back({"hand 2.device.name", "a stick"});
    return header;
}

std::array<Wrench, 3> second_shares(std::uint64_t tick) {
    const auto shares = make_shares(tick);
    return {shares[1], shares[0], shares[1]};
}

std::vector<std::byte> make_two_bytes(std::uint64_t n) {
    RecordEncoder encoder(make_two_hands());
    for (std::uint64_t tick = 0; tick < n; ++tick) {
        encoder.append(make_sample(tick), make_shares(tick));
        // The second hand's rounds began a little later.
        if (tick >= 5) {
            encoder.append(1, make_sample(tick + 1000), second_shares(tick));
        }
        encoder.append(2, make_sample(tick));  // a hand that is not there
    }
    encoder.finish();
    return encoder.take_bytes();
}

std::size_t find_block(const std::vector<std::byte>& bytes, std::uint32_t kind) {
    std::size_t at = u32_at(bytes, kHeaderSizeAt);
    while (at < bytes.size() && u32_at(bytes, at + 4) != kind) {
        at += kBlockHead + u32_at(bytes, at + 8);
    }
    REQUIRE(at < bytes.size());
    return at;
}

// The same record as versions 5 to 7 have it: no number of what was told at the end; of 5 no list of hands in the header, and no number
// of their samples.
std::vector<std::byte> as_version(std::uint32_t version, std::vector<std::byte> bytes) {
    put_u32(bytes, 8, version);
    if (version == 5) {
        const std::size_t head = u32_at(bytes, kHeaderSizeAt);
        put_u32(bytes, kHeaderSizeAt, static_cast<std::uint32_t>(head - 4));
        const auto after = bytes.begin() + static_cast<std::ptrdiff_t>(head);
        bytes.erase(after - 8, after - 4);
    }
    mend_header(bytes);
    const std::size_t end = find_block(bytes, 3);
    const std::uint32_t size = version == 5 ? 24 : 32;
    put_u32(bytes, end + 8, size);
    bytes.resize(bytes.size() - (40 - size));
    mend_block(bytes, end);
    return bytes;
}

bool same_rounds(const RecordSample& a, const RecordSample& b) {
    return a.tick == b.tick && a.time_s == b.time_s && a.pose_D.position == b.pose_D.position &&
           a.applied_W.force == b.applied_W.force && a.faults == b.faults && a.gate == b.gate;
}

}  // namespace

TEST_CASE("record: every round of every hand is read again, each with its own effects") {
    constexpr std::uint64_t kRounds = 700;
    const auto record = read_record(make_two_bytes(kRounds));
    REQUIRE(record);
    CHECK(record->header.more_hands == make_two_hands().more_hands);
    REQUIRE(record->samples.size() == kRounds);
    REQUIRE(record->more_hands.size() == 1);
    REQUIRE(record->more_hands[0].samples.size() == kRounds - 5);
    const auto second = find_hand(*record, 1);
    REQUIRE(second);
    CHECK(second->header.effects == std::vector<std::string>{"contact", "texture", "brake"});
    CHECK(second->header.max_force_N == 2.5);
    CHECK(second->header.max_torque_Nm == 0.1);
    for (std::uint64_t i = 0; i < kRounds - 5; ++i) {
        REQUIRE(same_rounds(second->samples[i], make_sample(i + 5 + 1000)));
        const auto shares = second_shares(i + 5);
        for (std::size_t k = 0; k < shares.size(); ++k) {
            REQUIRE(second->shares_of(i)[k].force == shares[k].force);
        }
        REQUIRE(same_rounds(record->samples[i], make_sample(i)));
    }
    // Its device's facts are its own, the run's stay.
    const auto value = [&](const char* name) {
        const auto at = std::ranges::find(second->header.facts, name, &RecordFact::name);
        return at == second->header.facts.end() ? "none" : at->value;
    };
    CHECK(value("device.name") == "a stick");
    CHECK(value("option.seed") == "1");
    CHECK(value("hand 2.device.name") == "none");
    CHECK_FALSE(find_hand(*record, 0));
    CHECK_FALSE(find_hand(*record, 2));
}

TEST_CASE("record: of several hands that was cut off keeps its whole blocks") {
    const auto bytes = make_two_bytes(700);
    for (std::size_t size = u32_at(bytes, kHeaderSizeAt); size < bytes.size(); size += 4099) {
        const auto record = recover_record(std::span(bytes).first(size));
        REQUIRE(record);
        CHECK(record->cut_off);
        CHECK(record->more_hands.size() == 1);
        const auto second = find_hand(*record, 1);
        CHECK(second->shares_W.size() == 3 * second->samples.size());
    }
}

TEST_CASE("record: hands that cannot be are refused, each with its sentence") {
    const auto good = make_two_bytes(20);
    const std::size_t block = find_block(good, 5);
    const auto complaint = [](std::vector<std::byte> bytes, std::size_t at) {
        mend_block(bytes, at);
        return find_complaint(bytes);
    };
    for (const std::uint32_t number : {0U, 2U, 0xFFFFFFFFU}) {
        auto bytes = good;
        put_u32(bytes, block + kBlockHead, number);
        CHECK(complaint(bytes, block).find("a hand that its header has not") != std::string::npos);
    }
    // A block without a whole number, without a sample, or with half of one.
    for (const std::uint32_t size : {0U, 3U, 4U, 4U + 240U, 4U + 384U + 1U}) {
        auto bytes = good;
        const std::size_t was = u32_at(bytes, block + 8);
        bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(block + kBlockHead + size),
                    bytes.begin() + static_cast<std::ptrdiff_t>(block + kBlockHead + was));
        put_u32(bytes, block + 8, size);
        CHECK_FALSE(complaint(bytes, block).empty());
    }
    // The end counts them too.
    const std::size_t end = find_block(good, 3);
    auto bytes = good;
    put_u32(bytes, end + kBlockHead + 24, 14);
    CHECK(complaint(bytes, end).find("other numbers") != std::string::npos);
    // As many hands as there cannot be.
    RecordHeader crowd = make_two_hands();
    crowd.more_hands.resize(9);
    RecordEncoder encoder(crowd);
    encoder.finish();
    CHECK(read_record(encoder.take_bytes())->header.more_hands.size() == kRecordMoreHands);
}

TEST_CASE("record: of versions 6 and 7 is read, and has not what they did not know") {
    for (const std::uint32_t version : {6U, 7U}) {
        const auto record = read_record(as_version(version, make_two_bytes(20)));
        REQUIRE(record);
        CHECK(record->version == version);
        CHECK(record->more_hands[0].samples.size() == 15);
    }
    RecordSample sample = make_sample(1);
    sample.faults = Fault::other_stopped;
    RecordEncoder encoder(make_two_hands());
    encoder.append(sample);
    encoder.finish();
    const auto bytes = encoder.take_bytes();
    REQUIRE(read_record(bytes));
    CHECK(read_record(bytes)->samples[0].faults == Fault::other_stopped);
    CHECK(read_record(as_version(7, bytes)));
    CHECK_FALSE(read_record(as_version(6, bytes)));
    // What loops were told is of later.
    encoder = RecordEncoder(make_two_hands());
    encoder.append(make_sample(1));
    encoder.append(0, Told<ToldReading>{1, {Fault::clutched, true}});
    encoder.finish();
    const auto told = encoder.take_bytes();
    CHECK(read_record(told));
    CHECK(find_complaint(as_version(7, told)).find("unknown kind 6") != std::string::npos);
}

TEST_CASE("record: of version 5, which knew one hand, is read; in one a second hand is none") {
    const auto today = make_bytes(300);
    const auto record = read_record(as_version(5, today));
    REQUIRE(record);
    CHECK(record->version == 5);
    CHECK(record->more_hands.empty());
    const auto now = read_record(today);
    REQUIRE(now);
    REQUIRE(record->samples.size() == now->samples.size());
    CHECK(record->shares_W.size() == now->shares_W.size());
    CHECK(record->events.size() == now->events.size());
    CHECK(record->bodies.size() == now->bodies.size());
    CHECK(same_rounds(record->samples.back(), now->samples.back()));
    auto bytes = as_version(5, today);
    const std::size_t block = find_block(bytes, 1);
    put_u32(bytes, block + 4, 5);
    mend_block(bytes, block);
    CHECK(find_complaint(bytes).find("unknown kind 5") != std::string::npos);
}
