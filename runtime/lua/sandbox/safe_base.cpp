#include "runtime/lua/sandbox/safe_library.h"
#include "runtime/lua/sandbox/script_state.h"

#include <array>
#include <string>

namespace fulcrum::runtime {
namespace {

constexpr std::uint64_t kPreparedBytesAnInstruction = 16;
constexpr const char* kLoaded = "fulcrum.loaded";
constexpr std::size_t kMaxPrintedBytes = 500;

/// Calls the original in upvalue 1 after charging for the texts it is given.
int call_charged(lua_State* lua) {
    std::uint64_t bytes = 0;
    for (int i = 1; i <= lua_gettop(lua); ++i) {
        if (lua_type(lua, i) == LUA_TSTRING) {
            bytes += lua_rawlen(lua, i);
        }
    }
    ScriptState::of(lua).charge(lua, 1 + bytes / kPreparedBytesAnInstruction);
    return lua_tocfunction(lua, lua_upvalueindex(1))(lua);
}

// ---- errors
// -------------------------------------------------------------------------------------------------------

int finish_pcall(lua_State* lua, int status, lua_KContext n_below) {
    ScriptState::of(lua).running = lua;
    ScriptState::of(lua).check_spent(lua);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_pushboolean(lua, 0);
        lua_pushvalue(lua, -2);
        return 2;
    }
    return lua_gettop(lua) - static_cast<int>(n_below);
}

/// pcall, except that a spent budget goes through it.
int safe_pcall(lua_State* lua) {
    luaL_checkany(lua, 1);
    lua_pushboolean(lua, 1);
    lua_insert(lua, 1);
    const int status = lua_pcallk(lua, lua_gettop(lua) - 2, LUA_MULTRET, 0, 0, &finish_pcall);
    return finish_pcall(lua, status, 0);
}

/// setmetatable without __gc: a finalizer runs where no budget stops it.
int safe_setmetatable(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TTABLE);
    luaL_argexpected(lua, lua_isnil(lua, 2) || lua_istable(lua, 2), 2, "nil or table");
    if (luaL_getmetafield(lua, 1, "__metatable") != LUA_TNIL) {
        return luaL_error(lua, "this table's metatable is protected");
    }
    if (lua_istable(lua, 2)) {
        lua_pushliteral(lua, "__gc");
        if (lua_rawget(lua, 2) != LUA_TNIL) {
            return luaL_error(lua, "__gc is not available in lessons");
        }
        lua_pop(lua, 1);
    }
    lua_settop(lua, 2);
    lua_setmetatable(lua, 1);
    return 1;
}

// ---- texts
// --------------------------------------------------------------------------------------------------------

int safe_tostring(lua_State* lua) {
    luaL_checkany(lua, 1);
    const std::string text = text_of(lua, 1);
    lua_pushlstring(lua, text.data(), text.size());
    return 1;
}

int safe_print(lua_State* lua) {
    ScriptState& state = ScriptState::of(lua);
    std::string line;
    for (int i = 1; i <= lua_gettop(lua); ++i) {
        line += (i > 1 ? "\t" : "") + text_of(lua, i);
        if (line.size() > kMaxPrintedBytes) {
            break;
        }
    }
    state.charge(lua, 100 + line.size());
    if (state.settings().print) {
        state.settings().print(clean_text(line, kMaxPrintedBytes));
    }
    return 0;
}

// ---- modules
// ------------------------------------------------------------------------------------------------------

/// Asks for the text of a module, runs it, and keeps what it returns.
void run_module(lua_State* lua, const char* name) {
    ScriptState& state = ScriptState::of(lua);
    const ModuleAnswer answer = state.settings().find_module
                                    ? state.settings().find_module(name)
                                    : ModuleAnswer{false, {}, "there are no modules here"};
    if (!answer.found) {
        raise_in_lesson(lua, "require \"" + std::string(name) + "\" failed: " + answer.problem);
    }
    state.load_text(lua, answer.source);
    lua_pushstring(lua, name);
    int n_arguments = 1;
    if (answer.source.name.starts_with(kLibraryFolder)) {
        lua_getfield(lua, LUA_REGISTRYINDEX, kLibraryServices);
        ++n_arguments;
    }
    lua_call(lua, n_arguments, 1);
    if (lua_isnil(lua, -1)) {
        lua_pop(lua, 1);
        lua_pushboolean(lua, 1);
    }
}

