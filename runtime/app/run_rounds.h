// A round of all hands of a run: their loops, one hand or several, and what a record did or tells between them.
//
// Thread: that of the hands' loops.
#pragma once

#include "haptics/loop/hands_loop.h"
#include "runtime/app/replayed_stops.h"
#include "runtime/app/run_hand.h"
#include "runtime/app/told_replay.h"

#include <memory>
#include <optional>

namespace fulcrum::runtime {

class RunRounds {
  public:
    /// The hands have their loops, and outlive this.
    void build(const RunHands& hands);

    [[nodiscard]] PeriodicTask& task();
    /// The same round, told stage by stage.
    void step(double now_s, StageListener& listener);
    /// When the record ends that the first hand repeats, on the run's clock, which has so many rounds a second.
    [[nodiscard]] std::optional<double> replay_end_s(const Record& record, double rate_hz) const;

  private:
    HapticLoop* one_ = nullptr;             // of the first hand
    std::unique_ptr<HandsLoop> all_;        // null with one hand
    std::unique_ptr<ReplayedStops> stops_;  // around either, where a record is repeated
    std::unique_ptr<ToldReplay> told_;      // instead of those, where one tells all
};

}  // namespace fulcrum::runtime
