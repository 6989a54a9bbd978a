#include "runtime/lua/wire/wire_limits.h"

#include <array>
#include <string>

namespace fulcrum::runtime {
namespace {

/// Bytes of the character that `text` begins with; 0 when it is malformed or a control character.
std::size_t clean_character_bytes(std::string_view text) {
    const auto lead = static_cast<std::uint8_t>(text[0]);
    if (lead < 0x80) {
        const bool is_control = lead < 0x20 || lead == 0x7F;
        return !is_control || lead == '\n' || lead == '\t' ? 1 : 0;
    }
    // How many bytes follow, and the least code point that needs so many.
    std::size_t n_more = lead >= 0xE0 ? 2 : 1;
    n_more = lead >= 0xF0 ? 3 : n_more;
    constexpr std::array<std::uint32_t, 4> kLeast = {0, 0xA0, 0x800,
                                                     0x10000};  // below 0xA0 are controls
    if (lead < 0xC2 || lead > 0xF4 || text.size() <= n_more) {
        return 0;
    }
    std::uint32_t code = lead & (0x3FU >> n_more);
    for (std::size_t k = 1; k <= n_more; ++k) {
        const auto byte = static_cast<std::uint8_t>(text[k]);
        if ((byte & 0xC0U) != 0x80U) {
            return 0;
        }
        code = code << 6U | (byte & 0x3FU);
    }
    const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code >= kLeast.at(n_more) && code <= 0x10FFFF && !is_surrogate ? n_more + 1 : 0;
}

}  // namespace

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
    while (!text.empty()) {
        const std::size_t n = clean_character_bytes(text);
        if (n == 0) {
            return false;
        }
        text.remove_prefix(n);
    }
    return true;
}

}  // namespace fulcrum::runtime
