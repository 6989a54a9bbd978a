#include "haptics/record/record_writer.h"

#include "haptics/record/record_layout.h"

#include <cerrno>
#include <cstring>
#include <utility>

namespace fulcrum {

using record_layout::BlockKind;
using record_layout::Sink;

RecordEncoder::RecordEncoder(const RecordHeader& header) {
    Sink sink(bytes_);
    for (const std::uint8_t byte : record_layout::kMagic) {
        bytes_.push_back(static_cast<std::byte>(byte));
    }
    sink.field(kRecordVersion);
    sink.field(static_cast<std::uint32_t>(kRecordHeaderBytes));
    sink.field(header.rate_Hz);
    sink.text(header.lesson, kRecordLessonBytes);
    sink.field(compute_crc32(bytes_));
}

void RecordEncoder::append(const RecordSample& sample) {
    Sink sink(samples_);
    auto faults = static_cast<std::uint32_t>(sample.faults);
    auto gate = static_cast<std::uint32_t>(sample.gate);
    record_layout::visit_fields(sink, sample, faults, gate);
    ++n_samples_;
    if (samples_.size() == kRecordBlockSamples * kRecordSampleBytes) {
        close_blocks();
    }
}

void RecordEncoder::append(const RecordEvent& event) {
    Sink sink(events_);
    sink.field(event.time_s);
    sink.field(static_cast<std::uint32_t>(event.kind));
    sink.field(event.body);
    sink.text(event.text, kRecordTextBytes);
    ++n_events_;
}

void RecordEncoder::close_blocks() {
    put_block(static_cast<std::uint32_t>(BlockKind::samples), samples_);
    put_block(static_cast<std::uint32_t>(BlockKind::events), events_);
    samples_.clear();
    events_.clear();
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
    Sink(payload).field(n_samples_);
    Sink(payload).field(n_events_);
    put_block(static_cast<std::uint32_t>(BlockKind::end), payload);
}

std::vector<std::byte> RecordEncoder::take_bytes() {
    return std::exchange(bytes_, {});
}

RecordWriter::RecordWriter(std::string path, std::FILE* file, const RecordHeader& header)
    : path_(std::move(path)), file_(file), encoder_(header) {}

Expected<RecordWriter> RecordWriter::create(const std::string& path, const RecordHeader& header) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
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
    RecordSample sample;
    while (ring.pop(sample)) {
        encoder_.append(sample);
    }
    return write_out();
}

Expected<void> RecordWriter::append(const RecordSample& sample) {
    encoder_.append(sample);
    return write_out();
}

Expected<void> RecordWriter::append(const RecordEvent& event) {
    encoder_.append(event);
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
