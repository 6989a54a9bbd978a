// Ctrl-C and the system's wish that the program end: noted, so that the force fades and files are closed first.
#pragma once

namespace fulcrum::runtime {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag, and writing to a closed pipe is an ordinary error.
void watch_for_interrupts();

/// True once somebody wants the program to end. A second signal ends it at once.
[[nodiscard]] bool interrupted() noexcept;

/// What a program ends with that a signal ended: 128 and the signal's number, 130 after Ctrl-C; 0 before one came.
[[nodiscard]] int interrupt_exit_code() noexcept;

}  // namespace fulcrum::runtime
