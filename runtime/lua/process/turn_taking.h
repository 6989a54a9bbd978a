// Two processes that take turns, so that never both are at work, kept on one processor: a sleeping one is then woken where the other
// has just gone to sleep, and no second processor has to be. Half of a lesson's virtual time went into that.
//
//   each kTurns turns:   taken off the processor by others more than kMostTaken times since -> both are let go, to be placed anew
//                        else -> both stay where the one that asks is now
// What each may run on before, it may again when this is gone.
//
// Thread: the one that waits for the other process; its affinity alone is changed. Cost: two system calls each kTurns turns.
// Source: sched_setaffinity(2); getrusage(2), ru_nivcsw of RUSAGE_THREAD.
#pragma once

#include <sched.h>
#include <sys/types.h>

namespace fulcrum::runtime {

class TurnTaking {
  public:
    static constexpr int kTurns = 32;
    static constexpr long kMostTaken = 2;

    /// `other` is waited for; one that is gone changes nothing.
    explicit TurnTaking(pid_t other) noexcept;
    TurnTaking(const TurnTaking&) = delete;
    TurnTaking& operator=(const TurnTaking&) = delete;
    ~TurnTaking();

    /// A turn of both is over.
    void turn() noexcept;
    [[nodiscard]] bool is_together() const noexcept { return is_together_; }

  private:
    void place(const cpu_set_t& where) const noexcept;

    pid_t other_;
    cpu_set_t before_{};
    bool may_ = false;  // the system tells and takes affinities
    bool is_together_ = false;
    int turns_ = 0;
    long taken_;
};

}  // namespace fulcrum::runtime
