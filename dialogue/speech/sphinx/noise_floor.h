// How loud a room is in what was said in it.
//
//   room_dB = 10 log10((P - N) / N)      P: mean power of all, N: of the quietest frames
// A learner breathes and closes the lips between sounds, so even what was cut close has frames that hold the room alone.
//
// Thread: pure.  Cost: one pass, and a sort of 30 frames a second.
#pragma once

#include <cstdint>
#include <span>

namespace fulcrum::dialogue {

inline constexpr double kSilentRoom_dB =
    90.0;  ///< where nothing is heard in the quietest frames, or there are none

/// How far the room lies below the voice, 0 to kSilentRoom_dB.
[[nodiscard]] double room_below_voice_dB(std::span<const std::int16_t> sound);

}  // namespace fulcrum::dialogue
