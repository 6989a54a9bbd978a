// Where a script's error is, and its text fit to be a part of our sentence.
//
// Thread: the lesson's process; pure but for the stack that is looked at.
#pragma once

#include "runtime/lua/wire/wire.h"

#include <lua5.4/lua.hpp>

#include <cstddef>
#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// Takes "file:12: " off the front of a message into all of `error`; false where no place is there.
bool split_place(std::string_view text, ScriptError& error);
[[nodiscard]] bool are_same_place(const ScriptError& a, const ScriptError& b);
/// Whether the script runs there, at any of the nearest 64 levels.
[[nodiscard]] bool runs_at(lua_State* lua, const ScriptError& place);
/// Where level `level` of the running script is; empty when that is no Lua function.
[[nodiscard]] ScriptError place_of(lua_State* lua, int level);
/// Where the teacher's own text is: the nearest Lua function that is not of the shared library.
[[nodiscard]] ScriptError place_in_lesson(lua_State* lua);

/// A script's own words within our sentence: one line, and no blanks at its ends.
[[nodiscard]] std::string in_one_line(std::string_view text);
/// A short text fit to be shown: invalid bytes become '?', cut to `max_bytes`.
[[nodiscard]] std::string clean_text(std::string_view text, std::size_t max_bytes);

}  // namespace fulcrum::runtime
