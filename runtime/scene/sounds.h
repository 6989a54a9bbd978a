// The sounds that a lesson may ask for. The program makes each of them itself (audio/synthesis.h).
//
// Thread: constants.
#pragma once

#include <array>
#include <string_view>

namespace fulcrum::runtime {

inline constexpr std::array<std::string_view, 13> kSoundNames{
    "catch", "catch_watermelon", "catch_apple", "catch_banana", "catch_egg", "landed", "splat",
    "right", "try_again",        "level_up",    "finish",       "pop",       "click"};

}  // namespace fulcrum::runtime
