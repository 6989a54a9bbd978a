#include "runtime/lua/process/turn_taking.h"

#include <sys/resource.h>

namespace fulcrum::runtime {
namespace {

constexpr pid_t kMe = 0;

// How often this thread was taken off its processor.
long count_taken() noexcept {
    rusage used{};
    return ::getrusage(RUSAGE_THREAD, &used) == 0 ? used.ru_nivcsw : 0;
}

}  // namespace

TurnTaking::TurnTaking(pid_t other) noexcept : other_(other), taken_(count_taken()) {
    may_ = other > 0 && ::sched_getaffinity(kMe, sizeof before_, &before_) == 0;
}

TurnTaking::~TurnTaking() {
    if (is_together_) {
        place(before_);
    }
}

void TurnTaking::turn() noexcept {
    if (!may_ || ++turns_ % kTurns != 0) {
        return;
    }
    const long taken = count_taken();
    const bool is_crowded = taken - taken_ > kMostTaken;
    taken_ = taken;
    if (is_together_ && is_crowded) {
        place(before_);
        is_together_ = false;
    } else if (!is_together_) {
        cpu_set_t here;
        CPU_ZERO(&here);
        CPU_SET(::sched_getcpu(), &here);
        place(here);
        is_together_ = true;
    }
}

// Where the system refuses it for one of them they wait longer for each other, and nothing else.
void TurnTaking::place(const cpu_set_t& where) const noexcept {
    (void)::sched_setaffinity(kMe, sizeof where, &where);
    (void)::sched_setaffinity(other_, sizeof where, &where);
}

}  // namespace fulcrum::runtime
