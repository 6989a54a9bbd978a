// Sound through OpenAL: on a sound card, or by loopback into a buffer that a test can look at. No
// OpenAL header is needed to use this one.
//
// Thread: one, the opener's. Voices: kVoices at once; the oldest gives way.
#pragma once

#include "runtime/audio/sound_player.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace fulcrum::runtime {

/// Sounds that can be heard at the same time, besides the force sound.
inline constexpr std::size_t kVoices = 12;

/// A player whose sound is taken out by hand: the same bytes every time.
class LoopbackPlayer : public SoundPlayer {
  public:
    /// The next `n_frames` of sound: left, right, left … (n_frames x 2), 48 kHz.
    [[nodiscard]] virtual std::vector<float> render(std::size_t n_frames) = 0;
};

/// Opens the default sound card. No card is an error; nothing is written to the terminal.
[[nodiscard]] Expected<std::unique_ptr<SoundPlayer>> open_openal_device(
    const SoundSettings& settings);

/// Opens a player that needs no sound card.
[[nodiscard]] Expected<std::unique_ptr<LoopbackPlayer>> open_openal_loopback(
    const SoundSettings& settings);

}  // namespace fulcrum::runtime
