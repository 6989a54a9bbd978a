// table.*, on the raw table: a metamethod that claims a length of a thousand million can't make C++
// loop. `sort` is a merge sort: stable, never quadratic, the same in every run.
#include "runtime/lua/sandbox/safe_library.h"
#include "runtime/lua/sandbox/script_state.h"

#include <algorithm>
#include <bit>

namespace fulcrum::runtime {
namespace {

lua_Integer checked_length(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    return static_cast<lua_Integer>(lua_rawlen(lua, 1));
}

void charge(lua_State* lua, lua_Integer n) {
    ScriptState::of(lua).charge(lua, 1 + static_cast<std::uint64_t>(n > 0 ? n : 0));
}

int table_insert(lua_State* lua) {
    const lua_Integer n = checked_length(lua);
    if (lua_gettop(lua) == 2) {
        lua_rawseti(lua, 1, n + 1);
        return 0;
    }
    if (lua_gettop(lua) != 3) {
        return luaL_error(lua, "table.insert takes a table, a position if you like, and a value");
    }
    const lua_Integer at = luaL_checkinteger(lua, 2);
    luaL_argcheck(lua, at >= 1 && at <= n + 1, 2, "the position is outside the list");
    charge(lua, n - at);
    for (lua_Integer i = n; i >= at; --i) {
        lua_rawgeti(lua, 1, i);
        lua_rawseti(lua, 1, i + 1);
    }
    lua_rawseti(lua, 1, at);
    return 0;
}

int table_remove(lua_State* lua) {
    const lua_Integer n = checked_length(lua);
    const lua_Integer at = luaL_optinteger(lua, 2, n);
    if (lua_gettop(lua) >= 2) {
        luaL_argcheck(lua, (n == 0 && at == 0) || (at >= 1 && at <= n + 1), 2,
                      "the position is outside the list");
    }
    charge(lua, n - at);
    lua_rawgeti(lua, 1, at);
    for (lua_Integer i = at; i < n; ++i) {
        lua_rawgeti(lua, 1, i + 1);
        lua_rawseti(lua, 1, i);
    }
    if (at >= 1 && at <= n) {
        lua_pushnil(lua);
        lua_rawseti(lua, 1, n);
    }
    return 1;
}

int table_concat(lua_State* lua) {
    const lua_Integer n = checked_length(lua);
    std::size_t separator_bytes = 0;
    const char* separator = luaL_optlstring(lua, 2, "", &separator_bytes);
    const lua_Integer first = luaL_optinteger(lua, 3, 1);
    const lua_Integer last = luaL_optinteger(lua, 4, n);
    std::string joined;
    for (lua_Integer i = first; i <= last; ++i) {
        const int kind = lua_rawgeti(lua, 1, i);
        if (kind != LUA_TSTRING && kind != LUA_TNUMBER) {
            return luaL_error(lua, "table.concat joins texts and numbers; item %d is a %s",
                              static_cast<int>(i), luaL_typename(lua, -1));
        }
        std::size_t bytes = 0;
        const char* text = lua_tolstring(lua, -1, &bytes);
        joined.append(text, bytes);
        lua_pop(lua, 1);
        if (i < last) {
            joined.append(separator, separator_bytes);
        }
        if (joined.size() > kMaxStringBytes) {
            return luaL_error(lua, "table.concat would make a text of more than 1 MB");
        }
        charge(lua, 1 + static_cast<lua_Integer>((bytes + separator_bytes) / 16));
        if (i == LUA_MAXINTEGER) {
            break;
        }
    }
    lua_pushlstring(lua, joined.data(), joined.size());
    return 1;
}

int table_unpack(lua_State* lua) {
    const lua_Integer n = checked_length(lua);
    const lua_Integer first = luaL_optinteger(lua, 2, 1);
    const lua_Integer last = luaL_optinteger(lua, 3, n);
    if (first > last) {
        return 0;
    }
    constexpr std::uint64_t kMost = 10'000;
    const std::uint64_t count =
        static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
    if (count >= kMost || lua_checkstack(lua, static_cast<int>(count) + 2) == 0) {
        return luaL_error(lua, "table.unpack gives at most 10000 values");
    }
    charge(lua, static_cast<lua_Integer>(count));
    for (std::uint64_t i = 0; i <= count; ++i) {
        lua_rawgeti(lua, 1, first + static_cast<lua_Integer>(i));
    }
    return static_cast<int>(count) + 1;
}

int table_pack(lua_State* lua) {
    const int n = lua_gettop(lua);
    lua_createtable(lua, n, 1);
    lua_insert(lua, 1);
    for (int i = n; i >= 1; --i) {
        lua_rawseti(lua, 1, i);
    }
    lua_pushinteger(lua, n);
    lua_setfield(lua, 1, "n");
    return 1;
}

int table_move(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    const lua_Integer first = luaL_checkinteger(lua, 2);
    const lua_Integer last = luaL_checkinteger(lua, 3);
    const lua_Integer to = luaL_checkinteger(lua, 4);
    const int target = lua_isnoneornil(lua, 5) ? 1 : 5;
    luaL_checktype(lua, target, LUA_TTABLE);
    if (first <= last) {
        constexpr lua_Integer kMost = 1'000'000;
        luaL_argcheck(lua, first > -kMost && last < kMost && to > -kMost && to < kMost, 3,
                      "more than a million items");
        const lua_Integer n = last - first + 1;
        charge(lua, n);
        // Backwards when the places overlap and the target lies behind.
        const bool backwards = target == 1 && to > first;
        for (lua_Integer k = 0; k < n; ++k) {
            const lua_Integer i = backwards ? n - 1 - k : k;
            lua_rawgeti(lua, 1, first + i);
            lua_rawseti(lua, target, to + i);
        }
    }
    lua_pushvalue(lua, target);
    return 1;
}

// ---- sort: stack 1 list, 2 order or nil, 3 and 4 the two sides of the merge
// ---------------------------------------

/// a < b, for the values at the two indices.
bool comes_before(lua_State* lua, int a, int b) {
    if (lua_isnil(lua, 2)) {
        return lua_compare(lua, a, b, LUA_OPLT) != 0;
    }
    a = lua_absindex(lua, a);
    b = lua_absindex(lua, b);
    lua_pushvalue(lua, 2);
    lua_pushvalue(lua, a);
    lua_pushvalue(lua, b);
    lua_call(lua, 2, 1);
    const bool before = lua_toboolean(lua, -1) != 0;
    lua_pop(lua, 1);
    return before;
}

/// Merges from[low, middle) and from[middle, high) into the other table; places count from 1.
void merge(lua_State* lua, int from, int into, lua_Integer low, lua_Integer middle,
           lua_Integer high) {
    lua_Integer left = low;
    lua_Integer right = middle;
    for (lua_Integer out = low; out < high; ++out) {
        bool take_right = left >= middle;
        if (!take_right && right < high) {
            lua_rawgeti(lua, from, right);
            lua_rawgeti(lua, from, left);
            take_right = comes_before(lua, -2, -1);
            lua_pop(lua, 2);
        }
        lua_rawgeti(lua, from, take_right ? right++ : left++);
        lua_rawseti(lua, into, out);
    }
}

int table_sort(lua_State* lua) {
    const lua_Integer n = checked_length(lua);
    if (!lua_isnoneornil(lua, 2)) {
        luaL_checktype(lua, 2, LUA_TFUNCTION);
    }
    lua_settop(lua, 2);
    constexpr lua_Integer kMost = 1'000'000;
    luaL_argcheck(lua, n <= kMost, 1, "more than a million items");
    charge(lua, n * (2 + static_cast<lua_Integer>(std::bit_width(static_cast<std::uint64_t>(n)))));
    lua_createtable(lua, static_cast<int>(n), 0);
    lua_createtable(lua, static_cast<int>(n), 0);
    for (lua_Integer i = 1; i <= n; ++i) {
        lua_rawgeti(lua, 1, i);
        lua_rawseti(lua, 3, i);
    }
    // Runs of 1, 2, 4 … merged from one table into the other.
    int from = 3;
    for (lua_Integer width = 1; width < n; width *= 2, from = 7 - from) {
        for (lua_Integer low = 1; low <= n; low += 2 * width) {
            merge(lua, from, 7 - from, low, std::min(low + width, n + 1),
                  std::min(low + 2 * width, n + 1));
        }
    }
    for (lua_Integer i = 1; i <= n; ++i) {
        lua_rawgeti(lua, from, i);
        lua_rawseti(lua, 1, i);
    }
    return 0;
}

}  // namespace

void open_safe_table(lua_State* lua) {
    constexpr luaL_Reg kFunctions[] = {{"insert", table_insert}, {"remove", table_remove},
                                       {"concat", table_concat}, {"unpack", table_unpack},
                                       {"pack", table_pack},     {"move", table_move},
                                       {"sort", table_sort},     {nullptr, nullptr}};
    luaL_newlib(lua, kFunctions);
    lua_setglobal(lua, "table");
}

}  // namespace fulcrum::runtime
