#include "dialogue/unicode.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <utf8proc.h>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kMostFolded = 3;  // characters, CaseFolding.txt

const utf8proc_uint8_t* bytes_of(std::string_view text) {
    return reinterpret_cast<const utf8proc_uint8_t*>(text.data());
}

bool is_ascii(std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<std::uint8_t>(c) < 0x80; });
}

}  // namespace

Character long_character_at(std::string_view text, std::size_t at) noexcept {
    utf8proc_int32_t code = 0;
    const std::string_view rest = text.substr(at);
    const auto taken =
        utf8proc_iterate(bytes_of(rest), static_cast<utf8proc_ssize_t>(rest.size()), &code);
    return taken > 0 ? Character{static_cast<char32_t>(code), static_cast<std::size_t>(taken), true}
                     : Character{kReplacement, 1, false};
}

void append_utf8(std::string& text, char32_t code) {
    const auto point = static_cast<utf8proc_int32_t>(code);
    if (!utf8proc_codepoint_valid(point)) {
        return;
    }
    std::array<utf8proc_uint8_t, 4> bytes{};
    const auto n = static_cast<std::size_t>(utf8proc_encode_char(point, bytes.data()));
    text.append(reinterpret_cast<const char*>(bytes.data()), n);
}

std::string_view whole_characters(std::string_view text, std::size_t most_bytes) {
    const std::size_t end = std::min(text.size(), most_bytes);
    // One that begins up to three bytes before the end may go on behind it.
    for (std::size_t back = 1; back <= std::min<std::size_t>(end, 3); ++back) {
        if (character_at(text, end - back).bytes > back) {
            return text.substr(0, end - back);
        }
    }
    return text.substr(0, end);
}

std::string composed(std::string_view text) {
    if (is_ascii(text)) {
        return std::string(text);
    }
    utf8proc_uint8_t* made = nullptr;
    const auto n = utf8proc_map(bytes_of(text), static_cast<utf8proc_ssize_t>(text.size()), &made,
                                static_cast<utf8proc_option_t>(UTF8PROC_STABLE | UTF8PROC_COMPOSE));
    const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> owner(made, &std::free);
    return n < 0 ? std::string(text)
                 : std::string(reinterpret_cast<const char*>(made), static_cast<std::size_t>(n));
}

void append_folded(std::string& word, char32_t code) {
    if (code < 0x80) {
        const bool capital = code >= 'A' && code <= 'Z';
        word.push_back(static_cast<char>(capital ? code - 'A' + 'a' : code));
        return;
    }
    std::array<utf8proc_int32_t, kMostFolded> letters{};
    int boundary = 0;
    const auto n = utf8proc_decompose_char(static_cast<utf8proc_int32_t>(code), letters.data(),
                                           kMostFolded, UTF8PROC_CASEFOLD, &boundary);
    for (std::size_t i = 0; i < std::min(static_cast<std::size_t>(n), kMostFolded); ++i) {
        append_utf8(word, static_cast<char32_t>(letters[i]));
    }
}

std::string folded(std::string_view text) {
    std::string all;
    all.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const Character character = character_at(text, at);
        append_folded(all, character.code);
        at += character.bytes;
    }
    return all;
}

char32_t small_letter(char32_t code) noexcept {
    return static_cast<char32_t>(utf8proc_tolower(static_cast<utf8proc_int32_t>(code)));
}

char32_t capital_letter(char32_t code) noexcept {
    return static_cast<char32_t>(utf8proc_toupper(static_cast<utf8proc_int32_t>(code)));
}

int columns_of(char32_t code) noexcept {
    return utf8proc_charwidth(static_cast<utf8proc_int32_t>(code));
}

}  // namespace fulcrum::dialogue
