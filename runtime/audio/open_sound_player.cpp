#include "runtime/audio/open_sound_player.h"

#include "runtime/audio/lasting_player.h"
#include "runtime/audio/null/null_player.h"
#include "runtime/audio/openal/openal_player.h"
#include "runtime/audio/sound_bank.h"

namespace fulcrum::runtime {

Expected<OpenedSound> open_sound_player(const SoundSettings& settings) {
    // Wrong names are the caller's error, whether there is a sound card or not.
    auto silent = NullPlayer::open(settings);
    if (!silent) {
        return tl::unexpected(silent.error());
    }
    auto audible = open_openal_device(settings);
    if (audible) {
        return OpenedSound{
            std::make_unique<LastingPlayer>(std::move(*audible), std::move(*silent),
                                            [settings] { return open_openal_device(settings); }),
            {}};
    }
    return OpenedSound{std::move(*silent), to_sentence(audible.error())};
}

}  // namespace fulcrum::runtime
