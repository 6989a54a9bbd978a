#include "runtime/audio/null/null_player.h"

#include "runtime/audio/force_sound.h"
#include "runtime/audio/sound_bank.h"

namespace fulcrum::runtime {

Expected<std::unique_ptr<NullPlayer>> NullPlayer::open(const SoundSettings& settings) {
    const auto names = checked_names(settings);
    if (!names) {
        return tl::unexpected(names.error());
    }
    auto player = std::make_unique<NullPlayer>();
    for (const std::string& name : *names) {
        player->plays_[name] = 0;
    }
    return player;
}

Expected<void> NullPlayer::play(std::string_view name, double gain, double pitch) {
    const auto found = plays_.find(name);
    if (found == plays_.end()) {
        return tl::unexpected(unknown_sound(name));
    }
    auto checked = check_play(gain, pitch);
    if (checked) {
        ++found->second;
    }
    return checked;
}

void NullPlayer::set_force_sound(double force_N) {
    force_N_ = audible_force_N(force_N);
}

void NullPlayer::update(double /*dt_s*/) {}

void NullPlayer::stop() {
    force_N_ = 0.0;
}

std::size_t NullPlayer::plays(std::string_view name) const {
    const auto found = plays_.find(name);
    return found == plays_.end() ? 0 : found->second;
}

}  // namespace fulcrum::runtime
