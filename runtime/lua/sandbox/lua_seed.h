// The same order of `pairs` in every run.
//
// Lua 5.4 mixes the time of day and addresses into the seed of its string hash, when a state is
// made; the order of `pairs` over names follows from that seed. A lesson must play twice alike, so
// the seed is set to a constant between the moment it is made and the moment the first string is
// hashed: that is at the second block of memory that Lua asks for.
//
// Thread: that of the state being made. Cost: one comparison of a few hundred bytes, once.
// Source: Lua 5.4.4 lstate.c, lua_newstate; lstate.h, global_State.
#pragma once

#include <lua5.4/lua.hpp>

#include <cstddef>

namespace fulcrum::runtime {

/// Sets the seed in `first_block` (the first block that lua_newstate asked for, of `bytes` bytes).
/// The place is found by the pair (allocator, its argument) at the head of the global state. False,
/// and nothing changed, when this is no Lua 5.4.
[[nodiscard]] bool fix_string_seed(std::byte* first_block, std::size_t bytes, lua_Alloc allocator,
                                   void* argument) noexcept;

}  // namespace fulcrum::runtime
