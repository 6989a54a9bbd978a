// Makes Lua functions and objects out of the binding table.
#include "runtime/lua/binding_table.h"
#include "runtime/lua/lesson_context.h"
#include "runtime/lua/safe_library.h"

#include <algorithm>

#include <exception>
#include <new>
#include <set>

namespace fulcrum::runtime {
namespace {

constexpr const char* kHandles = "fulcrum.handles";
constexpr const char* kLessonMetatable = "fulcrum.lesson";
constexpr int kHandlesAKind = 1000;
constexpr std::uint64_t kCallWork = 30;  // what a call counts as, in instructions

const char* owner_name(Handle::Kind kind) {
    constexpr const char* kNames[] = {"world", "tool", "body", "force"};
    return kNames[static_cast<int>(kind)];
}

std::string metatable_name(std::string_view owner) {
    return "fulcrum." + std::string(owner);
}

// ---- calls --------------------------------------------------------------------------------------------------------

/// How errors call the function: "world:body", "L:question", "lesson".
std::string called_as(const Binding& binding) {
    const std::string_view owner = binding.owner;
    return owner.empty() ? binding.name
                         : std::string(owner == "lesson" ? "L" : owner) + ':' + binding.name;
}

void check_receiver(lua_State* L, const Binding& binding) {
    const std::string_view owner = binding.owner;
    if (owner == "lesson") {
        const LessonContext& context = context_of(L);
        lua_rawgeti(L, LUA_REGISTRYINDEX, context.lesson_ref);
        const bool same = lua_rawequal(L, 1, -1) != 0;
        lua_pop(L, 1);
        if (!same) {
            raise_in_lesson(L, "write " + called_as(binding) +
                                   " with a colon, after the lesson's own variable");
        }
        return;
    }
    for (const auto kind :
         {Handle::Kind::world, Handle::Kind::tool, Handle::Kind::body, Handle::Kind::force}) {
        if (owner == owner_name(kind)) {
            static_cast<void>(check_handle(L, 1, kind, called_as(binding).c_str()));
        }
    }
}

void check_time(lua_State* L, const Binding& binding) {
    const LessonContext& context = context_of(L);
    const std::string called = called_as(binding);
    if (context.is_hand && binding.time != CallTime::looking) {
        raise_in_lesson(L, called + " belongs in a lesson; a simulated hand only looks and moves");
    }
    if (binding.time == CallTime::loading && context.phase != LessonPhase::loading) {
        raise_in_lesson(
            L, called + " stands outside all functions, so that it runs when the lesson is loaded");
    }
    if (binding.time == CallTime::declaring && context.phase != LessonPhase::starting) {
        raise_in_lesson(L, called + " declares something; that is only possible in L:start");
    }
    if (binding.time == CallTime::acting && context.phase == LessonPhase::loading) {
        raise_in_lesson(L, called + " needs the world; call it in L:start or later");
    }
}

int call_binding(lua_State* L);

/// L:question "name" gives a function that waits for the record. Upvalues: binding, the lesson, the name.
int call_with_record(lua_State* L) {
    lua_settop(L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_pushcclosure(L, &call_binding, 1);
    lua_pushvalue(L, lua_upvalueindex(2));
    lua_pushvalue(L, lua_upvalueindex(3));
    lua_pushvalue(L, 1);
    lua_call(L, 3, LUA_MULTRET);
    return lua_gettop(L) - 1;
}

/// What a binding throws that is not Lua's own error must not cross Lua.
int call_checked(lua_State* L, const Binding& binding) {
    std::string problem;
    try {
        const Arguments arguments = check_arguments(L, *binding.owner == '\0' ? 1 : 2, binding);
        return binding.call(L, context_of(L), arguments);
    } catch (const std::exception& error) {
        problem = error.what();
    }
    raise_in_lesson(L, called_as(binding) + " failed: " + problem);
}

int call_binding(lua_State* L) {
    const auto& binding = *static_cast<const Binding*>(lua_touserdata(L, lua_upvalueindex(1)));
    ScriptState::of(L).charge(L, kCallWork);
    check_receiver(L, binding);
    check_time(L, binding);
    if (binding.shape == CallShape::named_record && lua_gettop(L) == 2) {
        lua_pushvalue(L, lua_upvalueindex(1));
        lua_pushvalue(L, 1);
        lua_pushvalue(L, 2);
        lua_pushcclosure(L, &call_with_record, 3);
        return 1;
    }
    return call_checked(L, binding);
}

// ---- objects ------------------------------------------------------------------------------------------------------

std::vector<std::string> names_of(std::string_view owner) {
    std::vector<std::string> names;
    for (const Binding& binding : api_table().functions) {
        if (owner == binding.owner) {
            names.emplace_back(binding.name);
        }
    }
    for (const Property& property : api_table().properties) {
        if (owner == property.owner) {
            names.emplace_back(property.name);
        }
    }
    return names;
}

/// object.name: upvalue 1 holds the methods, upvalue 2 the properties.
int index_handle(lua_State* L) {
    const Handle* handle = to_handle(L, 1);
    lua_pushvalue(L, 2);
    if (handle != nullptr && lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) {
        return 1;
    }
    lua_pushvalue(L, 2);
    if (handle != nullptr && lua_rawget(L, lua_upvalueindex(2)) != LUA_TNIL) {
        const auto& property = *static_cast<const Property*>(lua_touserdata(L, -1));
        static_cast<void>(check_handle(L, 1, handle->kind, property.name));
        ScriptState::of(L).charge(L, kCallWork / 3);
        return property.get(L, context_of(L), handle->index);
    }
    const std::string owner = handle != nullptr ? owner_name(handle->kind) : "this";
    const std::string name =
        lua_type(L, 2) == LUA_TSTRING ? clean_text(lua_tostring(L, 2), 40) : text_of(L, 2);
    const std::string near = nearest_word(name, names_of(owner));
    raise_in_lesson(L, owner + " has no \"" + name + '"' +
                           (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

int refuse_assignment(lua_State* L) {
    const Handle* handle = to_handle(L, 1);
    const std::string owner = handle != nullptr ? owner_name(handle->kind) : "this";
    const std::string name =
        lua_type(L, 2) == LUA_TSTRING ? clean_text(lua_tostring(L, 2), 40) : "a field";
    raise_in_lesson(L, owner + '.' + name + " can't be set" +
                           (owner == "body" ? "; use body:place{…} or body:drop{…}"
                                            : "; it shows how things stand"));
}

int handle_to_text(lua_State* L) {
    const Handle* handle = to_handle(L, 1);
    const LessonContext& context = context_of(L);
    std::string text = handle != nullptr ? owner_name(handle->kind) : "object";
    if (handle != nullptr && handle->generation == context.generation &&
        handle->kind == Handle::Kind::body &&
        static_cast<std::size_t>(handle->index) < context.description.bodies.size()) {
        text = context.description.bodies[static_cast<std::size_t>(handle->index)].name;
    }
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

/// A table: name -> closure, of all functions of `owner`.
void push_methods(lua_State* L, std::string_view owner) {
    lua_newtable(L);
    for (const Binding& binding : api_table().functions) {
        if (owner == binding.owner) {
            lua_pushlightuserdata(L, const_cast<Binding*>(&binding));
            lua_pushcclosure(L, &call_binding, 1);
            lua_setfield(L, -2, binding.name);
        }
    }
}

void make_handle_metatable(lua_State* L, const char* owner) {
    luaL_newmetatable(L, metatable_name(owner).c_str());
    push_methods(L, owner);
    lua_newtable(L);
    for (const Property& property : api_table().properties) {
        if (std::string_view(owner) == property.owner) {
            lua_pushlightuserdata(L, const_cast<Property*>(&property));
            lua_setfield(L, -2, property.name);
        }
    }
    lua_pushcclosure(L, &index_handle, 2);
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, &refuse_assignment);
    lua_setfield(L, -2, "__newindex");
    lua_pushcfunction(L, &handle_to_text);
    lua_setfield(L, -2, "__tostring");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
}

/// L.name = value: a function whose name is nearly a callback's is a slip of the pen.
int assign_to_lesson(lua_State* L) {
    if (lua_isfunction(L, 3) && lua_type(L, 2) == LUA_TSTRING) {
        const std::string name = lua_tostring(L, 2);
        std::vector<std::string> known;
        for (const Callback& callback : api_table().callbacks) {
            known.emplace_back(callback.name);
        }
        const std::string near = nearest_word(name, known, 1);
        if (name.size() > 4 && !near.empty() && near != name) {
            raise_in_lesson(
                L, "nothing calls L:" + clean_text(name, 40) + "; did you mean L:" + near + "?");
        }
    }
    lua_rawset(L, 1);
    return 0;
}

}  // namespace

LessonContext& context_of(lua_State* L) noexcept {
    return *static_cast<LessonContext*>(ScriptState::of(L).context);
}

void add_command(lua_State* L, LessonCommand command) {
    LessonContext& context = context_of(L);
    if (context.reply.commands.size() + 2 >=
        kMaxCommands) {  // the force's and a last print's place are kept
        raise_in_lesson(L, "more than " + std::to_string(kMaxCommands) + " commands in one frame");
    }
    context.reply.commands.push_back(std::move(command));
}

void push_handle(lua_State* L, Handle::Kind kind, std::int32_t index) {
    lua_getfield(L, LUA_REGISTRYINDEX, kHandles);
    const lua_Integer key = static_cast<lua_Integer>(kind) * kHandlesAKind + index;
    if (lua_rawgeti(L, -1, key) == LUA_TNIL) {
        lua_pop(L, 1);
        new (lua_newuserdatauv(L, sizeof(Handle), 0)) Handle{kind, index, context_of(L).generation};
        luaL_setmetatable(L, metatable_name(owner_name(kind)).c_str());
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, key);
    }
    lua_remove(L, -2);
}

const Handle* to_handle(lua_State* L, int index) {
    return lua_type(L, index) == LUA_TUSERDATA
               ? static_cast<const Handle*>(lua_touserdata(L, index))
               : nullptr;
}

Handle check_handle(lua_State* L, int index, Handle::Kind kind, const char* called) {
    const Handle* handle = to_handle(L, index);
    if (handle == nullptr || handle->kind != kind) {
        raise_in_lesson(
            L, std::string("write ") + called + " with a colon, after a " + owner_name(kind));
    }
    const LessonContext& context = context_of(L);
    const std::size_t n_bodies = context.description.bodies.size();
    const std::size_t n_forces = context.description.forces.size();
    const std::size_t n = kind == Handle::Kind::body    ? n_bodies
                          : kind == Handle::Kind::force ? n_forces
                                                        : 1;
    if (handle->generation != context.generation || static_cast<std::size_t>(handle->index) >= n) {
        raise_in_lesson(L, std::string(called) + ": this " + owner_name(kind) +
                               " belongs to a scene that is gone");
    }
    return *handle;
}

void push_vector(lua_State* L, const Vector3& v) {
    constexpr const char* kAxes[] = {"x", "y", "z"};
    lua_createtable(L, 3, 3);
    for (int i = 0; i < 3; ++i) {
        lua_pushnumber(L, v[i]);
        lua_rawseti(L, -2, i + 1);
        lua_pushnumber(L, v[i]);
        lua_setfield(L, -2, kAxes[i]);
    }
}

void register_api(lua_State* L) {
    lua_newtable(L);
    lua_setfield(L, LUA_REGISTRYINDEX, kHandles);
    for (const auto kind :
         {Handle::Kind::world, Handle::Kind::tool, Handle::Kind::body, Handle::Kind::force}) {
        make_handle_metatable(L, owner_name(kind));
    }
    luaL_newmetatable(L, kLessonMetatable);
    push_methods(L, "lesson");
    lua_setfield(L, -2, "__index");
    lua_pushcfunction(L, &assign_to_lesson);
    lua_setfield(L, -2, "__newindex");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
    // Functions without an owner are globals.
    push_methods(L, "");
    lua_pushglobaltable(L);
    for (lua_pushnil(L); lua_next(L, -3) != 0; lua_pop(L, 1)) {
        lua_pushvalue(L, -2);
        lua_pushvalue(L, -2);
        lua_settable(L, -5);
    }
    lua_pop(L, 2);
}

}  // namespace fulcrum::runtime
