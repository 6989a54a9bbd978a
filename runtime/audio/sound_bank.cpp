#include "runtime/audio/sound_bank.h"

#include "runtime/audio/synthesis.h"

#include <algorithm>

namespace fulcrum::runtime {

Expected<std::vector<std::string>> checked_names(const SoundSettings& settings) {
    if (!(settings.master_gain >= 0.0 && settings.master_gain <= 1.0)) {
        return fail("the loudness is not between 0 and 1", {}, "set master_gain to 0 to 1");
    }
    const auto known = sound_names();
    if (settings.names.empty()) {
        return std::vector<std::string>(known.begin(), known.end());
    }
    std::vector<std::string> names = settings.names;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const std::string& name : names) {
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            return tl::unexpected(unknown_sound(name));
        }
    }
    return names;
}

Expected<std::vector<BankedSound>> make_bank(const SoundSettings& settings) {
    auto names = checked_names(settings);
    if (!names) {
        return tl::unexpected(names.error());
    }
    std::vector<BankedSound> bank;
    for (std::string& name : *names) {
        auto samples = synthesise(name);
        if (!samples) {
            return tl::unexpected(samples.error());
        }
        bank.push_back({std::move(name), std::move(*samples)});
    }
    return bank;
}

Expected<void> check_play(double gain, double pitch) {
    if (!(gain >= 0.0 && gain <= 1.0)) {
        return fail("the gain of a sound is not between 0 and 1", {}, "use a gain from 0 to 1");
    }
    if (!(pitch >= 0.25 && pitch <= 4.0)) {
        return fail("the pitch of a sound is not between 0.25 and 4", {},
                    "use a pitch from 0.25 to 4");
    }
    return {};
}

Error unknown_sound(std::string_view name) {
    return {"there is no sound named " + std::string(name.substr(0, 40)),
            {},
            "use a name from the list of sounds, for example click"};
}

}  // namespace fulcrum::runtime
