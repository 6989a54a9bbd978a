#include "runtime/lua/safe_library.h"
#include "runtime/lua/script_state.h"

#include <array>
#include <string>

namespace fulcrum::runtime {
namespace {

constexpr std::uint64_t kBytesAnInstruction = 16;
constexpr const char* kLoaded = "fulcrum.loaded";
constexpr std::size_t kMaxPrintedBytes = 500;

/// Calls the original in upvalue 1 after charging for the texts it is given.
int call_charged(lua_State* L) {
    std::uint64_t bytes = 0;
    for (int i = 1; i <= lua_gettop(L); ++i) {
        if (lua_type(L, i) == LUA_TSTRING) {
            bytes += lua_rawlen(L, i);
        }
    }
    ScriptState::of(L).charge(L, 1 + bytes / kBytesAnInstruction);
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

// ---- errors
// -------------------------------------------------------------------------------------------------------

int finish_pcall(lua_State* L, int status, lua_KContext n_below) {
    ScriptState::of(L).running = L;
    ScriptState::of(L).check_spent(L);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_pushboolean(L, 0);
        lua_pushvalue(L, -2);
        return 2;
    }
    return lua_gettop(L) - static_cast<int>(n_below);
}

/// pcall, except that a spent budget goes through it.
int safe_pcall(lua_State* L) {
    luaL_checkany(L, 1);
    lua_pushboolean(L, 1);
    lua_insert(L, 1);
    const int status = lua_pcallk(L, lua_gettop(L) - 2, LUA_MULTRET, 0, 0, &finish_pcall);
    return finish_pcall(L, status, 0);
}

/// setmetatable without __gc: a finalizer runs where no budget stops it.
int safe_setmetatable(lua_State* L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    luaL_argexpected(L, lua_isnil(L, 2) || lua_istable(L, 2), 2, "nil or table");
    if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL) {
        return luaL_error(L, "this table's metatable is protected");
    }
    if (lua_istable(L, 2)) {
        lua_pushliteral(L, "__gc");
        if (lua_rawget(L, 2) != LUA_TNIL) {
            return luaL_error(L, "__gc is not available in lessons");
        }
        lua_pop(L, 1);
    }
    lua_settop(L, 2);
    lua_setmetatable(L, 1);
    return 1;
}

// ---- texts
// --------------------------------------------------------------------------------------------------------

int safe_tostring(lua_State* L) {
    luaL_checkany(L, 1);
    const std::string text = text_of(L, 1);
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

int safe_print(lua_State* L) {
    ScriptState& state = ScriptState::of(L);
    std::string line;
    for (int i = 1; i <= lua_gettop(L); ++i) {
        line += (i > 1 ? "\t" : "") + text_of(L, i);
        if (line.size() > kMaxPrintedBytes) {
            break;
        }
    }
    state.charge(L, 100 + line.size());
    if (state.settings().print) {
        state.settings().print(clean_text(line, kMaxPrintedBytes));
    }
    return 0;
}

// ---- modules
// ------------------------------------------------------------------------------------------------------

/// Asks for the text of a module, runs it, and keeps what it returns.
void run_module(lua_State* L, const char* name) {
    ScriptState& state = ScriptState::of(L);
    const ModuleAnswer answer = state.settings().find_module
                                    ? state.settings().find_module(name)
                                    : ModuleAnswer{false, {}, "there are no modules here"};
    if (!answer.found) {
        raise_in_lesson(L, "require \"" + std::string(name) + "\" failed: " + answer.problem);
    }
    state.load_text(L, answer.source);
    lua_pushstring(L, name);
    lua_call(L, 1, 1);
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        lua_pushboolean(L, 1);
    }
}

int safe_require(lua_State* L) {
    std::size_t n = 0;
    const char* name = luaL_checklstring(L, 1, &n);
    if (!is_name({name, n})) {
        raise_in_lesson(L, std::string("require takes a plain name such as \"story\", not \"") +
                               clean_text({name, n}, 40) + '"');
    }
    lua_settop(L, 1);
    lua_getfield(L, LUA_REGISTRYINDEX, kLoaded);
    if (lua_getfield(L, 2, name) == LUA_TNIL) {
        lua_pop(L, 1);
        // While it is loading it is marked, so that a circle is seen.
        lua_pushboolean(L, 0);
        lua_setfield(L, 2, name);
        run_module(L, name);
        lua_pushvalue(L, -1);
        lua_setfield(L, 2, name);
    } else if (lua_isboolean(L, -1) && lua_toboolean(L, -1) == 0) {
        raise_in_lesson(L,
                        std::string("the module \"") + clean_text(name, 40) + "\" requires itself");
    }
    return 1;
}

}  // namespace

std::string text_of(lua_State* L, int index) {
    index = lua_absindex(L, index);
    if (luaL_callmeta(L, index, "__tostring") != 0) {
        if (lua_type(L, -1) != LUA_TSTRING) {
            luaL_error(L, "__tostring must return a string");
        }
        std::size_t n = 0;
        const char* text = lua_tolstring(L, -1, &n);
        std::string result(text, n);
        lua_pop(L, 1);
        return result;
    }
    switch (lua_type(L, index)) {
        case LUA_TNIL:
        case LUA_TBOOLEAN:
        case LUA_TNUMBER:
        case LUA_TSTRING: {
            std::size_t n = 0;
            const char* text = luaL_tolstring(L, index, &n);
            std::string result(text, n);
            lua_pop(L, 1);
            return result;
        }
        default: {
            std::string result = luaL_typename(L, index);
            if (const int kind = luaL_getmetafield(L, index, "__name"); kind != LUA_TNIL) {
                if (kind == LUA_TSTRING) {
                    result = lua_tostring(L, -1);
                }
                lua_pop(L, 1);
            }
            return result;
        }
    }
}

void keep_charged(lua_State* L, const char* const* names) {
    lua_newtable(L);
    for (; *names != nullptr; ++names) {
        lua_getfield(L, -2, *names);
        lua_pushcclosure(L, &call_charged, 1);
        lua_setfield(L, -2, *names);
    }
}

void open_safe_base(lua_State* L) {
    luaL_requiref(L, LUA_GNAME, luaopen_base, 0);
    static constexpr std::array kKept = {"assert", "error",    "getmetatable", "ipairs",  "next",
                                         "pairs",  "rawequal", "rawget",       "rawlen",  "rawset",
                                         "select", "tonumber", "type",         "_VERSION"};
    lua_newtable(L);
    for (const char* name : kKept) {
        lua_getfield(L, -2, name);
        lua_setfield(L, -2, name);
    }
    constexpr luaL_Reg kOurs[] = {{"pcall", safe_pcall},       {"setmetatable", safe_setmetatable},
                                  {"tostring", safe_tostring}, {"print", safe_print},
                                  {"require", safe_require},   {nullptr, nullptr}};
    luaL_setfuncs(L, kOurs, 0);
    lua_pushvalue(L, -1);
    lua_setfield(L, -2, LUA_GNAME);
    // The table of globals is replaced as a whole: nothing of the original stays reachable.
    lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    lua_newtable(L);
    lua_setfield(L, LUA_REGISTRYINDEX, kLoaded);
    lua_pop(L, 1);
}

void open_safe_library(lua_State* L) {
    open_safe_base(L);
    open_safe_string(L);
    open_safe_table(L);
    open_safe_coroutine(L);
    open_safe_math(L);
    // The originals that were opened on the way are forgotten.
    lua_pushnil(L);
    lua_setfield(L, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
}

}  // namespace fulcrum::runtime
