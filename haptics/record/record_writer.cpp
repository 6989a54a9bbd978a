#include "haptics/record/record_writer.h"

#include "haptics/base/crc32.h"
#include "haptics/record/record_header.h"
#include "haptics/record/record_layout.h"
#include "haptics/record/record_told.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace fulcrum {

using record_layout::BlockKind;
using record_layout::Sink;

namespace {

// Events and bodies wait for a block of samples, but no more of them than this: a reader takes a block in one piece.
constexpr std::size_t kFullPayload_bytes = std::size_t{1} << 20;

// What a learner did is nobody else's to read or change, in a file that was there before either. Null, and errno.
std::FILE* open_private(const std::string& path) {
    constexpr mode_t kMode = S_IRUSR | S_IWUSR;
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode);
    if (descriptor < 0) {
        return nullptr;
    }
    struct stat about {};
    const bool is_ours = ::fstat(descriptor, &about) == 0 &&
                         (!S_ISREG(about.st_mode) || ::fchmod(descriptor, kMode) == 0);
    std::FILE* const file = is_ours ? ::fdopen(descriptor, "wb") : nullptr;
    if (file == nullptr) {
        const int why = errno;
        ::close(descriptor);
        errno = why;
    }
    return file;
}

}  // namespace

RecordEncoder::RecordEncoder(const RecordHeader& header) {
    hands_.push_back({std::min(header.effects.size(), kMostEffects)});
    for (std::size_t i = 0; i < std::min(header.more_hands.size(), kRecordMoreHands); ++i) {
        hands_.push_back({std::min(header.more_hands[i].effects.size(), kMostEffects)});
    }
    record_layout::put_header(header, bytes_);
}

void RecordEncoder::append(std::size_t number, const RecordSample& sample,
                           std::span<const Wrench> shares_W) {
    if (number >= hands_.size()) {
        return;
    }
    Hand& hand = hands_[number];
    Sink sink(hand.bytes);
    if (number > 0 && hand.n_open == 0) {
        sink.field(static_cast<std::uint32_t>(number));
    }
    auto faults = static_cast<std::uint32_t>(sample.faults);
    auto gate = static_cast<std::uint32_t>(sample.gate);
    record_layout::visit_fields(sink, sample, faults, gate);
    for (std::size_t i = 0; i < hand.n_effects; ++i) {
        const Wrench share_W = i < shares_W.size() ? shares_W[i] : Wrench{};
        record_layout::visit_wrench(sink, share_W);
    }
    ++hand.n_samples;
    if (++hand.n_open == kRecordBlockSamples) {
        close_blocks();
    }
}

void RecordEncoder::append(std::size_t hand, const RecordRound& round) {
    const auto n = std::clamp<std::size_t>(static_cast<std::size_t>(round.shares.n), 0,
                                           round.shares.each_W.size());
    append(hand, round.sample, std::span(round.shares.each_W).first(n));
}

void RecordEncoder::append(const RecordEvent& event) {
    Sink sink(events_);
    sink.field(event.time_s);
    sink.field(static_cast<std::uint32_t>(event.kind));
    sink.field(event.body);
    sink.text(event.text);
    ++n_events_;
    if (events_.size() > kFullPayload_bytes) {
        close_blocks();
    }
}

void RecordEncoder::append(const RecordBody& body) {
    Sink sink(bodies_);
    auto where = static_cast<std::uint32_t>(body.state.where);
    record_layout::visit_fields(sink, body, where);
    ++n_bodies_;
    if (bodies_.size() > kFullPayload_bytes) {
        close_blocks();
    }
}

template <class T>
void RecordEncoder::append(std::size_t number, const Told<T>& told) {
    if (number >= hands_.size()) {
        return;
    }
    std::vector<std::byte>& open = hands_[number].told;
    Sink sink(open);
    if (open.empty()) {
        sink.field(static_cast<std::uint32_t>(number));
    }
    std::vector<std::byte> bytes;
    Sink own(bytes);
    record_layout::visit_told(own, told.value);
    sink.field(told.tick);
    sink.field(static_cast<std::uint32_t>(record_layout::kind_of(told.value)));
    sink.field(static_cast<std::uint32_t>(bytes.size()));
    open.insert(open.end(), bytes.begin(), bytes.end());
    ++n_told_;
    if (open.size() > kFullPayload_bytes) {
        close_blocks();
    }
}

