// table.*, on the raw table: a metamethod that claims a length of a thousand million can't make C++
// loop. `sort` is a merge sort: stable, never quadratic, the same in every run.
#include "runtime/lua/safe_library.h"
#include "runtime/lua/script_state.h"

#include <algorithm>

#include <bit>

namespace fulcrum::runtime {
namespace {

lua_Integer checked_length(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    return static_cast<lua_Integer>(lua_rawlen(L, 1));
}

void charge(lua_State* L, lua_Integer n) {
    ScriptState::of(L).charge(L, 1 + static_cast<std::uint64_t>(n > 0 ? n : 0));
}

int table_insert(lua_State* L) {
    const lua_Integer n = checked_length(L);
    if (lua_gettop(L) == 2) {
        lua_rawseti(L, 1, n + 1);
        return 0;
    }
    if (lua_gettop(L) != 3) {
        return luaL_error(L, "table.insert takes a table, a position if you like, and a value");
    }
    const lua_Integer at = luaL_checkinteger(L, 2);
    luaL_argcheck(L, at >= 1 && at <= n + 1, 2, "the position is outside the list");
    charge(L, n - at);
    for (lua_Integer i = n; i >= at; --i) {
        lua_rawgeti(L, 1, i);
        lua_rawseti(L, 1, i + 1);
    }
    lua_rawseti(L, 1, at);
    return 0;
}

int table_remove(lua_State* L) {
    const lua_Integer n = checked_length(L);
    const lua_Integer at = luaL_optinteger(L, 2, n);
    if (lua_gettop(L) >= 2) {
        luaL_argcheck(L, (n == 0 && at == 0) || (at >= 1 && at <= n + 1), 2,
                      "the position is outside the list");
    }
    charge(L, n - at);
    lua_rawgeti(L, 1, at);
    for (lua_Integer i = at; i < n; ++i) {
        lua_rawgeti(L, 1, i + 1);
        lua_rawseti(L, 1, i);
    }
    if (at >= 1 && at <= n) {
        lua_pushnil(L);
        lua_rawseti(L, 1, n);
    }
    return 1;
}

int table_concat(lua_State* L) {
    const lua_Integer n = checked_length(L);
    std::size_t separator_bytes = 0;
    const char* separator = luaL_optlstring(L, 2, "", &separator_bytes);
    const lua_Integer first = luaL_optinteger(L, 3, 1);
    const lua_Integer last = luaL_optinteger(L, 4, n);
    std::string joined;
    for (lua_Integer i = first; i <= last; ++i) {
        const int kind = lua_rawgeti(L, 1, i);
        if (kind != LUA_TSTRING && kind != LUA_TNUMBER) {
            return luaL_error(L, "table.concat joins texts and numbers; item %d is a %s",
                              static_cast<int>(i), luaL_typename(L, -1));
        }
        std::size_t bytes = 0;
        const char* text = lua_tolstring(L, -1, &bytes);
        joined.append(text, bytes);
        lua_pop(L, 1);
        if (i < last) {
            joined.append(separator, separator_bytes);
        }
        if (joined.size() > kMaxStringBytes) {
            return luaL_error(L, "table.concat would make a text of more than 1 MB");
        }
        charge(L, 1 + static_cast<lua_Integer>((bytes + separator_bytes) / 16));
        if (i == LUA_MAXINTEGER) {
            break;
        }
    }
    lua_pushlstring(L, joined.data(), joined.size());
    return 1;
}

int table_unpack(lua_State* L) {
    const lua_Integer n = checked_length(L);
    const lua_Integer first = luaL_optinteger(L, 2, 1);
    const lua_Integer last = luaL_optinteger(L, 3, n);
    if (first > last) {
        return 0;
    }
    constexpr std::uint64_t kMost = 10'000;
    const std::uint64_t count =
        static_cast<std::uint64_t>(last) - static_cast<std::uint64_t>(first);
    if (count >= kMost || lua_checkstack(L, static_cast<int>(count) + 2) == 0) {
        return luaL_error(L, "table.unpack gives at most 10000 values");
    }
    charge(L, static_cast<lua_Integer>(count));
    for (std::uint64_t i = 0; i <= count; ++i) {
        lua_rawgeti(L, 1, first + static_cast<lua_Integer>(i));
    }
    return static_cast<int>(count) + 1;
}

int table_pack(lua_State* L) {
    const int n = lua_gettop(L);
    lua_createtable(L, n, 1);
    lua_insert(L, 1);
    for (int i = n; i >= 1; --i) {
        lua_rawseti(L, 1, i);
    }
    lua_pushinteger(L, n);
    lua_setfield(L, 1, "n");
    return 1;
}

int table_move(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    const lua_Integer first = luaL_checkinteger(L, 2);
    const lua_Integer last = luaL_checkinteger(L, 3);
    const lua_Integer to = luaL_checkinteger(L, 4);
    const int target = lua_isnoneornil(L, 5) ? 1 : 5;
    luaL_checktype(L, target, LUA_TTABLE);
    if (first <= last) {
        constexpr lua_Integer kMost = 1'000'000;
        luaL_argcheck(L, first > -kMost && last < kMost && to > -kMost && to < kMost, 3,
                      "more than a million items");
        const lua_Integer n = last - first + 1;
        charge(L, n);
        // Backwards when the places overlap and the target lies behind.
        const bool backwards = target == 1 && to > first;
        for (lua_Integer k = 0; k < n; ++k) {
            const lua_Integer i = backwards ? n - 1 - k : k;
            lua_rawgeti(L, 1, first + i);
            lua_rawseti(L, target, to + i);
        }
    }
    lua_pushvalue(L, target);
    return 1;
}

// ---- sort: stack 1 list, 2 order or nil, 3 and 4 the two sides of the merge
// ---------------------------------------

/// a < b, for the values at the two indices.
bool comes_before(lua_State* L, int a, int b) {
    if (lua_isnil(L, 2)) {
        return lua_compare(L, a, b, LUA_OPLT) != 0;
    }
    a = lua_absindex(L, a);
    b = lua_absindex(L, b);
    lua_pushvalue(L, 2);
    lua_pushvalue(L, a);
    lua_pushvalue(L, b);
    lua_call(L, 2, 1);
    const bool before = lua_toboolean(L, -1) != 0;
    lua_pop(L, 1);
    return before;
}

/// Merges from[low, middle) and from[middle, high) into the other table; places count from 1.
void merge(lua_State* L, int from, int into, lua_Integer low, lua_Integer middle,
           lua_Integer high) {
    lua_Integer left = low;
    lua_Integer right = middle;
    for (lua_Integer out = low; out < high; ++out) {
        bool take_right = left >= middle;
        if (!take_right && right < high) {
            lua_rawgeti(L, from, right);
            lua_rawgeti(L, from, left);
            take_right = comes_before(L, -2, -1);
            lua_pop(L, 2);
        }
        lua_rawgeti(L, from, take_right ? right++ : left++);
        lua_rawseti(L, into, out);
    }
}

int table_sort(lua_State* L) {
    const lua_Integer n = checked_length(L);
    if (!lua_isnoneornil(L, 2)) {
        luaL_checktype(L, 2, LUA_TFUNCTION);
    }
    lua_settop(L, 2);
    constexpr lua_Integer kMost = 1'000'000;
    luaL_argcheck(L, n <= kMost, 1, "more than a million items");
    charge(L, n * (2 + static_cast<lua_Integer>(std::bit_width(static_cast<std::uint64_t>(n)))));
    lua_createtable(L, static_cast<int>(n), 0);
    lua_createtable(L, static_cast<int>(n), 0);
    for (lua_Integer i = 1; i <= n; ++i) {
        lua_rawgeti(L, 1, i);
        lua_rawseti(L, 3, i);
    }
    // Runs of 1, 2, 4 … merged from one table into the other.
    int from = 3;
    for (lua_Integer width = 1; width < n; width *= 2, from = 7 - from) {
        for (lua_Integer low = 1; low <= n; low += 2 * width) {
            merge(L, from, 7 - from, low, std::min(low + width, n + 1),
                  std::min(low + 2 * width, n + 1));
        }
    }
    for (lua_Integer i = 1; i <= n; ++i) {
        lua_rawgeti(L, from, i);
        lua_rawseti(L, 1, i);
    }
    return 0;
}

}  // namespace

void open_safe_table(lua_State* L) {
    constexpr luaL_Reg kFunctions[] = {{"insert", table_insert}, {"remove", table_remove},
                                       {"concat", table_concat}, {"unpack", table_unpack},
                                       {"pack", table_pack},     {"move", table_move},
                                       {"sort", table_sort},     {nullptr, nullptr}};
    luaL_newlib(L, kFunctions);
    lua_setglobal(L, "table");
}

}  // namespace fulcrum::runtime
