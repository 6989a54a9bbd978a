// The emergency stop from outside: `fulcrum stop` on this computer, which whoever is nearest can type, and a switch that runs it.
//
//   every Fulcrum of this user that drives a hand hears SIGUSR1: the haptic loop is told in the signal's handler itself, so that a
//   window or a lesson that hangs changes nothing; and the arm's side likewise
// Found by what they are, not by a file that might be left over: processes of this user, for root of anybody, that have said that
// they can be stopped (their name is kStoppableName). One that the system has halted hears it when it goes on; its arm has faded by then.
//
// Thread: `watch_for_stop_signal` before threads start; `set_stop_target`, `stop_signals_seen` any.
// Source: signal-safety(7): lock-free atomics alone in the handler; proc(5): /proc/PID/status; pidfd_open(2).
#pragma once

#include "haptics/base/error.h"
#include "haptics/handover/channels.h"

#include <cstddef>
#include <optional>
#include <string>
#include <sys/types.h>

namespace fulcrum::runtime {

inline constexpr const char* kStoppableName = "fulcrum-hand";

/// From now on SIGUSR1 is a stop, and other processes may know it.
/// Tests have a name of their own, or they would stop what else runs.
void watch_for_stop_signal(const char* name = kStoppableName);

/// Pressed by the next signals, from the handler, and at once by one that came while there was none. Null for none; outlives the next call,
/// after which no handler has it any more.
void set_stop_target(StopSwitch* target) noexcept;

/// How many signals have come.
[[nodiscard]] unsigned stop_signals_seen() noexcept;

/// Which processes are meant.
struct StopWhom {
    std::string name = kStoppableName;
    std::optional<pid_t> only{};      ///< that one alone
    std::string processes = "/proc";  ///< where the system tells of them
};

/// Stops every other process of this user, for root of anybody, that is meant and can be stopped; how many there were. Fails when one of them
/// could not be reached, and where it cannot even see itself: then nobody knows what runs.
[[nodiscard]] Expected<std::size_t> stop_all_hands(const StopWhom& whom = {});

}  // namespace fulcrum::runtime