template void RecordEncoder::append(std::size_t, const Told<ForceCommand>&);
template void RecordEncoder::append(std::size_t, const Told<WorldFrame>&);
template void RecordEncoder::append(std::size_t, const Told<AxleOrders>&);
template void RecordEncoder::append(std::size_t, const Told<RigidFrame>&);
template void RecordEncoder::append(std::size_t, const Told<LineState>&);
template void RecordEncoder::append(std::size_t, const Told<ToldReading>&);

void RecordEncoder::close_blocks() {
    for (std::size_t i = 0; i < hands_.size(); ++i) {
        const BlockKind kind = i == 0 ? BlockKind::samples : BlockKind::hand;
        put_block(static_cast<std::uint32_t>(kind), hands_[i].bytes);
        put_block(static_cast<std::uint32_t>(BlockKind::told), hands_[i].told);
        hands_[i].told.clear();
        hands_[i].bytes.clear();
        hands_[i].n_open = 0;
    }
    put_block(static_cast<std::uint32_t>(BlockKind::events), events_);
    put_block(static_cast<std::uint32_t>(BlockKind::bodies), bodies_);
    events_.clear();
    bodies_.clear();
}

void RecordEncoder::put_block(std::uint32_t kind, const std::vector<std::byte>& payload) {
    if (payload.empty()) {
        return;
    }
    std::vector<std::byte> head;
    Sink(head).field(kind);
    Sink(head).field(static_cast<std::uint32_t>(payload.size()));
    Sink sink(bytes_);
    sink.field(record_layout::kBlockMagic);
    bytes_.insert(bytes_.end(), head.begin(), head.end());
    sink.field(compute_crc32(payload, compute_crc32(head)));
    bytes_.insert(bytes_.end(), payload.begin(), payload.end());
}

void RecordEncoder::finish() {
    close_blocks();
    std::vector<std::byte> payload;
    Sink(payload).field(hands_.front().n_samples);
    Sink(payload).field(n_events_);
    Sink(payload).field(n_bodies_);
    std::uint64_t n_others = 0;
    for (std::size_t i = 1; i < hands_.size(); ++i) {
        n_others += hands_[i].n_samples;
    }
    Sink(payload).field(n_others);
    Sink(payload).field(n_told_);
    put_block(static_cast<std::uint32_t>(BlockKind::end), payload);
}

std::vector<std::byte> RecordEncoder::take_bytes() {
    return std::exchange(bytes_, {});
}

RecordWriter::RecordWriter(std::string path, std::FILE* file, const RecordHeader& header)
    : path_(std::move(path)), file_(file), encoder_(header) {}

Expected<RecordWriter> RecordWriter::create(const std::string& path, const RecordHeader& header) {
    std::FILE* const file = open_private(path);
    if (file == nullptr) {
        return fail(std::string("the record cannot be written: ") + std::strerror(errno), path,
                    "choose a place that can be written to");
    }
    RecordWriter writer(path, file, header);
    if (auto written = writer.write_out(); !written) {
        return tl::unexpected<Error>(written.error());
    }
    return writer;
}

Expected<void> RecordWriter::drain(RecordRing& ring) {
    RecordRound round;
    while (ring.pop(round)) {
        encoder_.append(round);
    }
    return write_out();
}

Expected<void> RecordWriter::append(std::size_t hand, const RecordRound& round) {
    encoder_.append(hand, round);
    return write_out();
}

Expected<void> RecordWriter::append(const RecordEvent& event) {
    encoder_.append(event);
    return write_out();
}

Expected<void> RecordWriter::append(const RecordBody& body) {
    encoder_.append(body);
    return write_out();
}

Expected<void> RecordWriter::finish() {
    encoder_.finish();
    if (auto written = write_out(); !written) {
        return written;
    }
    if (std::fclose(file_.release()) != 0) {
        return fail(std::string("the record's end cannot be written: ") + std::strerror(errno),
                    path_, "free some space");
    }
    return {};
}

// A block at a time goes to the file and on to the system, so that a crash of this program loses
// none of it.
Expected<void> RecordWriter::write_out() {
    const std::vector<std::byte> bytes = encoder_.take_bytes();
    if (bytes.empty()) {
        return {};
    }
    if (!file_ || std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
        std::fflush(file_.get()) != 0) {
        return fail(std::string("the record cannot be written: ") + std::strerror(errno), path_,
                    "free some space");
    }
    return {};
}

}  // namespace fulcrum
