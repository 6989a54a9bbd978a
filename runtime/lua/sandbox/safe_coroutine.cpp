// Coroutines with the budget going through them and with `close` bounded: Lua 5.4.4 resets its
// count of nested C calls when a coroutine is closed, so that closes nested in __close handlers
// overflow the stack of the host.
#include "runtime/lua/sandbox/safe_library.h"
#include "runtime/lua/sandbox/script_state.h"

namespace fulcrum::runtime {
namespace {

lua_State* check_coroutine(lua_State* lua) {
    lua_State* co = lua_tothread(lua, 1);
    luaL_argexpected(lua, co != nullptr, 1, "coroutine");
    return co;
}

/// Runs `co` with the arguments on top of `lua`; the results, or the error, are moved to `lua`. Returns
/// their number, -1 for an error.
int resume_with(lua_State* lua, lua_State* co, int n_arguments) {
    ScriptState& state = ScriptState::of(lua);
    state.charge(lua, 20);
    if (lua_checkstack(co, n_arguments) == 0) {
        lua_pushliteral(lua, "too many arguments to resume");
        return -1;
    }
    lua_xmove(lua, co, n_arguments);
    int n_results = 0;
    state.running = co;
    const int status = lua_resume(co, lua, n_arguments, &n_results);
    state.running = lua;
    state.check_spent(lua);
    if (status != LUA_OK && status != LUA_YIELD) {
        state.note_failure(co);
        lua_xmove(co, lua, 1);
        return -1;
    }
    if (lua_checkstack(lua, n_results + 1) == 0) {
        lua_pop(co, n_results);
        lua_pushliteral(lua, "too many results to resume");
        return -1;
    }
    lua_xmove(co, lua, n_results);
    return n_results;
}

int coroutine_create(lua_State* lua) {
    luaL_checktype(lua, 1, LUA_TFUNCTION);
    ScriptState::of(lua).charge(lua, 50);
    lua_State* co = lua_newthread(lua);
    lua_pushvalue(lua, 1);
    lua_xmove(lua, co, 1);
    return 1;
}

int coroutine_resume(lua_State* lua) {
    lua_State* co = check_coroutine(lua);
    const int n = resume_with(lua, co, lua_gettop(lua) - 1);
    lua_pushboolean(lua, n >= 0 ? 1 : 0);
    const int n_values = n >= 0 ? n : 1;
    lua_insert(lua, -(n_values + 1));
    return n_values + 1;
}

int call_wrapped(lua_State* lua) {
    lua_State* co = lua_tothread(lua, lua_upvalueindex(1));
    const int n = resume_with(lua, co, lua_gettop(lua));
    return n >= 0 ? n : lua_error(lua);
}

int coroutine_wrap(lua_State* lua) {
    coroutine_create(lua);
    lua_pushcclosure(lua, &call_wrapped, 1);
    return 1;
}

int coroutine_yield(lua_State* lua) {
    return lua_yield(lua, lua_gettop(lua));
}

const char* status_of(lua_State* lua, lua_State* co) {
    if (lua == co) {
        return "running";
    }
    if (lua_status(co) == LUA_YIELD) {
        return "suspended";
    }
    lua_Debug activation{};
    if (lua_status(co) != LUA_OK) {
        return "dead";
    }
    if (lua_getstack(co, 0, &activation) != 0) {
        return "normal";
    }
    return lua_gettop(co) == 0 ? "dead" : "suspended";
}

int coroutine_status(lua_State* lua) {
    lua_pushstring(lua, status_of(lua, check_coroutine(lua)));
    return 1;
}

int coroutine_isyieldable(lua_State* lua) {
    lua_pushboolean(lua, lua_isyieldable(lua));
    return 1;
}

int coroutine_running(lua_State* lua) {
    const int is_main = lua_pushthread(lua);
    lua_pushboolean(lua, is_main);
    return 2;
}

int coroutine_close(lua_State* lua) {
    lua_State* co = check_coroutine(lua);
    const std::string_view status = status_of(lua, co);
    if (status != "dead" && status != "suspended") {
        return luaL_error(lua, "a %s coroutine can't be closed", status.data());
    }
    ScriptState& state = ScriptState::of(lua);
    state.charge(lua, 50);
    if (state.close_depth >= kMaxCloseDepth) {
        return luaL_error(lua, "coroutine.close is nested too deeply");
    }
    ++state.close_depth;
    state.running = co;
    const int result = lua_resetthread(co);
    state.running = lua;
    --state.close_depth;
    state.check_spent(lua);
    lua_pushboolean(lua, result == LUA_OK ? 1 : 0);
    if (result == LUA_OK) {
        return 1;
    }
    lua_xmove(co, lua, 1);
    return 2;
}

}  // namespace

void open_safe_coroutine(lua_State* lua) {
    constexpr luaL_Reg kFunctions[] = {{"create", coroutine_create},
                                       {"resume", coroutine_resume},
                                       {"wrap", coroutine_wrap},
                                       {"yield", coroutine_yield},
                                       {"status", coroutine_status},
                                       {"isyieldable", coroutine_isyieldable},
                                       {"running", coroutine_running},
                                       {"close", coroutine_close},
                                       {nullptr, nullptr}};
    luaL_newlib(lua, kFunctions);
    lua_setglobal(lua, "coroutine");
}

}  // namespace fulcrum::runtime
