// What text may be kept of a learner: nicknames are checked, learners' words are mended so that
// none is lost.
#pragma once

#include "haptics/base/error.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Longest nickname, in characters (Unicode code points).
inline constexpr std::size_t kMaxNicknameCharacters = 40;
/// Longest text that is kept of any field, in bytes: several minutes of speech.
inline constexpr std::size_t kMaxKeptTextBytes = 4000;

/// True for characters that move the cursor, hide or reorder others: C0, C1, line and paragraph
/// separators, zero-width and bidirectional controls.
[[nodiscard]] bool is_control(char32_t code) noexcept;

/// Columns that a terminal uses for it.
[[nodiscard]] std::size_t display_width(std::string_view text) noexcept;

/// The nickname without blanks at its ends. Refuses, in one sentence: empty, more than 40
/// characters, no UTF-8, control characters.
[[nodiscard]] Expected<std::string> checked_nickname(std::string_view nickname);

/// What is the same of all ways to write one nickname: in NFC, capitals of all scripts folded, one blank between its words.
[[nodiscard]] std::string folded_nickname(std::string_view nickname);

/// The text as it is kept: bytes that are no UTF-8 become U+FFFD, control characters become blanks,
/// and it is cut to `kMaxKeptTextBytes` between two characters. Applying it twice changes nothing more.
[[nodiscard]] std::string kept_text(std::string_view text);

}  // namespace fulcrum::runtime
