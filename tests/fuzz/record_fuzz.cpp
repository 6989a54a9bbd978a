// Any bytes at all as a record: read or refused, never a crash, and what was read can be written and read again. The
// same bytes are tried a second time with their checksums put right, so that mutations reach what those guard.
#include "haptics/base/crc32.h"
#include "haptics/record/record.h"
#include "haptics/record/record_reader.h"
#include "haptics/record/record_writer.h"
#include "tests/fuzz/promise.h"

#include <cstring>

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kBlockHeadBytes = 16;   // mark, kind, length, checksum
constexpr std::size_t kLeastEventBytes = 20;  // without a text
constexpr std::size_t kHeadLengthAt = 12;     // where a header tells its own length

void require_one_sentence(const fulcrum::Error& error) {
    require(!error.message.empty() && to_sentence(error).find('\n') == std::string::npos);
}

Bytes encode(const fulcrum::Record& record) {
    fulcrum::RecordEncoder encoder(record.header);
    for (std::size_t i = 0; i < record.samples.size(); ++i) {
        encoder.append(record.samples[i], record.shares_of(i));
    }
    for (std::size_t hand = 1; hand <= record.more_hands.size(); ++hand) {
        const fulcrum::Record alone = *find_hand(record, hand);
        for (std::size_t i = 0; i < alone.samples.size(); ++i) {
            encoder.append(hand, alone.samples[i], alone.shares_of(i));
        }
    }
    for (const auto& event : record.events) {
        encoder.append(event);
    }
    for (const auto& body : record.bodies) {
        encoder.append(body);
    }
    encoder.finish();
    return encoder.take_bytes();
}

// No more was made of the bytes than they can hold, times run forwards, poses are numbers.
void check_promises(const fulcrum::Record& record, std::size_t n_bytes) {
    require(record.samples.size() * fulcrum::kRecordSampleBytes +
                record.shares_W.size() * fulcrum::kRecordShareBytes +
                record.events.size() * kLeastEventBytes +
                record.bodies.size() * fulcrum::kRecordBodyBytes <=
            n_bytes);
    require(record.shares_W.size() == record.samples.size() * record.header.effects.size());
    double before_s = -HUGE_VAL;
    for (const auto& sample : record.samples) {
        require(std::isfinite(sample.time_s) && sample.time_s >= before_s);
        before_s = sample.time_s;
    }
}

void try_bytes(std::span<const std::byte> bytes) {
    const auto recovered = fulcrum::recover_record(bytes);
    if (!recovered) {
        require_one_sentence(recovered.error());
        require(!fulcrum::read_record(bytes));
        return;
    }
    check_promises(*recovered, bytes.size());
    const auto whole = fulcrum::read_record(bytes);
    if (!whole) {
        require_one_sentence(whole.error());
        return;
    }
    require(!recovered->cut_off && recovered->samples.size() == whole->samples.size() &&
            recovered->events.size() == whole->events.size());
    const Bytes written = encode(*whole);
    const auto again = fulcrum::read_record(written);
    require(again.has_value());
    require(encode(*again) == written);
}

std::uint32_t read_u32(const std::byte* at) {
    std::uint32_t value = 0;
    std::memcpy(&value, at, sizeof value);
    return value;
}

void mend_checksums(Bytes& bytes) {
    const std::span<std::byte> all(bytes);
    const std::size_t head_bytes = bytes.size() < kBlockHeadBytes + sizeof(std::uint32_t)
                                       ? 0
                                       : read_u32(bytes.data() + kHeadLengthAt);
    if (head_bytes < kBlockHeadBytes + sizeof(std::uint32_t) || head_bytes > bytes.size()) {
        return;
    }
    const std::size_t checksum_at = head_bytes - sizeof(std::uint32_t);
    const std::uint32_t head = fulcrum::compute_crc32(all.first(checksum_at));
    std::memcpy(bytes.data() + checksum_at, &head, sizeof head);
    std::size_t at = head_bytes;
    while (bytes.size() - at >= kBlockHeadBytes) {
        const std::size_t length = read_u32(bytes.data() + at + 8);
        if (length > bytes.size() - at - kBlockHeadBytes) {
            return;
        }
        const std::uint32_t block =
            fulcrum::compute_crc32(all.subspan(at + kBlockHeadBytes, length),
                                   fulcrum::compute_crc32(all.subspan(at + 4, 8)));
        std::memcpy(bytes.data() + at + 12, &block, sizeof block);
        at += kBlockHeadBytes + length;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto given = std::as_bytes(std::span(data, size));
    try_bytes(given);
    Bytes mended(given.begin(), given.end());
    mend_checksums(mended);
    try_bytes(mended);
    return 0;
}
