// The sounds that were asked for, made once, and the checks that every player shares.
#pragma once

#include "haptics/base/error.h"
#include "runtime/audio/sound_player.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// One sound, ready to play.
struct BankedSound {
    std::string name;
    std::vector<float> samples;  ///< mono, kSampleRate_Hz
};

/// The names in the settings, all of them when it names none. An unknown or repeated name and a bad
/// gain are errors.
[[nodiscard]] Expected<std::vector<std::string>> checked_names(const SoundSettings& settings);

/// Makes every named sound.
[[nodiscard]] Expected<std::vector<BankedSound>> make_bank(const SoundSettings& settings);

/// What `play` refuses: a gain outside 0 to 1 or a pitch outside 0.25 to 4.
[[nodiscard]] Expected<void> check_play(double gain, double pitch);

/// The error for a name that was not opened.
[[nodiscard]] Error unknown_sound(std::string_view name);

}  // namespace fulcrum::runtime
