#include "haptics/record/record_reader.h"

#include "haptics/base/crc32.h"
#include "haptics/record/record_header.h"
#include "haptics/record/record_layout.h"
#include "haptics/record/record_told.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace fulcrum {
namespace {

using record_layout::BlockKind;
using record_layout::Source;

constexpr std::size_t kMostSamplesInBlock = 65536;
constexpr std::size_t kMostPayloadBytes =
    kMostSamplesInBlock * (kRecordSampleBytes + kMostEffects * kRecordShareBytes);
// The last fault that each version knows, oldest first.
constexpr Fault kLastFaults[] = {Fault::device_write,  Fault::ended,        Fault::too_much_energy,
                                 Fault::clutched,      Fault::clutched,     Fault::clutched,
                                 Fault::other_stopped, Fault::other_stopped};
static_assert(std::size(kLastFaults) == kRecordVersion);
constexpr std::uint32_t kFirstWithShares = 5;  // version whose samples tell what each effect adds
constexpr std::uint32_t kFirstWithHandSamples = 6;
constexpr std::size_t kEventHeadBytes = 16;  // time, kind, body
constexpr double kUnitTolerance = 1.0e-3;
constexpr std::size_t kLargestFile_bytes = std::size_t{2} << 30;

const char* const kRecordAgain = "record the run again";

// What is wrong with the bytes from some place on; nothing when they are good.
using Problem = std::optional<std::string>;

// Reads one record; what it has read so far stays good when a later part is bad.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

    Expected<void> read_header();
    // Reads blocks up to the end; the first problem, or nothing.
    Problem read_blocks();
    Record take();

  private:
    Problem read_block();
    Problem read_samples(std::span<const std::byte> payload, std::size_t n_effects,
                         RecordRounds& rounds) const;
    Problem read_hand(std::span<const std::byte> payload);
    Problem read_told(std::span<const std::byte> payload);
    Problem read_events(std::span<const std::byte> payload);
    Problem read_bodies(std::span<const std::byte> payload);
    Problem read_end(std::span<const std::byte> payload);
    [[nodiscard]] bool is_old() const { return record_.version < kFirstWithShares; }
    [[nodiscard]] bool knows_told() const { return record_.version >= kFirstToldVersion; }
    [[nodiscard]] bool knows_hands() const { return record_.version >= kFirstWithHandSamples; }
    [[nodiscard]] bool take_sample(Source& source, const RecordRounds& before,
                                   RecordSample& sample) const;
    [[nodiscard]] bool take_event(Source& source, RecordEvent& event) const;
    [[nodiscard]] static bool take_body(Source& source, RecordBody& body);

    std::span<const std::byte> rest_;
    Record record_;
    std::uint32_t known_faults_ = 0;
    bool ended_ = false;
};

Expected<void> Reader::read_header() {
    auto head = record_layout::read_header(rest_);
    if (!head) {
        return tl::unexpected<Error>(head.error());
    }
    record_.header = std::move(head->header);
    record_.version = head->version;
    record_.more_hands.resize(record_.header.more_hands.size());
    known_faults_ = 2 * static_cast<std::uint32_t>(kLastFaults[head->version - 1]) - 1;
    rest_ = rest_.subspan(head->n_bytes);
    return {};
}

// Kinds were written one after the other; a loop hears of all in one round.
Record Reader::take() {
    std::ranges::stable_sort(record_.told, {}, &RecordTold::tick);
    for (RecordRounds& rounds : record_.more_hands) {
        std::ranges::stable_sort(rounds.told, {}, &RecordTold::tick);
    }
    return std::move(record_);
}

Problem Reader::read_blocks() {
    while (!ended_) {
        if (Problem problem = read_block()) {
            return problem;
        }
    }
    if (!rest_.empty()) {
        return "the record goes on after its end";
    }
    return {};
}

