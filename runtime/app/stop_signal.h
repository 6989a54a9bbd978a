// The emergency stop from outside: `fulcrum stop` on this computer, which whoever is nearest can type, and a switch that runs it.
//
//   every Fulcrum of this user that drives a hand hears SIGUSR1: the haptic loop is told in the signal's handler itself, so that a
//   window or a lesson that hangs changes nothing; and the arm's side likewise
//   once nothing is left of the force a thread of its own gives the process another name, NAME!n after n signals: that is its word.
//   One that moves no hand just then, or has ended, has no force either
// Found by what they are, not by a file that might be left over: processes of this user, for root of anybody, of this program, that
// have said that they can be stopped (they are called kStoppableName, and have a handler). One that the system has halted hears it
// when it goes on; its arm has faded by then.
//
// Thread: `watch_for_stop_signal` before threads start; `set_stop_target`, `stop_signals_seen` any.
// Source: signal-safety(7): lock-free atomics and sem_post alone in the handler; proc(5): /proc/PID/status; pidfd_open(2).
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/channels.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace fulcrum::runtime {

inline constexpr const char* kStoppableName = "fulcrum-hand";

/// From now on SIGUSR1 is a stop, and other processes may know it.
/// Tests have a name of their own, of at most 13 letters, or they would stop what else runs.
void watch_for_stop_signal(const char* name = kStoppableName);

/// Pressed by the next signals, from the handler, and at once by one that came while there was none. Null where no hand is moved;
/// outlives the next call, after which no handler has it any more.
void set_stop_target(StopSwitch* target) noexcept;

/// How many signals have come.
[[nodiscard]] unsigned stop_signals_seen() noexcept;

/// Which processes are meant.
struct StopWhom {
    std::string name = kStoppableName;
    std::optional<pid_t> only{};      ///< that one alone
    std::string processes = "/proc";  ///< where the system tells of them
    std::chrono::milliseconds patience{500};
};

struct StopOutcome {
    std::size_t n_stopped = 0;  ///< that gave their word, or are gone
    std::vector<pid_t> silent;  ///< that were told, and gave no word in time
};

/// Stops every other process of this user, for root of anybody, that is meant and can be stopped, and waits for their word that no force is
/// left. Fails when one of them could not be reached, and where it cannot even see itself: then nobody knows what runs.
[[nodiscard]] Expected<StopOutcome> stop_all_hands(const StopWhom& whom = {});

}  // namespace fulcrum::runtime
