// Every sound of the program, made by our own code from a short recipe. Same name, same samples, on
// every machine.
//
// A caught thing sounds as it weighs: the melon a low, full thud that rings on in its hollow, the
// apple a knock, the banana a soft slap, the egg a light bright tick. "try_again" is a friendly
// falling third, never a buzzer.
//
// Thread: any. Cost: 1 to 5 ms a sound.
#pragma once

#include "haptics/base/error.h"
#include "runtime/audio/waveform.h"

#include <span>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// All names that `synthesise` knows: kSoundNames of scene/sounds.h.
[[nodiscard]] std::span<const std::string_view> sound_names();

/// Makes a sound: mono, 48 kHz, highest magnitude at most kPeak, first and last sample zero. An
/// unknown name is an error.
[[nodiscard]] Expected<std::vector<float>> synthesise(std::string_view name);

/// One second of the force sound, 110 Hz, which repeats without a seam.
[[nodiscard]] std::vector<float> synthesise_force_loop();

}  // namespace fulcrum::runtime
