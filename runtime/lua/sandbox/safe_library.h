// The part of Lua's library that a lesson gets. Everything else is absent: io, os, debug, package,
// load and its kin, xpcall, collectgarbage, string.dump. What stays can't hang, gorge or reach an
// original behind its back.
//
// Thread: that of the state.
#pragma once

#include <lua5.4/lua.hpp>

#include <string>

namespace fulcrum::runtime {

inline constexpr std::size_t kMaxStringBytes =
    1U << 20U;                             ///< longest text that one library call makes
inline constexpr int kMaxCloseDepth = 16;  ///< coroutine.close inside coroutine.close
inline constexpr int kMaxModules = 32;     ///< files that one script may require
/// In the registry: what a file of the shared library is given beside its name; nil where there is nothing.
inline constexpr const char* kLibraryServices = "fulcrum.library";
/// How files of the shared library are shown.
inline constexpr const char* kLibraryFolder = "lib/";

/// Puts the allowed globals into the state of `lua`; called once, protected.
void open_safe_library(lua_State* lua);

// Its parts, each leaving the global table as it should be.
void open_safe_base(lua_State* lua);
void open_safe_string(lua_State* lua);
void open_safe_table(lua_State* lua);
void open_safe_coroutine(lua_State* lua);
void open_safe_math(lua_State* lua);

/// What tostring() gives, without addresses (they differ from run to run). Honours __tostring and
/// __name.
[[nodiscard]] std::string text_of(lua_State* lua, int index);
/// Puts `names` of the table below the top of the stack into a new table, each charging for the
/// length of its texts.
void keep_charged(lua_State* lua, const char* const* names);

}  // namespace fulcrum::runtime
