// Opens what plays sounds: a sound card, or the null player where there is none.
//
// Thread: that which uses the player. Cost: each named sound is made once (about 2 ms a sound).
#pragma once

#include "runtime/audio/sound_player.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

/// A player, and one sentence for the user when it is a silent one (empty otherwise).
struct OpenedSound {
    std::unique_ptr<SoundPlayer> player;  ///< never null
    std::string notice;
};

/// Opens the default sound card; without one the player is the null player and `notice` says so.
/// Never throws, never writes to the terminal. An unknown name in the settings is an error.
[[nodiscard]] Expected<OpenedSound> open_sound_player(const SoundSettings& settings);

}  // namespace fulcrum::runtime
