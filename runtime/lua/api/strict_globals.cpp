// Globals that must have been given a value before they are read: a misspelt name is told where it stands, instead of
// being nil far from there. A name that was once assigned, be it nil, may always be read.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMostCandidates = 500;
constexpr std::size_t kWorkACandidate = 20;  // in instructions

/// What plain Lua has and a lesson has not, and what to do instead.
std::string_view absent_from_lessons(std::string_view name) {
    constexpr std::string_view kNoFiles =
        "a lesson has no files; keep words and numbers in the lesson itself";
    constexpr std::string_view kNoTexts =
        "a lesson runs no texts; write functions, or a module beside the lesson and require it";
    constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kAbsent{{
        {"io", kNoFiles},
        {"dofile", kNoFiles},
        {"loadfile", kNoFiles},
        {"os", "a lesson has no operating system; world.time tells the seconds since it began"},
        {"load", kNoTexts},
        {"loadstring", kNoTexts},
        {"debug", "a lesson has no debug library; print(…) shows values in the terminal"},
        {"package", "a lesson has no packages; require takes modules beside it or in the library"},
        {"utf8", "a lesson has no utf8 library"},
        {"xpcall", "a lesson has no xpcall; use pcall"},
        {"collectgarbage", "a lesson has no collectgarbage; unused memory is freed by itself"},
    }};
    const auto* const found = std::find_if(kAbsent.begin(), kAbsent.end(),
                                           [&](const auto& row) { return row.first == name; });
    return found == kAbsent.end() ? std::string_view{} : found->second;
}

/// The names that could be meant: the globals, and the locals of the function that reads.
std::vector<std::string> candidates_for(lua_State* lua) {
    std::vector<std::string> names;
    const auto add = [&names](const char* name) {
        // Lua's own helpers are called "(for state)" and the like.
        if (name != nullptr && *name != '(' && *name != '\0' && names.size() < kMostCandidates) {
            names.emplace_back(name);
        }
    };
    lua_Debug activation{};
    if (lua_getstack(lua, 1, &activation) != 0) {
        const char* name = nullptr;
        for (int i = 1; (name = lua_getlocal(lua, &activation, i)) != nullptr; ++i) {
            lua_pop(lua, 1);
            add(name);
        }
        lua_getinfo(lua, "f", &activation);
        for (int i = 1; (name = lua_getupvalue(lua, -1, i)) != nullptr; ++i) {
            lua_pop(lua, 1);
            add(name);
        }
        lua_pop(lua, 1);
    }
    for (lua_pushnil(lua); lua_next(lua, 1) != 0; lua_pop(lua, 1)) {
        if (lua_type(lua, -2) == LUA_TSTRING) {
            add(lua_tostring(lua, -2));
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

/// What a name means that belongs behind another: "question" is L:question, "wait" is story.wait; empty for other names.
std::string owner_of_missing(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kElsewhere{{
        {"L", "begin the file with local L = lesson { … }"},
        {"world", "it is given to functions such as function L:start(world)"},
        {"wait", "write story.wait, after local story = require \"story\""},
        {"wait_for", "write story.wait_for, after local story = require \"story\""},
        {"wait_until", "write story.wait_until, after local story = require \"story\""},
        {"story", "write local story = require \"story\" at the top"},
        {"game", "write local game = require \"game\" at the top"},
        {"motion", "write local motion = require \"motion\" at the top"},
        {"numbers", "write local numbers = require \"numbers\" at the top"},
    }};
    const auto* const found = std::find_if(kElsewhere.begin(), kElsewhere.end(),
                                           [&](const auto& row) { return row.first == name; });
    if (found != kElsewhere.end()) {
        return std::string(found->second);
    }
    for (const Binding& binding : api_table().functions) {
        const std::string_view owner = binding.owner;
        if (name == binding.name && !owner.empty()) {
            return "write " + std::string(owner == "lesson" ? "L" : owner) + ':' + binding.name;
        }
    }
    return {};
}

/// __index of the globals. Upvalue 1: the names that were ever assigned.
int read_missing(lua_State* lua) {
    lua_pushvalue(lua, 2);
    if (lua_rawget(lua, lua_upvalueindex(1)) != LUA_TNIL || lua_type(lua, 2) != LUA_TSTRING) {
        lua_pushnil(lua);
        return 1;
    }
    std::size_t n = 0;
    const char* text = lua_tolstring(lua, 2, &n);
    const std::string name = clean_text({text, n}, 40);
    if (const std::string_view absent = absent_from_lessons(name); !absent.empty()) {
        raise_in_lesson(lua, std::string(absent));
    }
    const std::vector<std::string> candidates = candidates_for(lua);
    ScriptState::of(lua).charge(lua, 100 + kWorkACandidate * candidates.size());
    const std::string elsewhere = owner_of_missing(name);
    const std::string near = nearest_word(name, candidates, 2);
    raise_in_lesson(lua, name + " has no value; " +
                             (!elsewhere.empty() ? elsewhere
                              : near.empty() ? "is it spelt right, or a text without its \"…\"?"
                                             : "did you mean " + near + "?"));
}

/// __newindex of the globals: the name is known from now on.
int assign_new(lua_State* lua) {
    ScriptState::of(lua).charge(lua, 5);
    if (lua_isfunction(lua, 3) && lua_type(lua, 2) == LUA_TSTRING) {
        const std::string_view name = lua_tostring(lua, 2);
        for (const Callback& callback : api_table().callbacks) {
            if (name == callback.name) {
                raise_in_lesson(lua, std::string("nothing calls ") + callback.name +
                                         "; write function L:" + callback.name + "(…)");
            }
        }
    }
    lua_pushvalue(lua, 2);
    lua_pushboolean(lua, 1);
    lua_rawset(lua, lua_upvalueindex(1));
    lua_rawset(lua, 1);
    return 0;
}

}  // namespace

void make_globals_strict(lua_State* lua) {
    lua_pushglobaltable(lua);
    lua_newtable(lua);
    lua_newtable(lua);
    lua_pushvalue(lua, -1);
    lua_pushcclosure(lua, &read_missing, 1);
    lua_setfield(lua, -3, "__index");
    lua_pushcclosure(lua, &assign_new, 1);
    lua_setfield(lua, -2, "__newindex");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_setmetatable(lua, -2);
    lua_pop(lua, 1);
}

}  // namespace fulcrum::runtime
