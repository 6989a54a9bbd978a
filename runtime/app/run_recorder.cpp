#include "runtime/app/run_recorder.h"

namespace fulcrum::runtime {
namespace {

RecordEventKind record_kind(WorldEvent::Kind kind) {
    return kind == WorldEvent::Kind::caught ? RecordEventKind::caught : RecordEventKind::landed;
}

}  // namespace

Expected<std::unique_ptr<RunRecorder>> RunRecorder::create(const std::string& file,
                                                           const RecordHeader& header,
                                                           HapticChannels& channels) {
    auto writer = RecordWriter::create(file, header);
    if (!writer) {
        return tl::unexpected(writer.error());
    }
    std::unique_ptr<RunRecorder> recorder(new RunRecorder(std::move(*writer)));
    channels.record = &recorder->ring_;
    return recorder;
}

void RunRecorder::note(const Expected<void>& written) {
    if (!written && trouble_) {
        trouble_ = written;
    }
}

void RunRecorder::keep_frame(const SessionInput& input) {
    note(writer_.drain(ring_));
    for (const WorldEvent& event : input.world_events) {
        note(writer_.append(RecordEvent{event.time_s, record_kind(event.kind), event.body, {}}));
    }
    if (input.hand.touched_body != touched_) {
        touched_ = input.hand.touched_body;
        if (touched_ != kNoBody) {
            note(writer_.append(RecordEvent{input.time_s, RecordEventKind::touched, touched_, {}}));
        }
    }
    if (input.heard) {
        note(writer_.append(
            RecordEvent{input.time_s, RecordEventKind::answered, kNoBody, *input.heard}));
    }
}

void RunRecorder::keep_failure(double time_s, const std::string& sentence) {
    note(writer_.append(RecordEvent{time_s, RecordEventKind::failed, kNoBody, sentence}));
}

Expected<void> RunRecorder::finish() {
    note(writer_.drain(ring_));
    note(writer_.finish());
    return trouble_;
}

}  // namespace fulcrum::runtime
