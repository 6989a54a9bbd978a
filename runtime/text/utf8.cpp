#include "runtime/text/utf8.h"

#include <cstdint>

namespace fulcrum::runtime {

namespace {

/// Takes one code point off the front; an ill-formed byte is taken alone.
char32_t take_code_point(std::string_view& rest) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(rest[i]); };
    const std::uint8_t first = byte(0);
    std::size_t length = 1;
    char32_t code_point = first;
    char32_t least = 0;
    if (first >= 0xF0 && first <= 0xF4) {
        length = 4;
        code_point = first & 0x07U;
        least = 0x10000;
    } else if (first >= 0xE0 && first <= 0xEF) {
        length = 3;
        code_point = first & 0x0FU;
        least = 0x800;
    } else if (first >= 0xC2 && first <= 0xDF) {
        length = 2;
        code_point = first & 0x1FU;
        least = 0x80;
    } else if (first >= 0x80) {
        code_point = kReplacement;
    }
    bool fine = length <= rest.size();
    for (std::size_t i = 1; fine && i < length; ++i) {
        fine = (byte(i) & 0xC0U) == 0x80U;
        code_point = (code_point << 6U) | (byte(i) & 0x3FU);
    }
    const bool surrogate = code_point >= 0xD800 && code_point <= 0xDFFF;
    if (!fine || code_point < least || code_point > 0x10FFFF || surrogate) {
        length = 1;
        code_point = kReplacement;
    }
    rest.remove_prefix(length);
    return code_point;
}

/// Characters that draw nothing, or that turn the direction of others.
bool is_invisible(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0xAD || (c >= 0x200B && c <= 0x200F) ||
           (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF ||
           (c >= 0xFE00 && c <= 0xFE0F) || (c >= 0xE000 && c <= 0xF8FF) || c >= 0xE0000;
}

}  // namespace

std::u32string decode_for_display(std::string_view utf8) {
    std::u32string text;
    while (!utf8.empty() && text.size() < kMostCodePoints) {
        const char32_t c = take_code_point(utf8);
        if (c == U'\t' || c == 0xA0) {
            text.push_back(U' ');
        } else if (c == U'\n' || !is_invisible(c)) {
            text.push_back(c);
        }
    }
    return text;
}

void append_utf8(std::string& text, char32_t code_point) {
    const auto put = [&text](char32_t byte) { text.push_back(static_cast<char>(byte)); };
    const auto put_rest = [&](int n_left) {
        for (int shift = 6 * (n_left - 1); shift >= 0; shift -= 6) {
            put(0x80U | (code_point >> shift & 0x3FU));
        }
    };
    if (code_point < 0x80) {
        put(code_point);
    } else if (code_point < 0x800) {
        put(0xC0U | code_point >> 6U);
        put_rest(1);
    } else if (code_point < 0x10000) {
        put(0xE0U | code_point >> 12U);
        put_rest(2);
    } else {
        put(0xF0U | code_point >> 18U);
        put_rest(3);
    }
}

}  // namespace fulcrum::runtime