int safe_require(lua_State* lua) {
    std::size_t n = 0;
    const char* name = luaL_checklstring(lua, 1, &n);
    if (!is_name({name, n})) {
        raise_in_lesson(lua, std::string("require takes a plain name such as \"story\", not \"") +
                                 clean_text({name, n}, 40) + '"');
    }
    lua_settop(lua, 1);
    lua_getfield(lua, LUA_REGISTRYINDEX, kLoaded);
    if (lua_getfield(lua, 2, name) == LUA_TNIL) {
        lua_pop(lua, 1);
        // While it is loading it is marked by what no module can return, so that a circle is seen.
        lua_pushlightuserdata(lua, &ScriptState::of(lua));
        lua_setfield(lua, 2, name);
        run_module(lua, name);
        lua_pushvalue(lua, -1);
        lua_setfield(lua, 2, name);
    } else if (lua_islightuserdata(lua, -1)) {
        raise_in_lesson(lua,
                        std::string("the module \"") + clean_text(name, 40) + "\" requires itself");
    }
    return 1;
}

}  // namespace

std::string text_of(lua_State* lua, int index) {
    index = lua_absindex(lua, index);
    if (luaL_callmeta(lua, index, "__tostring") != 0) {
        if (lua_type(lua, -1) != LUA_TSTRING) {
            luaL_error(lua, "__tostring must return a string");
        }
        std::size_t n = 0;
        const char* text = lua_tolstring(lua, -1, &n);
        std::string result(text, n);
        lua_pop(lua, 1);
        return result;
    }
    switch (lua_type(lua, index)) {
        case LUA_TNIL:
        case LUA_TBOOLEAN:
        case LUA_TNUMBER:
        case LUA_TSTRING: {
            std::size_t n = 0;
            const char* text = luaL_tolstring(lua, index, &n);
            std::string result(text, n);
            lua_pop(lua, 1);
            return result;
        }
        default: {
            std::string result = luaL_typename(lua, index);
            if (const int kind = luaL_getmetafield(lua, index, "__name"); kind != LUA_TNIL) {
                if (kind == LUA_TSTRING) {
                    result = lua_tostring(lua, -1);
                }
                lua_pop(lua, 1);
            }
            return result;
        }
    }
}

void keep_charged(lua_State* lua, const char* const* names) {
    lua_newtable(lua);
    for (; *names != nullptr; ++names) {
        lua_getfield(lua, -2, *names);
        lua_pushcclosure(lua, &call_charged, 1);
        lua_setfield(lua, -2, *names);
    }
}

void open_safe_base(lua_State* lua) {
    luaL_requiref(lua, LUA_GNAME, luaopen_base, 0);
    static constexpr std::array kKept = {"assert", "error",    "getmetatable", "ipairs",  "next",
                                         "pairs",  "rawequal", "rawget",       "rawlen",  "rawset",
                                         "select", "tonumber", "type",         "_VERSION"};
    lua_newtable(lua);
    for (const char* name : kKept) {
        lua_getfield(lua, -2, name);
        lua_setfield(lua, -2, name);
    }
    constexpr luaL_Reg kOurs[] = {{"pcall", safe_pcall},       {"setmetatable", safe_setmetatable},
                                  {"tostring", safe_tostring}, {"print", safe_print},
                                  {"require", safe_require},   {nullptr, nullptr}};
    luaL_setfuncs(lua, kOurs, 0);
    lua_pushvalue(lua, -1);
    lua_setfield(lua, -2, LUA_GNAME);
    // The table of globals is replaced as a whole: nothing of the original stays reachable.
    lua_rawseti(lua, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
    lua_newtable(lua);
    lua_setfield(lua, LUA_REGISTRYINDEX, kLoaded);
    lua_pop(lua, 1);
}

void open_safe_library(lua_State* lua) {
    open_safe_base(lua);
    open_safe_string(lua);
    open_safe_table(lua);
    open_safe_coroutine(lua);
    open_safe_math(lua);
    // The originals that were opened on the way are forgotten.
    lua_pushnil(lua);
    lua_setfield(lua, LUA_REGISTRYINDEX, LUA_LOADED_TABLE);
}

}  // namespace fulcrum::runtime
