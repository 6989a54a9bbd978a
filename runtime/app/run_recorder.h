// The record of one run: every round of the haptic loop, where bodies were, what happened and what was decided in between.
//
// Thread: the lesson loop; the haptic loop fills the ring. What could not be written is told once, by `finish`.
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/contact_lateness.h"
#include "haptics/loop/told_rings.h"
#include "haptics/record/record_writer.h"
#include "runtime/evidence/replay_check.h"
#include "runtime/lesson/session.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

class RunRecorder {
  public:
    /// Makes the file, or says why not, and gives `channels`, of each hand, a ring to fill. Outlives the haptic loops' last round. `forces`:
    /// the names of the lesson's declared ones. Without a file nothing is written.
    [[nodiscard]] static Expected<std::unique_ptr<RunRecorder>> create(
        const std::string& file, const RecordHeader& header,
        std::span<HapticChannels* const> channels, std::vector<std::string> forces = {});
    /// From now on what these channels tell is kept too, for loops that keep their own time; before the loops begin.
    void keep_told(std::span<HapticChannels* const> channels);
    /// The same of one hand.
    [[nodiscard]] static Expected<std::unique_ptr<RunRecorder>> create(
        const std::string& file, const RecordHeader& header, HapticChannels& channels,
        std::vector<std::string> forces = {}) {
        HapticChannels* const one[] = {&channels};
        return create(file, header, one, std::move(forces));
    }
    /// From now on every round of this hand is compared with that of a record of it alone; `header` is of this run.
    void compare_with(std::shared_ptr<const Record> record, const RecordHeader& header,
                      std::size_t hand = 0) {
        hands_[hand]->check.emplace(std::move(record), header);
    }
    /// From now on tells when contact was found too late; null: nothing finds it beside. It outlives the recorder's last frame.
    void watch(const ContactLateness* lateness) noexcept { lateness_ = lateness; }
    /// Null where nothing is compared.
    [[nodiscard]] const ReplayCheck* check(std::size_t hand = 0) const {
        return hand < hands_.size() && hands_[hand]->check ? &*hands_[hand]->check : nullptr;
    }

    /// Keeps what came in with a frame of the lesson.
    void keep_frame(const SessionInput& input);
    /// While no frame comes: what the loops told goes into the file.
    void keep_rounds() { drain(); }
    /// Keeps what the lesson made of it.
    void keep_output(double time_s, const SessionOutput& output, const SessionResult& result);
    /// Keeps that the lesson failed with this sentence.
    void keep_failure(double time_s, const std::string& sentence);
    /// Writes the rest and closes the file; tells the first trouble of the whole run.
    [[nodiscard]] Expected<void> finish();
    /// Rounds, and what they were told, that were lost because the disk was too slow.
    [[nodiscard]] std::uint64_t dropped() const noexcept {
        std::uint64_t n = 0;
        for (const auto& hand : hands_) {
            n += hand->ring.dropped() + (hand->told ? hand->told->dropped() : 0);
        }
        return n;
    }

  private:
    // A hand's rounds, and as they were told last.
    struct Hand {
        RecordRing ring;
        std::unique_ptr<ToldRings> told{};
        std::optional<ReplayCheck> check{};
        GatePhase gate = GatePhase::waiting;
        Fault faults = Fault::none;
    };

    RunRecorder(std::vector<std::string> forces, int n_bodies)
        : forces_(std::move(forces)), n_bodies_(n_bodies) {}
    template <class Part>
    void write(const Part& part);
    void note(const Expected<void>& written);
    void keep(double time_s, RecordEventKind kind, std::int32_t body = kNoBody,
              const std::string& text = {});
    void drain();
    void drain(std::size_t number);
    void keep_bodies(const SessionInput& input);
    void keep_body(double time_s, std::int32_t body, const BodyState& state);
    void keep_effort(double time_s, const ToolEffort& effort);
    void keep_effort(double time_s, const WorldEffort& effort);
    void keep_lateness(double time_s);

    std::vector<std::unique_ptr<Hand>> hands_;
    std::optional<RecordWriter> writer_;
    std::vector<std::string> forces_;
    std::int32_t n_bodies_;
    Expected<void> trouble_{};
    // As it was told last.
    std::int32_t touched_ = kNoBody;
    ToolEffort effort_{};
    WorldEffort world_effort_{};  // likewise
    const ContactLateness* lateness_ = nullptr;
    std::uint64_t n_late_ = 0;
    std::array<BodyState, kMaxBodies> bodies_{};
    std::array<FieldCommand, kMaxFields> fields_{};
    bool finished_ = false;
};

}  // namespace fulcrum::runtime