Problem Reader::read_block() {
    if (rest_.size() < record_layout::kBlockHeadBytes) {
        return "the record is cut off: its end is missing";
    }
    Source source(rest_);
    std::uint32_t magic = 0;
    std::uint32_t kind = 0;
    std::uint32_t size = 0;
    std::uint32_t checksum = 0;
    source.field(magic);
    source.field(kind);
    source.field(size);
    source.field(checksum);
    if (magic != record_layout::kBlockMagic) {
        return "the record is damaged: a block does not begin where one should";
    }
    if (size > kMostPayloadBytes) {
        return "the record is damaged: a block claims " + std::to_string(size) + " bytes";
    }
    if (rest_.size() - record_layout::kBlockHeadBytes < size) {
        return "the record is cut off in the middle of a block";
    }
    const auto payload = rest_.subspan(record_layout::kBlockHeadBytes, size);
    // The checksum covers kind and length (8 bytes after the magic) and the payload.
    if (checksum != compute_crc32(payload, compute_crc32(rest_.subspan(4, 8)))) {
        return "the record is damaged: a block's checksum does not fit";
    }
    rest_ = rest_.subspan(record_layout::kBlockHeadBytes + size);
    switch (static_cast<BlockKind>(kind)) {
        case BlockKind::samples:
            return read_samples(payload, record_.header.effects.size(), record_);
        case BlockKind::hand:
            if (knows_hands()) {
                return read_hand(payload);
            }
            break;
        case BlockKind::told:
            if (knows_told()) {
                return read_told(payload);
            }
            break;
        case BlockKind::events:
            return read_events(payload);
        case BlockKind::end:
            return read_end(payload);
        case BlockKind::bodies:
            if (!is_old()) {
                return read_bodies(payload);
            }
            break;
    }
    return "the record holds a block of the unknown kind " + std::to_string(kind);
}

// A pose and times that a device can have given. Commanded forces may be NaN: that is what a record
// is for.
bool is_possible(const RecordSample& sample, double not_before_s) {
    return std::isfinite(sample.time_s) && std::isfinite(sample.stamp_s) &&
           sample.time_s >= not_before_s && is_finite(sample.pose_D) &&
           std::abs(sample.pose_D.orientation.coeffs().norm() - 1.0) < kUnitTolerance;
}

bool is_body(std::int32_t body) {
    return body >= kNoBody && body < kMaxBodies;
}

// Reads parts of one kind to the end of the payload; where one is not whole, or cannot be, none of them stays.
template <class Part, class Take>
Problem read_parts(std::span<const std::byte> payload, const char* kind, std::vector<Part>& parts,
                   const Take& take) {
    if (payload.empty()) {
        return std::string("the record is damaged: a block has no ") + kind + " in it";
    }
    Source source(payload);
    const std::size_t before = parts.size();
    while (source.has(1)) {
        Part part;
        if (!take(source, part)) {
            const std::size_t bad = parts.size();
            parts.resize(before);
            return std::string("the record holds an impossible ") + kind + ", number " +
                   std::to_string(bad);
        }
        parts.push_back(std::move(part));
    }
    return {};
}

bool Reader::take_sample(Source& source, const RecordRounds& before, RecordSample& sample) const {
    if (!source.has(kRecordSampleBytes)) {
        return false;
    }
    std::uint32_t faults = 0;
    std::uint32_t gate = 0;
    record_layout::visit_fields(source, sample, faults, gate);
    if (is_old()) {
        sample.touched_body = kNoBody;
    }
    sample.faults = static_cast<Fault>(faults);
    sample.gate = static_cast<GatePhase>(gate);
    const double not_before_s = before.samples.empty() ? -1.0e300 : before.samples.back().time_s;
    return is_possible(sample, not_before_s) && (faults & ~known_faults_) == 0 &&
           gate <= static_cast<std::uint32_t>(GatePhase::stopped) && is_body(sample.touched_body);
}

Problem Reader::read_samples(std::span<const std::byte> payload, std::size_t n_effects,
                             RecordRounds& rounds) const {
    const std::size_t before = rounds.samples.size();
    const Problem problem =
        read_parts(payload, "sample", rounds.samples, [&](Source& source, RecordSample& sample) {
            if (!take_sample(source, rounds, sample) ||
                !source.has(n_effects * kRecordShareBytes)) {
                return false;
            }
            for (std::size_t k = 0; k < n_effects; ++k) {
                record_layout::visit_wrench(source, rounds.shares_W.emplace_back());
            }
            return true;
        });
    if (problem) {
        rounds.shares_W.resize(n_effects * before);
    }
    return problem;
}

// Rounds of a hand beside the first.
Problem Reader::read_hand(std::span<const std::byte> payload) {
    std::uint32_t number = 0;
    Source source(payload);
    if (source.has(sizeof number)) {
        source.field(number);
    }
    if (number == 0 || number > record_.more_hands.size()) {
        return "the record is damaged: it tells of a hand that its header has not";
    }
    return read_samples(payload.subspan(sizeof number),
                        record_.header.more_hands[number - 1].effects.size(),
                        record_.more_hands[number - 1]);
}

