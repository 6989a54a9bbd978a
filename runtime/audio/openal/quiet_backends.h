// Keeps sound libraries from writing to the terminal when a machine has no sound card, and asks OpenAL for short periods.
#pragma once

namespace fulcrum::runtime {

/// Once a process, before OpenAL is first used: OpenAL's own log is off unless ALSOFT_LOGLEVEL is
/// set, and ALSA, where OpenAL will load it, gets an error handler that says nothing (its default
/// one prints).
void quieten_backends();

/// Once a process, before OpenAL is first used: the card takes sound in periods of 5 ms, three of them, where OpenAL's own
/// choice is heard 40 to 60 ms late. It reads that from a file only: one in memory, named by ALSOFT_CONF. A user who has set
/// ALSOFT_CONF keeps his.
void ask_for_short_periods();

}  // namespace fulcrum::runtime
