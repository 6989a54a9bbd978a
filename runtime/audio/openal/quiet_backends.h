// Keeps sound libraries from writing to the terminal when a machine has no sound card.
#pragma once

namespace fulcrum::runtime {

/// Once a process, before OpenAL is first used: OpenAL's own log is off unless ALSOFT_LOGLEVEL is
/// set, and ALSA, where OpenAL will load it, gets an error handler that says nothing (its default
/// one prints).
void quieten_backends();

}  // namespace fulcrum::runtime
