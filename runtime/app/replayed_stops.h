// What people did to the gates in a run that is repeated: an emergency stop, its lifting, leaving. Each in the round in which it was
// noticed, so that the gates go through the same phases.
//
//   before each round of the hands, of each hand's sample of that round:
//     emergency_stop among its faults      the stop is tapped, whoever pressed it then: a key, the arm's own button; in a record before
//                                          version 7 another hand too
//     stopped before, and no longer        it was lifted: rearm
//     ended among its faults               the run was left: ended
// That the lesson failed is not repeated: it fails again by itself, or does not.
//
// Thread: that of the hands. No allocation after construction. Cost: a comparison a hand.
#pragma once

#include "haptics/base/periodic_task.h"
#include "haptics/handover/channels.h"
#include "haptics/record/record.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace fulcrum::runtime {

class ReplayedStops final : public PeriodicTask {
  public:
    struct Hand {
        std::shared_ptr<const Record> record;  ///< of this hand alone
        HapticChannels* channels = nullptr;
    };
    /// `hands` is the round of all hands, and outlives this.
    ReplayedStops(std::vector<Hand> told, PeriodicTask& hands);

    /// What was done, then the round.
    void step(double now_s) override;
    void silence(double now_s) noexcept override { hands_.silence(now_s); }
    /// What was done until the round at `now_s` alone.
    void repeat(double now_s) noexcept;

  private:
    struct At {
        Hand hand;
        std::size_t next = 0;  // of its samples
        bool was_stopped = false;
    };
    static void repeat(At& at, double time_s) noexcept;

    std::vector<At> told_;
    PeriodicTask& hands_;
    bool started_ = false;
    double offset_s_ = 0.0;  // run's clock minus record's clock
};

}  // namespace fulcrum::runtime
