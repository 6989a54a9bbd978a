// Repeats a run whose loops kept their own time: each round of each hand at the time that it had, told what it was told then.
//
//   before round k of a hand:  what it took in it -> its channels;  stop, another hand's stop, lifting, failure, end as its faults tell them
//   the round at the recorded time t_k
//   behind it:  what the loop tells -> those who hear it in this run: world, kite, bodies
// So the forces follow from the record alone, whatever lesson and world do in this run; both go on beside it, for the picture and for what is
// said. A round that the record has not comes a period after the last, told nothing new. A tool that had so much time and no more ended its
// search by the clock; that is not repeated.
//
// Thread: that of the hands. No allocation after construction, but for reading a message of the record.
#pragma once

#include "haptics/base/periodic_task.h"
#include "haptics/handover/channels.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/record.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace fulcrum::runtime {

class ToldReplay final : public PeriodicTask {
  public:
    /// One hand: the loop that is repeated, the channels that it was made with, and those that the rest of this run has in their place.
    struct Hand {
        std::shared_ptr<const Record> record;  ///< of this hand alone
        HapticLoop* loop = nullptr;
        HapticChannels* told = nullptr;
        HapticChannels* heard = nullptr;
    };
    explicit ToldReplay(std::vector<Hand> hands);

    /// The next round of each; `now_s` is this run's clock, of which the loops hear nothing.
    void step(double now_s) noexcept override;
    /// The same rounds, told stage by stage.
    void step_observed(double now_s, StageListener& listener) noexcept;
    void silence(double now_s) noexcept override;
    /// Rounds of the first hand that the record has.
    [[nodiscard]] std::size_t n_rounds() const;

  private:
    struct At {
        Hand hand;
        std::size_t next_sample = 0;
        std::size_t next_told = 0;
        bool was_stopped = false;
        double time_s = 0.0;
    };
    void begin_round(At& at) noexcept;
    void tell(const At& at, const RecordTold& told) noexcept;
    static void pass_on(At& at) noexcept;

    std::vector<At> hands_;
    std::uint64_t tick_ = 0;
};

}  // namespace fulcrum::runtime
