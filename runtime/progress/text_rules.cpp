#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <array>

namespace fulcrum::runtime {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr std::string_view kReplacementUtf8 = "\xEF\xBF\xBD";

struct Range {
    char32_t first;
    char32_t last;
};

template <std::size_t N>
bool within(const std::array<Range, N>& ranges, char32_t code) noexcept {
    return std::any_of(ranges.begin(), ranges.end(), [code](const Range& range) {
        return code >= range.first && code <= range.last;
    });
}

constexpr std::array<Range, 7> kControls{{{0x00, 0x1F},
                                          {0x7F, 0x9F},
                                          {0x061C, 0x061C},
                                          {0x200B, 0x200F},
                                          {0x2028, 0x202E},
                                          {0x2060, 0x206F},
                                          {0xFEFF, 0xFEFF}}};

// The blocks of Unicode's East Asian Width W and F that children's names, words and emoji come
// from.
constexpr std::array<Range, 9> kWide{{{0x1100, 0x115F},
                                      {0x2E80, 0x303E},
                                      {0x3041, 0xA4CF},
                                      {0xA960, 0xA97F},
                                      {0xAC00, 0xD7A3},
                                      {0xF900, 0xFAFF},
                                      {0xFE30, 0xFE6F},
                                      {0xFF01, 0xFF60},
                                      {0x1F300, 0x1FAFF}}};

constexpr std::array<Range, 4> kCombining{
    {{0x0300, 0x036F}, {0x1160, 0x11FF}, {0x20D0, 0x20FF}, {0xFE00, 0xFE0F}}};

// Bytes that a first byte announces (0 when it can't be first) and the bits of the code that it
// holds.
struct Lead {
    std::size_t bytes;
    unsigned char bits;
};

Lead lead_of(unsigned char byte) noexcept {
    if (byte < 0x80) {
        return {1, byte};
    }
    if (byte >= 0xC2 && byte < 0xE0) {
        return {2, static_cast<unsigned char>(byte & 0x1FU)};
    }
    if (byte >= 0xE0 && byte < 0xF0) {
        return {3, static_cast<unsigned char>(byte & 0x0FU)};
    }
    if (byte >= 0xF0 && byte < 0xF5) {
        return {4, static_cast<unsigned char>(byte & 0x07U)};
    }
    return {0, 0};
}

bool is_blank(char32_t code) noexcept {
    return code == ' ' || code == 0xA0 || code == 0x3000;
}

// The text without blanks at either end.
std::string_view trimmed(std::string_view text) noexcept {
    std::size_t first = text.size();
    std::size_t end = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        if (!is_blank(character.code)) {
            first = std::min(first, at);
            end = at + character.bytes;
        }
        at += character.bytes;
    }
    return first < end ? text.substr(first, end - first) : std::string_view{};
}

}  // namespace

Character character_at(std::string_view text, std::size_t at) noexcept {
    const Character bad{kReplacement, 1, false};
    const Lead lead = lead_of(static_cast<unsigned char>(text[at]));
    if (lead.bytes == 0 || lead.bytes > text.size() - at) {
        return bad;
    }
    char32_t code = lead.bits;
    for (std::size_t i = 1; i < lead.bytes; ++i) {
        const auto byte = static_cast<unsigned char>(text[at + i]);
        if ((byte & 0xC0U) != 0x80U) {
            return bad;
        }
        code = (code << 6U) | (byte & 0x3FU);
    }
    const bool overlong = (lead.bytes == 3 && code < 0x800) || (lead.bytes == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (overlong || surrogate || code > 0x10FFFF) {
        return bad;
    }
    return {code, lead.bytes, true};
}

bool is_control(char32_t code) noexcept {
    return within(kControls, code);
}

std::size_t display_width(char32_t code) noexcept {
    if (within(kCombining, code)) {
        return 0;
    }
    return within(kWide, code) ? 2 : 1;
}

std::size_t display_width(std::string_view text) noexcept {
    std::size_t width = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        width += display_width(character.code);
        at += character.bytes;
    }
    return width;
}

Expected<std::string> checked_nickname(std::string_view nickname) {
    const std::string_view name = trimmed(nickname);
    if (name.empty()) {
        return fail("the nickname is empty", {}, "give one of 1 to 40 characters");
    }
    std::size_t characters = 0;
    for (std::size_t at = 0; at < name.size();) {
        const Character character = character_at(name, at);
        if (!character.valid) {
            return fail("the nickname is not UTF-8 text", {},
                        "type it again with a UTF-8 keyboard");
        }
        if (is_control(character.code)) {
            return fail("the nickname holds a control character at character " +
                            std::to_string(characters + 1),
                        {}, "use letters, digits and blanks");
        }
        at += character.bytes;
        ++characters;
    }
    if (characters > kMaxNicknameCharacters) {
        return fail("the nickname has " + std::to_string(characters) + " characters", {},
                    "give one of 1 to 40 characters");
    }
    return std::string(name);
}

std::string kept_text(std::string_view text) {
    std::string kept;
    kept.reserve(std::min(text.size(), kMaxKeptTextBytes));
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        std::string_view bytes = text.substr(at, character.bytes);
        if (!character.valid) {
            bytes = kReplacementUtf8;
        } else if (is_control(character.code)) {
            bytes = " ";
        }
        if (kept.size() + bytes.size() > kMaxKeptTextBytes) {
            break;
        }
        kept += bytes;
        at += character.bytes;
    }
    return kept;
}

}  // namespace fulcrum::runtime
