#include "runtime/progress/text_rules.h"

#include "dialogue/unicode.h"

#include <algorithm>
#include <array>

namespace fulcrum::runtime {
namespace {

using dialogue::Character;
using dialogue::character_at;

constexpr std::string_view kReplacementUtf8 = "\xEF\xBF\xBD";

struct Range {
    char32_t first;
    char32_t last;
};

constexpr std::array<Range, 7> kControls{{{0x00, 0x1F},
                                          {0x7F, 0x9F},
                                          {0x061C, 0x061C},
                                          {0x200B, 0x200F},
                                          {0x2028, 0x202E},
                                          {0x2060, 0x206F},
                                          {0xFEFF, 0xFEFF}}};

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

bool is_control(char32_t code) noexcept {
    return std::ranges::any_of(kControls, [code](const Range& range) {
        return code >= range.first && code <= range.last;
    });
}

std::size_t display_width(std::string_view text) noexcept {
    std::size_t width = 0;
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        width += static_cast<std::size_t>(dialogue::columns_of(character.code));
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

std::string folded_nickname(std::string_view nickname) {
    const std::string name = dialogue::folded(dialogue::composed(trimmed(nickname)));
    std::string words;
    for (std::size_t at = 0; at < name.size();) {
        const Character character = character_at(name, at);
        const bool blank = is_blank(character.code);
        words += !blank                 ? std::string_view(name).substr(at, character.bytes)
                 : words.ends_with(' ') ? std::string_view{}
                                        : " ";
        at += character.bytes;
    }
    return dialogue::composed(words);
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
