// By what a simulated hand plays a lesson.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace fulcrum::runtime {

/// An arm, or somebody at a desk (simulated_desk.h).
enum class PlayedBy : std::uint8_t { arm, mouse, keyboard, touch, clumsy, idle };
inline constexpr std::array kAllPlayers{PlayedBy::arm,   PlayedBy::mouse,  PlayedBy::keyboard,
                                        PlayedBy::touch, PlayedBy::clumsy, PlayedBy::idle};
/// Of these, the ones who do all that a lesson's test says; the others need only come to the end.
inline constexpr std::array kSkilledPlayers{PlayedBy::arm, PlayedBy::mouse, PlayedBy::keyboard};

/// Who answers by chance.
[[nodiscard]] constexpr bool guesses(PlayedBy by) {
    return by == PlayedBy::clumsy || by == PlayedBy::idle;
}

[[nodiscard]] constexpr std::string_view name_of(PlayedBy by) {
    constexpr std::array<std::string_view, kAllPlayers.size()> kNames{"arm",   "mouse",  "keyboard",
                                                                      "touch", "clumsy", "idle"};
    return kNames[static_cast<std::size_t>(by)];
}

}  // namespace fulcrum::runtime
