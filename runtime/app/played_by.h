// By what a simulated hand plays a lesson.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum::runtime {

/// An arm, or somebody at a desk (simulated_desk.h).
enum class PlayedBy : std::uint8_t { arm, mouse, keyboard };
inline constexpr std::array kAllPlayers{PlayedBy::arm, PlayedBy::mouse, PlayedBy::keyboard};

[[nodiscard]] constexpr std::string_view name_of(PlayedBy by) {
    constexpr std::array<std::string_view, kAllPlayers.size()> kNames{"arm", "mouse", "keyboard"};
    return kNames[static_cast<std::size_t>(by)];
}

}  // namespace fulcrum::runtime
