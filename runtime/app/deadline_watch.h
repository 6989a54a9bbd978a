// Is any deadline of a run broken under its virtual clock? What has one, and what breaks it:
//
//   a round of the hands     it comes later than one period after the last, and than the clock has jumped
//   of an effect             likewise, while effects are let run
//   a frame of the lesson    later than its period and one of the hands', while the lesson is let run
//   the line of command      where nothing has been broken for kSettle_s, a loop tells that pose, lesson or world is late, or that a pose,
//                            a wrench or a round of the record got lost
// Real time has no part in it: in real time loops are late by what the machine does, which LiveLoops measures.
//
// Thread: the virtual clock's. Cost: some nanoseconds a round.
#pragma once

#include "haptics/handover/messages.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

enum class Deadline : std::uint8_t { none, hands, effect, frame, command };
[[nodiscard]] constexpr const char* name_of(Deadline deadline) noexcept {
    constexpr const char* kNames[] = {
        "none", "a round of the hands", "a round of what runs beside the hands",
        "a frame of the lesson", "a pose, a wrench, lesson or world that nobody kept back"};
    static_assert(std::size(kNames) == static_cast<std::size_t>(Deadline::command) + 1);
    return kNames[static_cast<std::size_t>(deadline)];
}

/// How long each may take; 0 for what is not there.
struct DeadlinePeriods {
    double hands_s = 0.001;
    double frame_s = 0.0;
    std::vector<double> effects_s;  ///< in their order
};

class DeadlineWatch {
  public:
    /// After what was broken the link is made anew, and loops hear of each other again.
    static constexpr double kSettle_s = 1.5;

    /// Before the first round.
    void begin(DeadlinePeriods periods) {
        periods_ = std::move(periods);
        effects_last_s_.assign(periods_.effects_s.size(), -1.0);
    }

    /// A round of the hands has ended, before which the clock has jumped by `jumped_s`. `quiet_s`: for so long nothing has been broken.
    void hands_stepped(double now_s, double jumped_s, const HapticState& state,
                       double quiet_s) noexcept;
    /// Its last may have been kept back where less than a period has been quiet.
    void passed_frame(double now_s, double quiet_s) noexcept;
    /// Likewise; `effect` as `begin` was told them.
    void passed_effect(std::size_t effect, double now_s, double quiet_s) noexcept;

    [[nodiscard]] std::uint64_t n_met(Deadline what) const noexcept {
        return met_[static_cast<std::size_t>(what)];
    }
    [[nodiscard]] std::uint64_t n_broken() const noexcept { return n_broken_; }
    /// The first that was broken, and when.
    [[nodiscard]] Deadline broken() const noexcept { return broken_; }
    [[nodiscard]] double broken_at_s() const noexcept { return broken_at_s_; }

  private:
    static constexpr std::size_t kDeadlines = static_cast<std::size_t>(Deadline::command) + 1;
    void judge(Deadline what, bool is_met, double now_s) noexcept;
    void passed(Deadline what, double& last_s, double period_s, double now_s,
                double quiet_s) noexcept;

    DeadlinePeriods periods_{};
    double hands_last_s_ = -1.0;
    double frame_last_s_ = -1.0;
    std::vector<double> effects_last_s_;
    std::array<std::uint64_t, kDeadlines> met_{};
    std::uint64_t n_broken_ = 0;
    Deadline broken_ = Deadline::none;
    double broken_at_s_ = -1.0;
};

}  // namespace fulcrum::runtime
