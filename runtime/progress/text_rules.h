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

/// One character of UTF-8 text.
struct Character {
    char32_t code = 0;      ///< Unicode code point; U+FFFD when the bytes are no UTF-8
    std::size_t bytes = 0;  ///< bytes that it took, at least 1
    bool valid = true;      ///< false: overlong, surrogate, above U+10FFFF, cut off or a stray byte
};

/// The character at `at`, which must be below `text.size()`.
[[nodiscard]] Character character_at(std::string_view text, std::size_t at) noexcept;

/// True for characters that move the cursor, hide or reorder others: C0, C1, line and paragraph
/// separators, zero-width and bidirectional controls.
[[nodiscard]] bool is_control(char32_t code) noexcept;

/// Columns that a terminal uses for it: 2 for East Asian wide characters, 0 for combining marks,
/// else 1.
[[nodiscard]] std::size_t display_width(char32_t code) noexcept;
[[nodiscard]] std::size_t display_width(std::string_view text) noexcept;

/// The nickname without blanks at its ends. Refuses, in one sentence: empty, more than 40
/// characters, no UTF-8, control characters.
[[nodiscard]] Expected<std::string> checked_nickname(std::string_view nickname);

/// The text as it is kept: bytes that are no UTF-8 become U+FFFD, control characters become blanks,
/// and it is cut to `kMaxKeptTextBytes` between two characters. Applying it twice changes nothing more.
[[nodiscard]] std::string kept_text(std::string_view text);

}  // namespace fulcrum::runtime
