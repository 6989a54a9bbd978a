// What the shared library (scripts/lib) gets from the program as the second value of its file, so that its mistakes are
// told like those of every other function: in one sentence, at the lesson's own line.
//
//   mistake(text)               raises `text` at the lesson's line
//   shown(value)                the value as people say it: nothing, 3, the text "x", a table …
//   unknown(owner, table, name) raises that `owner` has no `name`, and which of the table's names was meant
//   awaits(event)               the lesson waits for such events: a mistake when none can come
#include "runtime/lua/api/needs.h"
#include "runtime/lua/sandbox/safe_library.h"

#include <algorithm>
#include <string>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostMistake_bytes = 400;

std::string text_argument(lua_State* lua, int index, std::size_t max_bytes) {
    std::size_t n = 0;
    const char* text = luaL_checklstring(lua, index, &n);
    return clean_text({text, n}, max_bytes);
}

int raise_mistake(lua_State* lua) {
    raise_in_lesson(lua, text_argument(lua, 1, kMostMistake_bytes));
}

int show_value(lua_State* lua) {
    const std::string text = given_text(lua, 1);
    lua_pushlstring(lua, text.data(), text.size());
    return 1;
}

int raise_unknown(lua_State* lua) {
    std::string message = text_argument(lua, 1, kMaxNameBytes) + " has no ";
    luaL_checktype(lua, 2, LUA_TTABLE);
    if (lua_type(lua, 3) != LUA_TSTRING) {
        raise_in_lesson(lua, message + given_text(lua, 3));
    }
    const std::string name = text_argument(lua, 3, kMaxNameBytes);
    std::vector<std::string> known;
    for (lua_pushnil(lua); lua_next(lua, 2) != 0; lua_pop(lua, 1)) {
        if (lua_type(lua, -2) == LUA_TSTRING) {
            known.emplace_back(lua_tostring(lua, -2));
        }
    }
    std::sort(known.begin(), known.end());
    const std::string near = nearest_word(name, known);
    raise_in_lesson(lua, message + name + (near.empty() ? "" : "; did you mean " + near + "?"));
}

int await_event(lua_State* lua) {
    require_event(lua, context_of(lua), text_argument(lua, 1, kMaxNameBytes));
    return 0;
}

}  // namespace

void register_library_services(lua_State* lua) {
    constexpr luaL_Reg kServices[] = {{"mistake", raise_mistake},
                                      {"shown", show_value},
                                      {"unknown", raise_unknown},
                                      {"awaits", await_event},
                                      {nullptr, nullptr}};
    lua_newtable(lua);
    luaL_setfuncs(lua, kServices, 0);
    lua_setfield(lua, LUA_REGISTRYINDEX, kLibraryServices);
}

}  // namespace fulcrum::runtime
