#include "runtime/text/utf8.h"

#include "dialogue/unicode.h"

namespace fulcrum::runtime {

namespace {

/// Characters that draw nothing, or that turn the direction of others.
bool is_invisible(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0xAD || (c >= 0x200B && c <= 0x200F) ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
           (c >= 0xFE00 && c <= 0xFE0F) || (c >= 0xE000 && c <= 0xF8FF) || c >= 0xE0000;
}

/// Persian and the scripts of India write with them: ZWNJ keeps letters apart, ZWJ joins them.
bool is_joiner(char32_t c) {
    return c == 0x200C || c == 0x200D;
}

/// The text ends in a letter of a script that has joiners: Arabic and those behind it, to the Khmer.
bool joins_letters(const std::u32string& text) {
    return !text.empty() && text.back() >= 0x600 && text.back() < 0x1880;
}

}  // namespace

std::u32string decode_for_display(std::string_view utf8) {
    std::u32string text;
    for (std::size_t at = 0; at < utf8.size() && text.size() < kMostCodePoints;) {
        const auto [c, bytes, valid] = dialogue::character_at(utf8, at);
        at += bytes;
        if (c == U'\t' || c == 0xA0) {
            text.push_back(U' ');
        } else if (c == U'\n' || !is_invisible(c) || (is_joiner(c) && joins_letters(text))) {
            text.push_back(c);
        }
    }
    return text;
}

}  // namespace fulcrum::runtime
