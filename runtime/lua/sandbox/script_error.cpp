#include "runtime/lua/sandbox/script_error.h"

#include "dialogue/unicode.h"
#include "runtime/lua/sandbox/safe_library.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>

namespace fulcrum::runtime {

bool split_place(std::string_view text, ScriptError& error) {
    const std::size_t first = text.find(':');
    if (first == std::string_view::npos || first == 0) {
        return false;
    }
    const std::size_t second = text.find(':', first + 1);
    if (second == std::string_view::npos || second + 2 > text.size()) {
        return false;
    }
    const std::string_view digits = text.substr(first + 1, second - first - 1);
    std::int32_t line = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), line);
    if (problem != std::errc{} || end != digits.data() + digits.size() || digits.empty()) {
        return false;
    }
    error.file = clean_text(text.substr(0, first), kMaxNameBytes);
    error.line = std::max(line, 0);
    error.message = text.substr(second + (text[second + 1] == ' ' ? 2 : 1));
    return true;
}

bool are_same_place(const ScriptError& a, const ScriptError& b) {
    return a.file == b.file && a.line == b.line;
}

bool runs_at(lua_State* lua, const ScriptError& place) {
    constexpr int kMostLevels = 64;
    lua_Debug activation{};
    for (int level = 0; level < kMostLevels && lua_getstack(lua, level, &activation) != 0;
         ++level) {
        if (are_same_place(place_of(lua, level), place)) {
            return true;
        }
    }
    return false;
}

std::string in_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool is_blank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!is_blank) {
            line += c;
        } else if (!line.empty() && line.back() != ' ') {
            line += ' ';
        }
    }
    while (!line.empty() && line.back() == ' ') {
        line.pop_back();
    }
    return line;
}

ScriptError place_of(lua_State* lua, int level) {
    lua_Debug activation{};
    ScriptError place;
    if (lua_getstack(lua, level, &activation) != 0 && lua_getinfo(lua, "Sl", &activation) != 0 &&
        activation.currentline > 0) {
        place.file = activation.short_src;
        place.line = activation.currentline;
    }
    return place;
}

ScriptError place_in_lesson(lua_State* lua) {
    constexpr int kMostLevels = 64;
    ScriptError nearest;
    lua_Debug activation{};
    for (int level = 0; level < kMostLevels && lua_getstack(lua, level, &activation) != 0;
         ++level) {
        const ScriptError place = place_of(lua, level);
        if (place.line > 0 && !place.file.starts_with(kLibraryFolder)) {
            return place;
        }
        if (place.line > 0 && nearest.line == 0) {
            nearest = place;
        }
    }
    return nearest;
}

std::string clean_text(std::string_view text, std::size_t max_bytes) {
    std::string clean(dialogue::whole_characters(text, max_bytes));
    if (!is_clean_utf8(clean)) {
        for (char& c : clean) {
            const auto byte = static_cast<std::uint8_t>(c);
            if (byte >= 0x7F || (byte < 0x20 && c != '\n' && c != '\t')) {
                c = '?';
            }
        }
    }
    return clean;
}

}  // namespace fulcrum::runtime
