#include "runtime/lua/wire/wire_limits.h"

#include "dialogue/unicode.h"

#include <string>

namespace fulcrum::runtime {

bool is_name(std::string_view text) {
    if (text.empty() || text.size() > kMaxNameBytes) {
        return false;
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        const bool joins = (c == '_' || c == '-') && i > 0;
        if (!plain && !joins) {
            return false;
        }
    }
    return true;
}

bool is_hand_file_name(std::string_view text) {
    constexpr std::string_view kEnding = ".lua";
    return text.ends_with(kEnding) && is_name(text.substr(0, text.size() - kEnding.size()));
}

bool is_picture_name(std::string_view text) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    if (text.size() > kMaxNameBytes || text.starts_with('.') || text.starts_with(' ')) {
        return false;
    }
    std::string small(text.size(), ' ');
    for (std::size_t i = 0; i < text.size(); ++i) {
        small[i] = lower(text[i]);
        const char c = small[i];
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (!plain && c != ' ' && c != '_' && c != '-' && c != '.') {
            return false;
        }
    }
    return small.ends_with(".png") || small.ends_with(".jpg") || small.ends_with(".jpeg");
}

bool is_clean_utf8(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
        const auto [code, bytes, valid] = dialogue::character_at(text, at);
        const bool is_control = code < 0x20 || (code >= 0x7F && code < 0xA0);
        if (!valid || (is_control && code != '\n' && code != '\t')) {
            return false;
        }
        at += bytes;
    }
    return true;
}

}  // namespace fulcrum::runtime
