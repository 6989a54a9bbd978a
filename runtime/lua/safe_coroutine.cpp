// Coroutines with the budget going through them and with `close` bounded: Lua 5.4.4 resets its
// count of nested C calls when a coroutine is closed, so that closes nested in __close handlers
// overflow the stack of the host.
#include "runtime/lua/safe_library.h"
#include "runtime/lua/script_state.h"

namespace fulcrum::runtime {
namespace {

lua_State* check_coroutine(lua_State* L) {
    lua_State* co = lua_tothread(L, 1);
    luaL_argexpected(L, co != nullptr, 1, "coroutine");
    return co;
}

/// Runs `co` with the arguments on top of L; the results, or the error, are moved to L. Returns
/// their number, -1 for an error.
int resume_with(lua_State* L, lua_State* co, int n_arguments) {
    ScriptState& state = ScriptState::of(L);
    state.charge(L, 20);
    if (lua_checkstack(co, n_arguments) == 0) {
        lua_pushliteral(L, "too many arguments to resume");
        return -1;
    }
    lua_xmove(L, co, n_arguments);
    int n_results = 0;
    state.running = co;
    const int status = lua_resume(co, L, n_arguments, &n_results);
    state.running = L;
    state.check_spent(L);
    if (status != LUA_OK && status != LUA_YIELD) {
        lua_xmove(co, L, 1);
        return -1;
    }
    if (lua_checkstack(L, n_results + 1) == 0) {
        lua_pop(co, n_results);
        lua_pushliteral(L, "too many results to resume");
        return -1;
    }
    lua_xmove(co, L, n_results);
    return n_results;
}

int coroutine_create(lua_State* L) {
    luaL_checktype(L, 1, LUA_TFUNCTION);
    ScriptState::of(L).charge(L, 50);
    lua_State* co = lua_newthread(L);
    lua_pushvalue(L, 1);
    lua_xmove(L, co, 1);
    return 1;
}

int coroutine_resume(lua_State* L) {
    lua_State* co = check_coroutine(L);
    const int n = resume_with(L, co, lua_gettop(L) - 1);
    lua_pushboolean(L, n >= 0 ? 1 : 0);
    const int n_values = n >= 0 ? n : 1;
    lua_insert(L, -(n_values + 1));
    return n_values + 1;
}

int call_wrapped(lua_State* L) {
    lua_State* co = lua_tothread(L, lua_upvalueindex(1));
    const int n = resume_with(L, co, lua_gettop(L));
    return n >= 0 ? n : lua_error(L);
}

int coroutine_wrap(lua_State* L) {
    coroutine_create(L);
    lua_pushcclosure(L, &call_wrapped, 1);
    return 1;
}

int coroutine_yield(lua_State* L) {
    return lua_yield(L, lua_gettop(L));
}

const char* status_of(lua_State* L, lua_State* co) {
    if (L == co) {
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

int coroutine_status(lua_State* L) {
    lua_pushstring(L, status_of(L, check_coroutine(L)));
    return 1;
}

int coroutine_isyieldable(lua_State* L) {
    lua_pushboolean(L, lua_isyieldable(L));
    return 1;
}

int coroutine_running(lua_State* L) {
    const int is_main = lua_pushthread(L);
    lua_pushboolean(L, is_main);
    return 2;
}

int coroutine_close(lua_State* L) {
    lua_State* co = check_coroutine(L);
    const std::string_view status = status_of(L, co);
    if (status != "dead" && status != "suspended") {
        return luaL_error(L, "a %s coroutine can't be closed", status.data());
    }
    ScriptState& state = ScriptState::of(L);
    state.charge(L, 50);
    if (state.close_depth >= kMaxCloseDepth) {
        return luaL_error(L, "coroutine.close is nested too deeply");
    }
    ++state.close_depth;
    state.running = co;
    const int result = lua_resetthread(co);
    state.running = L;
    --state.close_depth;
    state.check_spent(L);
    lua_pushboolean(L, result == LUA_OK ? 1 : 0);
    if (result == LUA_OK) {
        return 1;
    }
    lua_xmove(co, L, 1);
    return 2;
}

}  // namespace

void open_safe_coroutine(lua_State* L) {
    constexpr luaL_Reg kFunctions[] = {{"create", coroutine_create},
                                       {"resume", coroutine_resume},
                                       {"wrap", coroutine_wrap},
                                       {"yield", coroutine_yield},
                                       {"status", coroutine_status},
                                       {"isyieldable", coroutine_isyieldable},
                                       {"running", coroutine_running},
                                       {"close", coroutine_close},
                                       {nullptr, nullptr}};
    luaL_newlib(L, kFunctions);
    lua_setglobal(L, "coroutine");
}

}  // namespace fulcrum::runtime
