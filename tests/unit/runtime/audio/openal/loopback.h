// A player whose sound is taken out by hand.
#pragma once

#include "runtime/audio/openal/openal_player.h"
#include "tests/unit/runtime/audio/heard.h"

#include <memory>
#include <vector>

namespace fulcrum::runtime::test {

inline std::unique_ptr<LoopbackPlayer> open_loopback(const SoundSettings& settings = {}) {
    auto player = open_openal_loopback(settings);
    REQUIRE(player.has_value());
    return std::move(*player);
}

/// Renders `n` frames of 10 ms, both channels, with an update before each.
inline std::vector<float> run(LoopbackPlayer& player, int n) {
    std::vector<float> all;
    for (int i = 0; i < n; ++i) {
        player.update(kFrame_s);
        const auto part = player.render(kFrame);
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

inline std::vector<float> left_of(Sound both) {
    std::vector<float> left;
    for (std::size_t i = 0; i < both.size(); i += 2) {
        left.push_back(both[i]);
    }
    return left;
}

}  // namespace fulcrum::runtime::test