// What a hand's loop was told. Where one is not whole, or cannot be, none of the block stays.
Problem Reader::read_told(std::span<const std::byte> payload) {
    std::uint32_t number = 0;
    Source source(payload);
    if (!source.has(sizeof number)) {
        return "the record is damaged: it tells of a hand that its header has not";
    }
    source.field(number);
    if (number > record_.more_hands.size()) {
        return "the record is damaged: it tells of a hand that its header has not";
    }
    RecordRounds& rounds = number == 0 ? record_ : record_.more_hands[number - 1];
    const std::size_t begin = rounds.told_bytes.size();
    const auto parts = payload.subspan(sizeof number);
    std::size_t at = 0;
    const Problem problem =
        read_parts(parts, "message", rounds.told, [&](Source& part, RecordTold& told) {
            told.at = begin + at;
            return record_layout::take_told(part, parts, at, told);
        });
    if (!problem) {
        rounds.told_bytes.insert(rounds.told_bytes.end(), parts.begin(), parts.end());
    }
    return problem;
}

// False where the bytes hold no whole event, or an impossible one.
bool Reader::take_event(Source& source, RecordEvent& event) const {
    if (!source.has(kEventHeadBytes + (is_old() ? record_layout::kOldTextBytes : 0))) {
        return false;
    }
    std::uint32_t kind = 0;
    source.field(event.time_s);
    source.field(kind);
    source.field(event.body);
    if (is_old()) {
        event.text = source.padded_text(record_layout::kOldTextBytes);
    } else if (!source.text(event.text)) {
        return false;
    }
    event.kind = static_cast<RecordEventKind>(kind);
    const RecordEventKind last = is_old() ? RecordEventKind::failed : kLastRecordEvent;
    return std::isfinite(event.time_s) && event.kind <= last && is_body(event.body) &&
           record_layout::is_printable(event.text);
}

Problem Reader::read_events(std::span<const std::byte> payload) {
    return read_parts(payload, "event", record_.events, [this](Source& source, RecordEvent& event) {
        return take_event(source, event);
    });
}

bool Reader::take_body(Source& source, RecordBody& body) {
    if (!source.has(kRecordBodyBytes)) {
        return false;
    }
    std::uint32_t where = 0;
    record_layout::visit_fields(source, body, where);
    body.state.where = static_cast<BodyWhere>(where);
    return std::isfinite(body.time_s) && body.body >= 0 && body.body < kMaxBodies &&
           where <= static_cast<std::uint32_t>(BodyWhere::landed);
}

Problem Reader::read_bodies(std::span<const std::byte> payload) {
    return read_parts(payload, "body", record_.bodies, take_body);
}

Problem Reader::read_end(std::span<const std::byte> payload) {
    const std::size_t size = is_old()        ? record_layout::kOldEndBytes
                             : knows_told()  ? record_layout::kEndBytes
                             : knows_hands() ? record_layout::kEndBytesUntold
                                             : record_layout::kEndBytesOfOneHand;
    if (payload.size() != size) {
        return "the record is damaged: its end has a wrong size";
    }
    std::size_t n_others = 0;
    std::size_t n_told = record_.told.size();
    for (const RecordRounds& rounds : record_.more_hands) {
        n_others += rounds.samples.size();
        n_told += rounds.told.size();
    }
    Source source(payload);
    for (const std::size_t n :
         {record_.samples.size(), record_.events.size(), record_.bodies.size(), n_others, n_told}) {
        std::uint64_t told = 0;
        if (source.has(sizeof told)) {
            source.field(told);
        }
        if (told != n) {
            return "the record is damaged: it holds other numbers of samples, events, bodies and "
                   "messages than its end says";
        }
    }
    ended_ = true;
    return {};
}

}  // namespace

Expected<Record> read_record(std::span<const std::byte> bytes) {
    Reader reader(bytes);
    if (auto header = reader.read_header(); !header) {
        return tl::unexpected<Error>(header.error());
    }
    if (Problem problem = reader.read_blocks()) {
        return fail(*problem, {}, kRecordAgain);
    }
    return reader.take();
}

Expected<Record> recover_record(std::span<const std::byte> bytes) {
    Reader reader(bytes);
    if (auto header = reader.read_header(); !header) {
        return tl::unexpected<Error>(header.error());
    }
    const Problem problem = reader.read_blocks();
    Record record = reader.take();
    record.cut_off = problem.has_value();
    record.fault = problem.value_or("");
    return record;
}

Expected<Record> load_record(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                               &std::fclose);
    if (!file) {
        return fail("the record cannot be opened", path, "check the path");
    }
    std::vector<std::byte> bytes;
    std::array<std::byte, 65536> chunk{};
    while (const std::size_t n = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
        bytes.insert(bytes.end(), chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(n));
        if (bytes.size() > kLargestFile_bytes) {
            return fail("the record is larger than 2 GB", path, "choose a shorter run");
        }
    }
    if (std::ferror(file.get()) != 0) {
        return fail("the record cannot be read", path, "check that it is a file");
    }
    Expected<Record> record = recover_record(bytes);
    if (!record) {
        record.error().where = path;
    }
    return record;
}

}  // namespace fulcrum
