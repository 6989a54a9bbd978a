// string.*: patterns by our own counting matcher; nothing makes a text of more than
// kMaxStringBytes; no dump, no pack.
#include "runtime/lua/sandbox/pattern.h"
#include "runtime/lua/sandbox/safe_library.h"
#include "runtime/lua/sandbox/script_state.h"

#include <algorithm>
#include <cstring>

namespace fulcrum::runtime {
namespace {

std::string_view check_text(lua_State* lua, int index) {
    std::size_t n = 0;
    const char* text = luaL_checklstring(lua, index, &n);
    return {text, n};
}

PatternMatcher make_matcher(lua_State* lua, std::string_view text, std::string_view pattern) {
    return PatternMatcher(text, pattern,
                          [lua](std::size_t steps) { ScriptState::of(lua).charge(lua, steps); });
}

/// Runs `body`; a malformed pattern becomes an error at the teacher's line.
template <class Body>
int with_pattern_errors(lua_State* lua, Body body) {
    std::string problem;
    try {
        return body();
    } catch (const PatternError& error) {
        problem = error.problem;
    }
    raise_in_lesson(lua, problem);
}

/// Pushes capture `i` of a match.
void push_capture(lua_State* lua, const PatternMatcher& matcher, std::string_view text, int i,
                  std::size_t begin, std::size_t end) {
    const PatternCapture caught = matcher.capture(i, begin, end);
    if (caught.is_position) {
        lua_pushinteger(lua, static_cast<lua_Integer>(caught.begin) + 1);
    } else {
        lua_pushlstring(lua, text.data() + caught.begin, caught.length);
    }
}

int push_captures(lua_State* lua, const PatternMatcher& matcher, std::string_view text,
                  std::size_t begin, std::size_t end, bool whole_if_none) {
    const int n = matcher.n_captures() == 0 && whole_if_none ? 1 : matcher.n_captures();
    luaL_checkstack(lua, n, "too many captures");
    for (int i = 0; i < n; ++i) {
        push_capture(lua, matcher, text, i, begin, end);
    }
    return n;
}

/// Where a search begins, from Lua's 1-based, possibly negative argument; npos when beyond the end.
std::size_t start_from(lua_State* lua, int index, std::size_t length) {
    const lua_Integer asked = luaL_optinteger(lua, index, 1);
    const auto n = static_cast<lua_Integer>(length);
    const lua_Integer from = asked > 0 ? asked : (asked == 0 || asked < -n) ? 1 : n + asked + 1;
    return from > n + 1 ? std::string_view::npos : static_cast<std::size_t>(from - 1);
}

/// Plain search; every candidate is charged for.
std::size_t find_plain(lua_State* lua, std::string_view text, std::string_view needle,
                       std::size_t from) {
    ScriptState& state = ScriptState::of(lua);
    for (std::size_t at = from; at + needle.size() <= text.size(); ++at) {
        if (needle.empty()) {
            return at;
        }
        const void* hit = std::memchr(text.data() + at, needle[0], text.size() - at);
        if (hit == nullptr) {
            break;
        }
        const auto found = static_cast<std::size_t>(static_cast<const char*>(hit) - text.data());
        state.charge(lua, 1 + (found - at + needle.size()) / 16);
        if (found + needle.size() > text.size()) {
            break;
        }
        if (std::memcmp(text.data() + found, needle.data(), needle.size()) == 0) {
            return found;
        }
        at = found;
    }
    return std::string_view::npos;
}

int find_or_match(lua_State* lua, bool is_find) {
    const std::string_view text = check_text(lua, 1);
    std::string_view pattern = check_text(lua, 2);
    const std::size_t from = start_from(lua, 3, text.size());
    if (from == std::string_view::npos) {
        lua_pushnil(lua);
        return 1;
    }
    if (is_find && (lua_toboolean(lua, 4) != 0 ||
                    pattern.find_first_of("^$*+?.([%-") == std::string_view::npos)) {
        const std::size_t at = find_plain(lua, text, pattern, from);
        if (at == std::string_view::npos) {
            lua_pushnil(lua);
            return 1;
        }
        const auto begin = static_cast<lua_Integer>(at);
        lua_pushinteger(lua, begin + 1);
        lua_pushinteger(lua, begin + static_cast<lua_Integer>(pattern.size()));
        return 2;
    }
    const bool anchored = pattern.starts_with('^');
    pattern.remove_prefix(anchored ? 1 : 0);
    return with_pattern_errors(lua, [&] {
        PatternMatcher matcher = make_matcher(lua, text, pattern);
        for (std::size_t begin = from; begin <= text.size(); ++begin) {
            if (const auto end = matcher.match_at(begin)) {
                if (!is_find) {
                    return push_captures(lua, matcher, text, begin, *end, true);
                }
                lua_pushinteger(lua, static_cast<lua_Integer>(begin) + 1);
                lua_pushinteger(lua, static_cast<lua_Integer>(*end));
                return 2 + push_captures(lua, matcher, text, begin, *end, false);
            }
            if (anchored) {
                break;
            }
        }
        lua_pushnil(lua);
        return 1;
    });
}

int string_find(lua_State* lua) {
    return find_or_match(lua, true);
}
int string_match(lua_State* lua) {
    return find_or_match(lua, false);
}

/// Upvalues: text, pattern, where to go on, where the last match ended (-1 for none).
int next_match(lua_State* lua) {
    const std::string_view text = check_text(lua, lua_upvalueindex(1));
    const std::string_view pattern = check_text(lua, lua_upvalueindex(2));
    const auto from = static_cast<std::size_t>(lua_tointeger(lua, lua_upvalueindex(3)));
    const lua_Integer last_end = lua_tointeger(lua, lua_upvalueindex(4));
    return with_pattern_errors(lua, [&] {
        PatternMatcher matcher = make_matcher(lua, text, pattern);
        for (std::size_t begin = from; begin <= text.size(); ++begin) {
            const auto end = matcher.match_at(begin);
            if (end && static_cast<lua_Integer>(*end) != last_end) {
                lua_pushinteger(lua, static_cast<lua_Integer>(*end));
                lua_copy(lua, -1, lua_upvalueindex(3));
                lua_replace(lua, lua_upvalueindex(4));
                return push_captures(lua, matcher, text, begin, *end, true);
            }
        }
        return 0;
    });
}

int string_gmatch(lua_State* lua) {
    const std::string_view text = check_text(lua, 1);
    check_text(lua, 2);
    const std::size_t from = start_from(lua, 3, text.size());
    lua_settop(lua, 2);
    lua_pushinteger(lua, from == std::string_view::npos ? static_cast<lua_Integer>(text.size()) + 1
                                                        : static_cast<lua_Integer>(from));
    lua_pushinteger(lua, -1);
    lua_pushcclosure(lua, &next_match, 4);
    return 1;
}

// ---- gsub
// ---------------------------------------------------------------------------------------------------------

/// Appends the replacement text with its %0 to %9 filled in.
void append_template(lua_State* lua, std::string& out, const PatternMatcher& matcher,
                     std::string_view text, std::size_t begin, std::size_t end) {
    const std::string_view replacement = check_text(lua, 3);
    for (std::size_t i = 0; i < replacement.size(); ++i) {
        if (replacement[i] != '%') {
            out += replacement[i];
            continue;
        }
        const char c = ++i < replacement.size() ? replacement[i] : '\0';
        if (c == '%') {
            out += '%';
        } else if (c == '0') {
            out.append(text.substr(begin, end - begin));
        } else if (c >= '1' && c <= '9') {
            push_capture(lua, matcher, text, c - '1', begin, end);
            out.append(check_text(lua, -1));
            lua_pop(lua, 1);
        } else {
            throw PatternError{"'%' in the replacement must be followed by a digit or '%'"};
        }
    }
}

/// Appends what replaces one match: from a text, a table or a function. False or nil keeps the
/// match.
void append_replacement(lua_State* lua, std::string& out, const PatternMatcher& matcher,
                        std::string_view text, std::size_t begin, std::size_t end) {
    const int kind = lua_type(lua, 3);
    if (kind == LUA_TSTRING || kind == LUA_TNUMBER) {
        append_template(lua, out, matcher, text, begin, end);
        return;
    }
    if (kind == LUA_TFUNCTION) {
        lua_pushvalue(lua, 3);
        lua_call(lua, push_captures(lua, matcher, text, begin, end, true), 1);
    } else {
        push_capture(lua, matcher, text, 0, begin, end);
        lua_gettable(lua, 3);
    }
    if (lua_toboolean(lua, -1) == 0) {
        out.append(text.substr(begin, end - begin));
    } else if (lua_isstring(lua, -1) != 0) {
        out.append(check_text(lua, -1));
    } else {
        throw PatternError{std::string("a replacement is a ") + luaL_typename(lua, -1) +
                           ", not a text"};
    }
    lua_pop(lua, 1);
}

int string_gsub(lua_State* lua) {
    const std::string_view text = check_text(lua, 1);
    std::string_view pattern = check_text(lua, 2);
    const int kind = lua_type(lua, 3);
    luaL_argexpected(
        lua,
        kind == LUA_TNUMBER || kind == LUA_TSTRING || kind == LUA_TFUNCTION || kind == LUA_TTABLE,
        3, "string, function or table");
    const lua_Integer most = luaL_optinteger(lua, 4, static_cast<lua_Integer>(text.size()) + 1);
    const bool anchored = pattern.starts_with('^');
    pattern.remove_prefix(anchored ? 1 : 0);
    return with_pattern_errors(lua, [&] {
        PatternMatcher matcher = make_matcher(lua, text, pattern);
        std::string out;
        std::size_t at = 0;
        std::size_t last_end = std::string_view::npos;
        lua_Integer n = 0;
        while (n < most) {
            const auto end = matcher.match_at(at);
            if (end && *end != last_end) {
                ++n;
                append_replacement(lua, out, matcher, text, at, *end);
                at = last_end = *end;
            } else if (at < text.size()) {
                out += text[at++];
            } else {
                break;
            }
            if (out.size() > kMaxStringBytes) {
                throw PatternError{"string.gsub would make a text of more than 1 MB"};
            }
            ScriptState::of(lua).charge(lua, 1);
            if (anchored) {
                break;
            }
        }
        if (at < text.size()) {
            out.append(text.substr(at));
        }
        lua_pushlstring(lua, out.data(), out.size());
        lua_pushinteger(lua, n);
        return 2;
    });
}

// ---- rep and format
// -----------------------------------------------------------------------------------------------

int string_rep(lua_State* lua) {
    const std::string_view text = check_text(lua, 1);
    const lua_Integer n = luaL_checkinteger(lua, 2);
    const std::string_view separator =
        lua_isnoneornil(lua, 3) ? std::string_view() : check_text(lua, 3);
    const std::size_t unit = text.size() + separator.size();
    if (n <= 0 || unit == 0) {
        lua_pushliteral(lua, "");
        return 1;
    }
    if (static_cast<std::uint64_t>(n) > kMaxStringBytes / unit) {
        raise_in_lesson(lua, "string.rep would make a text of more than 1 MB");
    }
    ScriptState::of(lua).charge(lua, 1 + unit * static_cast<std::size_t>(n) / 64);
    luaL_Buffer buffer;
    const std::size_t bytes = unit * static_cast<std::size_t>(n) - separator.size();
    char* out = luaL_buffinitsize(lua, &buffer, bytes);
    for (lua_Integer i = 0; i < n; ++i) {
        out = std::copy(text.begin(), text.end(), out);
        out = i + 1 < n ? std::copy(separator.begin(), separator.end(), out) : out;
    }
    luaL_pushresultsize(&buffer, bytes);
    return 1;
}

/// The original in upvalue 1, after: no %p (addresses differ from run to run), tables and functions
/// as plain words, and a bound on the length.
int string_format(lua_State* lua) {
    const std::string_view format = check_text(lua, 1);
    std::size_t bytes = format.size();
    for (std::size_t i = 0; i + 1 < format.size(); ++i) {
        if (format[i] != '%') {
            continue;
        }
        std::size_t letter = i + 1;
        while (letter < format.size() &&
               std::strchr("-+ #0123456789.", format[letter]) != nullptr &&
               format[letter] != '\0') {
            ++letter;
        }
        if (letter < format.size() && format[letter] == 'p') {
            raise_in_lesson(lua, "string.format has no %p in lessons");
        }
        i = letter;
    }
    for (int i = 2; i <= lua_gettop(lua); ++i) {
        const int kind = lua_type(lua, i);
        if (kind == LUA_TTABLE || kind == LUA_TFUNCTION || kind == LUA_TUSERDATA ||
            kind == LUA_TTHREAD) {
            const std::string text = text_of(lua, i);
            lua_pushlstring(lua, text.data(), text.size());
            lua_replace(lua, i);
        }
        bytes += kind == LUA_TSTRING ? lua_rawlen(lua, i) * 4
                                     : 128;  // %q writes up to 4 characters for one
    }
    if (bytes > 4 * kMaxStringBytes) {
        raise_in_lesson(lua, "string.format would make a text of more than 1 MB");
    }
    ScriptState::of(lua).charge(lua, 4 + bytes / 16);
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

}  // namespace

void open_safe_string(lua_State* lua) {
    luaL_requiref(lua, LUA_STRLIBNAME, luaopen_string, 0);
    static constexpr const char* kKept[] = {"byte",    "char", "len",   "lower",
                                            "reverse", "sub",  "upper", nullptr};
    keep_charged(lua, kKept);
    constexpr luaL_Reg kOurs[] = {{"find", string_find},     {"match", string_match},
                                  {"gmatch", string_gmatch}, {"gsub", string_gsub},
                                  {"rep", string_rep},       {nullptr, nullptr}};
    luaL_setfuncs(lua, kOurs, 0);
    lua_getfield(lua, -2, "format");
    lua_pushcclosure(lua, &string_format, 1);
    lua_setfield(lua, -2, "format");
    // ("x"):rep reaches the same functions; getmetatable("") gives false.
    lua_pushliteral(lua, "");
    lua_getmetatable(lua, -1);
    lua_pushvalue(lua, -3);
    lua_setfield(lua, -2, "__index");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_pop(lua, 2);
    lua_setglobal(lua, LUA_STRLIBNAME);
    lua_pop(lua, 1);
}

}  // namespace fulcrum::runtime
