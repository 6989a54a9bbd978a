// The record of one run: every round of the haptic loop and what happened in between.
//
// Thread: the lesson loop; the haptic loop fills the ring. What could not be written is told once, by `finish`.
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/channels.h"
#include "haptics/record/record_writer.h"
#include "runtime/lesson/session.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

class RunRecorder {
  public:
    /// Makes the file, or says why not, and gives `channels` a ring to fill. Outlives the haptic loop's last round.
    [[nodiscard]] static Expected<std::unique_ptr<RunRecorder>> create(const std::string& file,
                                                                       const RecordHeader& header,
                                                                       HapticChannels& channels);

    /// Keeps what came in with a frame of the lesson.
    void keep_frame(const SessionInput& input);
    /// Keeps that the lesson failed with this sentence.
    void keep_failure(double time_s, const std::string& sentence);
    /// Writes the rest and closes the file; tells the first trouble of the whole run.
    [[nodiscard]] Expected<void> finish();
    /// Rounds that were lost because the disk was too slow.
    [[nodiscard]] std::uint64_t dropped() const noexcept { return ring_.dropped(); }

  private:
    explicit RunRecorder(RecordWriter writer) : writer_(std::move(writer)) {}
    void note(const Expected<void>& written);

    RecordRing ring_;
    RecordWriter writer_;
    Expected<void> trouble_{};
    std::int32_t touched_ = kNoBody;
};

}  // namespace fulcrum::runtime
