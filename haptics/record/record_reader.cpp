#include "haptics/record/record.h"
#include "haptics/record/record_layout.h"

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
constexpr std::size_t kMostPayloadBytes = kMostSamplesInBlock * kRecordSampleBytes;
// The last fault that each version knows, oldest first.
constexpr Fault kLastFaults[] = {Fault::device_write, Fault::ended, Fault::too_much_energy,
                                 Fault::clutched};
static_assert(std::size(kLastFaults) == kRecordVersion);
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
    Record&& take() { return std::move(record_); }

  private:
    Problem read_block();
    Problem read_samples(std::span<const std::byte> payload);
    Problem read_events(std::span<const std::byte> payload);
    Problem read_end(std::span<const std::byte> payload);

    std::span<const std::byte> rest_;
    Record record_;
    std::uint32_t known_faults_ = 0;
    bool ended_ = false;
};

bool is_printable(const std::string& text) {
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            return false;
        }
    }
    return true;
}

Expected<void> Reader::read_header() {
    if (rest_.size() < kRecordHeaderBytes) {
        return fail("this is no Fulcrum record: it is shorter than a record's header", {},
                    "choose a file made with --record");
    }
    const auto header = rest_.first(kRecordHeaderBytes);
    for (std::size_t i = 0; i < record_layout::kMagic.size(); ++i) {
        if (static_cast<std::uint8_t>(header[i]) != record_layout::kMagic[i]) {
            return fail("this is no Fulcrum record: its first bytes are others", {},
                        "choose a file made with --record");
        }
    }
    Source source(header.subspan(record_layout::kMagic.size()));
    std::uint32_t version = 0;
    std::uint32_t header_bytes = 0;
    source.field(version);
    source.field(header_bytes);
    if (version < 1 || version > kRecordVersion) {
        return fail("the record has version " + std::to_string(version) +
                        ", and this program reads versions 1 to " + std::to_string(kRecordVersion),
                    {}, "use the program that made it");
    }
    known_faults_ = 2 * static_cast<std::uint32_t>(kLastFaults[version - 1]) - 1;
    source.field(record_.header.rate_Hz);
    record_.header.lesson = source.text(kRecordLessonBytes);
    std::uint32_t checksum = 0;
    source.field(checksum);
    if (header_bytes != kRecordHeaderBytes ||
        checksum != compute_crc32(header.first(kRecordHeaderBytes - 4))) {
        return fail("the record's header is damaged: its checksum does not fit", {}, kRecordAgain);
    }
    if (!(record_.header.rate_Hz >= 1.0 && record_.header.rate_Hz <= 100000.0) ||
        !is_printable(record_.header.lesson)) {
        return fail("the record's header names an impossible rate or lesson", {}, kRecordAgain);
    }
    rest_ = rest_.subspan(kRecordHeaderBytes);
    return {};
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
            return read_samples(payload);
        case BlockKind::events:
            return read_events(payload);
        case BlockKind::end:
            return read_end(payload);
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

Problem Reader::read_samples(std::span<const std::byte> payload) {
    if (payload.empty() || payload.size() % kRecordSampleBytes != 0) {
        return "the record is damaged: a block of samples has no whole number of them";
    }
    Source source(payload);
    const std::size_t before = record_.samples.size();
    for (std::size_t i = 0; i < payload.size() / kRecordSampleBytes; ++i) {
        RecordSample sample;
        std::uint32_t faults = 0;
        std::uint32_t gate = 0;
        record_layout::visit_fields(source, sample, faults, gate);
        const double not_before_s =
            record_.samples.empty() ? -1.0e300 : record_.samples.back().time_s;
        if (!is_possible(sample, not_before_s) || (faults & ~known_faults_) != 0 ||
            gate > static_cast<std::uint32_t>(GatePhase::stopped)) {
            record_.samples.resize(before);
            return "the record holds an impossible sample, number " + std::to_string(before + i);
        }
        sample.faults = static_cast<Fault>(faults);
        sample.gate = static_cast<GatePhase>(gate);
        record_.samples.push_back(sample);
    }
    return {};
}

Problem Reader::read_events(std::span<const std::byte> payload) {
    if (payload.empty() || payload.size() % kRecordEventBytes != 0) {
        return "the record is damaged: a block of events has no whole number of them";
    }
    Source source(payload);
    const std::size_t before = record_.events.size();
    for (std::size_t i = 0; i < payload.size() / kRecordEventBytes; ++i) {
        RecordEvent event;
        std::uint32_t kind = 0;
        source.field(event.time_s);
        source.field(kind);
        source.field(event.body);
        event.text = source.text(kRecordTextBytes);
        if (!std::isfinite(event.time_s) ||
            kind > static_cast<std::uint32_t>(RecordEventKind::failed) || event.body < kNoBody ||
            event.body >= kMaxBodies || !is_printable(event.text)) {
            record_.events.resize(before);
            return "the record holds an impossible event, number " + std::to_string(before + i);
        }
        event.kind = static_cast<RecordEventKind>(kind);
        record_.events.push_back(std::move(event));
    }
    return {};
}

Problem Reader::read_end(std::span<const std::byte> payload) {
    if (payload.size() != record_layout::kEndBytes) {
        return "the record is damaged: its end has a wrong size";
    }
    Source source(payload);
    std::uint64_t n_samples = 0;
    std::uint64_t n_events = 0;
    source.field(n_samples);
    source.field(n_events);
    if (n_samples != record_.samples.size() || n_events != record_.events.size()) {
        return "the record is damaged: it holds other numbers of samples and events than its end "
               "says";
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
    const bool cut_off = reader.read_blocks().has_value();
    Record record = reader.take();
    record.cut_off = cut_off;
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
