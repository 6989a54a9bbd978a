// Text of all scripts as Unicode has it, by utf8proc: the one decoder of UTF-8. ASCII, which most text is, goes a short way.
//
//   NFC       canonical composition: "e" and a combining acute become "é", so that what looks the same is the same
//   folding   capitals of all scripts alike: "É" is "é", "STRASSE" is "straße"; no language's own rule, so that the Turkish "I" is "i"
//
// Thread: pure functions.  Cost: linear in the text.
// Source: The Unicode Standard 14.0, 2021, table 3-7 (well-formed UTF-8); Annex 15 (NFC); CaseFolding.txt, statuses C and F; Annex 11 (columns).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// What stands for a byte that is no UTF-8.
inline constexpr char32_t kReplacement = 0xFFFD;

/// One character of a text.
struct Character {
    char32_t code = 0;      ///< its code point; kReplacement where it is not valid
    std::size_t bytes = 0;  ///< that it takes, at least 1
    bool valid = true;      ///< false: overlong, surrogate, above U+10FFFF, cut off or a stray byte
};

/// That which is longer than a byte; see `character_at`.
[[nodiscard]] Character long_character_at(std::string_view text, std::size_t at) noexcept;

/// The character at `at`, which must be below `text.size()`.
[[nodiscard]] inline Character character_at(std::string_view text, std::size_t at) noexcept {
    const auto lead = static_cast<std::uint8_t>(text[at]);
    return lead < 0x80 ? Character{lead, 1, true} : long_character_at(text, at);
}

/// Its one to four bytes behind `text`; none for what is no code point, surrogates among them.
void append_utf8(std::string& text, char32_t code);

/// The beginning of `text` of at most so many bytes, without a part of a character at its end.
[[nodiscard]] std::string_view whole_characters(std::string_view text, std::size_t most_bytes);

/// The text in NFC; as it is where it is not UTF-8.
[[nodiscard]] std::string composed(std::string_view text);

/// The character's folded form behind `word`: one to three characters.
void append_folded(std::string& word, char32_t code);

/// The text with each of its characters folded; bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string folded(std::string_view text);

/// The small letter of a capital one by one, else `code` itself.
[[nodiscard]] char32_t small_letter(char32_t code) noexcept;
/// And the other way round.
[[nodiscard]] char32_t capital_letter(char32_t code) noexcept;

/// Columns that a terminal draws it in: 2 for East Asian wide characters and pictures, 0 for combining marks, else 1.
[[nodiscard]] int columns_of(char32_t code) noexcept;

}  // namespace fulcrum::dialogue
