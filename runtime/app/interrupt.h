// Ctrl-C and the system's wish that the program end: noted, so that the force fades and files are closed first.
#pragma once

namespace fulcrum::runtime {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag, and writing to a closed pipe is an ordinary error.
void watch_for_interrupts();

/// True once somebody wants the program to end. A second signal ends it at once.
[[nodiscard]] bool interrupted() noexcept;

}  // namespace fulcrum::runtime
