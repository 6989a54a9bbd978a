#include "haptics/record/record_header.h"

#include "haptics/base/crc32.h"
#include "haptics/record/record_layout.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace fulcrum::record_layout {
namespace {

constexpr const char* kMadeBy = "choose a file made with --record";
constexpr const char* kHeadAgain = "record the run again";

// Magic, version, length; then in each version its own.
constexpr std::size_t kFirstBytes = 16;
constexpr std::size_t kChecksumBytes = 4;
constexpr std::uint32_t kFirstWithLists = 5;  // the first version whose header has lists
constexpr std::uint32_t kFirstWithMoreHands = 6;

void put_list(Sink& sink, const std::vector<std::string>& texts, std::size_t most) {
    const std::size_t n = std::min(texts.size(), most);
    sink.field(static_cast<std::uint32_t>(n));
    for (std::size_t i = 0; i < n; ++i) {
        sink.text(texts[i]);
    }
}

bool take_count(Source& source, std::size_t most, std::uint32_t& n) {
    if (!source.has(sizeof n)) {
        return false;
    }
    source.field(n);
    return n <= most;
}

bool take_text(Source& source, std::string& text) {
    return source.text(text) && is_printable(text);
}

bool take_list(Source& source, std::size_t most, std::vector<std::string>& texts) {
    std::uint32_t n = 0;
    if (!take_count(source, most, n)) {
        return false;
    }
    texts.resize(n);
    return std::all_of(texts.begin(), texts.end(),
                       [&](std::string& text) { return take_text(source, text); });
}

bool take_facts(Source& source, std::vector<RecordFact>& facts) {
    std::uint32_t n = 0;
    if (!take_count(source, kRecordFacts, n)) {
        return false;
    }
    facts.resize(n);
    return std::all_of(facts.begin(), facts.end(), [&](RecordFact& fact) {
        return take_text(source, fact.name) && take_text(source, fact.value);
    });
}

bool is_limit(double most) {
    return most >= 0.0 && std::isfinite(most);
}

bool take_limits(Source& source, double& force_N, double& torque_Nm) {
    if (!source.has(2 * sizeof(double))) {
        return false;
    }
    source.field(force_N);
    source.field(torque_Nm);
    return is_limit(force_N) && is_limit(torque_Nm);
}

bool take_hands(Source& source, std::vector<RecordHand>& hands) {
    std::uint32_t n = 0;
    if (!take_count(source, kRecordMoreHands, n)) {
        return false;
    }
    hands.resize(n);
    return std::all_of(hands.begin(), hands.end(), [&](RecordHand& hand) {
        return take_limits(source, hand.max_force_N, hand.max_torque_Nm) &&
               take_list(source, kMostEffects, hand.effects);
    });
}

// All behind magic, version and length, but for the checksum; false where it cannot be.
bool take_new(Source source, std::uint32_t version, RecordHeader& header) {
    if (!source.has(sizeof(double))) {
        return false;
    }
    source.field(header.rate_Hz);
    if (!take_limits(source, header.max_force_N, header.max_torque_Nm)) {
        return false;
    }
    return take_text(source, header.lesson) && take_list(source, kMostEffects, header.effects) &&
           take_list(source, kMaxBodies, header.bodies) && take_facts(source, header.facts) &&
           (version < kFirstWithMoreHands || take_hands(source, header.more_hands)) &&
           !source.has(1);
}

bool take_old(Source source, RecordHeader& header) {
    source.field(header.rate_Hz);
    header.lesson = source.padded_text(kOldLessonBytes);
    return is_printable(header.lesson);
}

}  // namespace

void put_header(const RecordHeader& header, std::vector<std::byte>& bytes) {
    std::vector<std::byte> body;
    Sink sink(body);
    sink.field(header.rate_Hz);
    sink.field(header.max_force_N);
    sink.field(header.max_torque_Nm);
    sink.text(header.lesson);
    put_list(sink, header.effects, kMostEffects);
    put_list(sink, header.bodies, kMaxBodies);
    const std::size_t n = std::min(header.facts.size(), kRecordFacts);
    sink.field(static_cast<std::uint32_t>(n));
    for (std::size_t i = 0; i < n; ++i) {
        sink.text(header.facts[i].name);
        sink.text(header.facts[i].value);
    }
    const std::size_t n_hands = std::min(header.more_hands.size(), kRecordMoreHands);
    sink.field(static_cast<std::uint32_t>(n_hands));
    for (std::size_t i = 0; i < n_hands; ++i) {
        sink.field(header.more_hands[i].max_force_N);
        sink.field(header.more_hands[i].max_torque_Nm);
        put_list(sink, header.more_hands[i].effects, kMostEffects);
    }
    std::vector<std::byte> head;
    Sink first(head);
    for (const std::uint8_t byte : kMagic) {
        first.field(byte);
    }
    first.field(kRecordVersion);
    first.field(static_cast<std::uint32_t>(kFirstBytes + body.size() + kChecksumBytes));
    first.field(compute_crc32(body, compute_crc32(head)));
    // The checksum stands last, over all before it.
    bytes.insert(bytes.end(), head.begin(), head.end() - kChecksumBytes);
    bytes.insert(bytes.end(), body.begin(), body.end());
    bytes.insert(bytes.end(), head.end() - kChecksumBytes, head.end());
}

Expected<Head> read_header(std::span<const std::byte> bytes) {
    if (bytes.size() < kFirstBytes + kChecksumBytes) {
        return fail("this is no Fulcrum record: it is shorter than a record's header", {}, kMadeBy);
    }
    for (std::size_t i = 0; i < kMagic.size(); ++i) {
        if (static_cast<std::uint8_t>(bytes[i]) != kMagic[i]) {
            return fail("this is no Fulcrum record: its first bytes are others", {}, kMadeBy);
        }
    }
    Source source(bytes.subspan(kMagic.size()));
    Head head;
    std::uint32_t size = 0;
    source.field(head.version);
    source.field(size);
    if (head.version < 1 || head.version > kRecordVersion) {
        return fail("the record has version " + std::to_string(head.version) +
                        ", and this program reads versions 1 to " + std::to_string(kRecordVersion),
                    {}, "use the program that made it");
    }
    const bool is_old = head.version < kFirstWithLists;
    if (is_old ? size != kRecordOldHeaderBytes
               : size < kFirstBytes + kChecksumBytes || size > kMostHeaderBytes) {
        return fail("the record's header is damaged: it cannot have this length", {}, kHeadAgain);
    }
    if (bytes.size() < size) {
        return fail("this is no Fulcrum record: it is shorter than its own header", {}, kMadeBy);
    }
    head.n_bytes = size;
    const auto checked = bytes.first(size - kChecksumBytes);
    std::uint32_t checksum = 0;
    Source(bytes.subspan(checked.size())).field(checksum);
    if (checksum != compute_crc32(checked)) {
        return fail("the record's header is damaged: its checksum does not fit", {}, kHeadAgain);
    }
    const Source body(checked.subspan(kFirstBytes));
    const bool is_good =
        is_old ? take_old(body, head.header) : take_new(body, head.version, head.header);
    if (!is_good || !(head.header.rate_Hz >= 1.0 && head.header.rate_Hz <= 100000.0)) {
        return fail("the record's header names an impossible rate, lesson, limit or list", {},
                    kHeadAgain);
    }
    return head;
}

}  // namespace fulcrum::record_layout
