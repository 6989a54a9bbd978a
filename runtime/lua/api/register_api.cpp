// Makes Lua functions and objects out of the binding table.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/api/stack_room.h"
#include "runtime/lua/sandbox/safe_library.h"

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

constexpr Handle::Kind kHandleKinds[] = {
    Handle::Kind::world, Handle::Kind::tool,     Handle::Kind::body, Handle::Kind::force,
    Handle::Kind::hand,  Handle::Kind::material, Handle::Kind::kite};

const char* owner_name(Handle::Kind kind) {
    constexpr const char* kNames[] = {"world", "tool", "body", "force", "hand", "material", "kite"};
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

void check_receiver(lua_State* lua, const Binding& binding) {
    const std::string_view owner = binding.owner;
    if (owner == "lesson") {
        const LessonContext& context = context_of(lua);
        lua_rawgeti(lua, LUA_REGISTRYINDEX, context.lesson_ref);
        const bool same = lua_rawequal(lua, 1, -1) != 0;
        lua_pop(lua, 1);
        if (!same) {
            raise_in_lesson(lua, "write " + called_as(binding) +
                                     " with a colon, after the lesson's own variable");
        }
        return;
    }
    for (const Handle::Kind kind : kHandleKinds) {
        if (owner == owner_name(kind)) {
            static_cast<void>(check_handle(lua, 1, kind, called_as(binding).c_str()));
        }
    }
}

void check_time(lua_State* lua, const Binding& binding) {
    const LessonContext& context = context_of(lua);
    const std::string called = called_as(binding);
    if (context.is_hand && binding.time != CallTime::looking) {
        raise_in_lesson(lua,
                        called + " belongs in a lesson; a simulated hand only looks and moves");
    }
    if (binding.time == CallTime::loading && context.phase != LessonPhase::loading) {
        raise_in_lesson(
            lua,
            called + " stands outside all functions, so that it runs when the lesson is loaded");
    }
    if (binding.time == CallTime::declaring && context.phase != LessonPhase::starting) {
        raise_in_lesson(lua, called + " declares something; that is only possible in L:start");
    }
    if (binding.time == CallTime::acting && context.phase == LessonPhase::loading) {
        raise_in_lesson(lua, called + " needs the world; call it in L:start or later");
    }
}

int call_binding(lua_State* lua);

/// L:question "name" gives a function that waits for the record. Upvalues: binding, the lesson, the name.
int call_with_record(lua_State* lua) {
    lua_settop(lua, 1);
    lua_pushvalue(lua, lua_upvalueindex(1));
    lua_pushcclosure(lua, &call_binding, 1);
    lua_pushvalue(lua, lua_upvalueindex(2));
    lua_pushvalue(lua, lua_upvalueindex(3));
    lua_pushvalue(lua, 1);
    lua_call(lua, 3, LUA_MULTRET);
    return lua_gettop(lua) - 1;
}

/// What a binding throws that is not Lua's own error must not cross Lua.
int call_checked(lua_State* lua, const Binding& binding) {
    std::string problem;
    try {
        const Arguments arguments = check_arguments(lua, *binding.owner == '\0' ? 1 : 2, binding);
        return binding.call(lua, context_of(lua), arguments);
    } catch (const std::exception& error) {
        problem = error.what();
    }
    raise_in_lesson(lua, called_as(binding) + " failed: " + problem);
}

int call_binding(lua_State* lua) {
    const auto& binding = *static_cast<const Binding*>(lua_touserdata(lua, lua_upvalueindex(1)));
    const StackRoom room(lua);
    ScriptState::of(lua).charge(lua, kCallWork);
    check_receiver(lua, binding);
    check_time(lua, binding);
    if (binding.shape == CallShape::named_record && lua_gettop(lua) == 2) {
        if (lua_istable(lua, 2)) {
            raise_in_lesson(lua, called_as(binding) + " takes its name before the braces: " +
                                     called_as(binding) + " \"name\" { … }");
        }
        lua_pushvalue(lua, lua_upvalueindex(1));
        lua_pushvalue(lua, 1);
        lua_pushvalue(lua, 2);
        lua_pushcclosure(lua, &call_with_record, 3);
        return 1;
    }
    return call_checked(lua, binding);
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
int index_handle(lua_State* lua) {
    const StackRoom room(lua);
    const Handle* handle = to_handle(lua, 1);
    lua_pushvalue(lua, 2);
    if (handle != nullptr && lua_rawget(lua, lua_upvalueindex(1)) != LUA_TNIL) {
        return 1;
    }
    lua_pushvalue(lua, 2);
    if (handle != nullptr && lua_rawget(lua, lua_upvalueindex(2)) != LUA_TNIL) {
        const auto& property = *static_cast<const Property*>(lua_touserdata(lua, -1));
        static_cast<void>(check_handle(lua, 1, handle->kind, property.name));
        ScriptState::of(lua).charge(lua, kCallWork / 3);
        return property.get(lua, context_of(lua), handle->index);
    }
    const std::string owner = handle != nullptr ? owner_name(handle->kind) : "this";
    const std::string name =
        lua_type(lua, 2) == LUA_TSTRING ? clean_text(lua_tostring(lua, 2), 40) : text_of(lua, 2);
    if (const std::string elsewhere = owner_of_name(api_table(), name); !elsewhere.empty()) {
        raise_in_lesson(lua, owner + " has no \"" + name + "\"; write " + elsewhere);
    }
    const std::string near = nearest_word(name, names_of(owner));
    raise_in_lesson(lua, owner + " has no \"" + name + '"' +
                             (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

int refuse_assignment(lua_State* lua) {
    const Handle* handle = to_handle(lua, 1);
    const std::string owner = handle != nullptr ? owner_name(handle->kind) : "this";
    const std::string name =
        lua_type(lua, 2) == LUA_TSTRING ? clean_text(lua_tostring(lua, 2), 40) : "a field";
    raise_in_lesson(lua, owner + '.' + name + " can't be set" +
                             (owner == "body" ? "; use body:place{…}, body:drop{…} or body:turn{…}"
                                              : "; it shows how things stand"));
}

int handle_to_text(lua_State* lua) {
    const Handle* handle = to_handle(lua, 1);
    const LessonContext& context = context_of(lua);
    std::string text = handle != nullptr ? owner_name(handle->kind) : "object";
    if (handle != nullptr && handle->generation == context.generation) {
        const auto index = static_cast<std::size_t>(handle->index);
        if (handle->kind == Handle::Kind::body && index < context.description.bodies.size()) {
            text = context.description.bodies[index].name;
        } else if (handle->kind == Handle::Kind::material &&
                   index < context.description.materials.size()) {
            text = context.description.materials[index].felt.name;
        }
    }
    lua_pushlstring(lua, text.data(), text.size());
    return 1;
}

/// A table: name -> closure, of all functions of `owner`.
void push_methods(lua_State* lua, std::string_view owner) {
    lua_newtable(lua);
    for (const Binding& binding : api_table().functions) {
        if (owner == binding.owner) {
            lua_pushlightuserdata(lua, const_cast<Binding*>(&binding));
            lua_pushcclosure(lua, &call_binding, 1);
            lua_setfield(lua, -2, binding.name);
        }
    }
}

void make_handle_metatable(lua_State* lua, const char* owner) {
    luaL_newmetatable(lua, metatable_name(owner).c_str());
    push_methods(lua, owner);
    lua_newtable(lua);
    for (const Property& property : api_table().properties) {
        if (std::string_view(owner) == property.owner) {
            lua_pushlightuserdata(lua, const_cast<Property*>(&property));
            lua_setfield(lua, -2, property.name);
        }
    }
    lua_pushcclosure(lua, &index_handle, 2);
    lua_setfield(lua, -2, "__index");
    lua_pushcfunction(lua, &refuse_assignment);
    lua_setfield(lua, -2, "__newindex");
    lua_pushcfunction(lua, &handle_to_text);
    lua_setfield(lua, -2, "__tostring");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_pop(lua, 1);
}

/// L.name = value: a function whose name is nearly a callback's is a slip of the pen.
int assign_to_lesson(lua_State* lua) {
    if (lua_isfunction(lua, 3) && lua_type(lua, 2) == LUA_TSTRING) {
        const std::string name = lua_tostring(lua, 2);
        std::vector<std::string> known;
        for (const Callback& callback : api_table().callbacks) {
            known.emplace_back(callback.name);
        }
        const std::string near = nearest_word(name, known, 1);
        if (name.size() > 4 && !near.empty() && near != name) {
            raise_in_lesson(
                lua, "nothing calls L:" + clean_text(name, 40) + "; did you mean L:" + near + "?");
        }
    }
    lua_rawset(lua, 1);
    return 0;
}

}  // namespace

LessonContext& context_of(lua_State* lua) noexcept {
    return *static_cast<LessonContext*>(ScriptState::of(lua).context);
}

void add_command(lua_State* lua, LessonCommand command) {
    LessonContext& context = context_of(lua);
    if (context.reply.commands.size() + 2 >=
        kMaxCommands) {  // the force's and a last print's place are kept
        raise_in_lesson(lua,
                        "more than " + std::to_string(kMaxCommands) + " commands in one frame");
    }
    context.reply.commands.push_back(std::move(command));
}

void push_handle(lua_State* lua, Handle::Kind kind, std::int32_t index) {
    lua_getfield(lua, LUA_REGISTRYINDEX, kHandles);
    const lua_Integer key = static_cast<lua_Integer>(kind) * kHandlesAKind + index;
    if (lua_rawgeti(lua, -1, key) == LUA_TNIL) {
        lua_pop(lua, 1);
        new (lua_newuserdatauv(lua, sizeof(Handle), 0))
            Handle{kind, index, context_of(lua).generation};
        luaL_setmetatable(lua, metatable_name(owner_name(kind)).c_str());
        lua_pushvalue(lua, -1);
        lua_rawseti(lua, -3, key);
    }
    lua_remove(lua, -2);
}

const Handle* to_handle(lua_State* lua, int index) {
    return lua_type(lua, index) == LUA_TUSERDATA
               ? static_cast<const Handle*>(lua_touserdata(lua, index))
               : nullptr;
}

Handle check_handle(lua_State* lua, int index, Handle::Kind kind, const char* called) {
    const Handle* handle = to_handle(lua, index);
    if (handle == nullptr || handle->kind != kind) {
        raise_in_lesson(
            lua, std::string("write ") + called + " with a colon, after a " + owner_name(kind));
    }
    const LessonContext& context = context_of(lua);
    const std::size_t n_bodies = context.description.bodies.size();
    const std::size_t n_forces = context.description.forces.size();
    const std::size_t n_materials = context.description.materials.size();
    const bool is_of_hand = kind == Handle::Kind::hand || kind == Handle::Kind::tool;
    const std::size_t n = kind == Handle::Kind::body       ? n_bodies
                          : kind == Handle::Kind::force    ? n_forces
                          : kind == Handle::Kind::material ? n_materials
                          : is_of_hand ? 1 + context.description.more_hands.size()
                                       : 1;
    if (handle->generation != context.generation || static_cast<std::size_t>(handle->index) >= n) {
        raise_in_lesson(lua, std::string(called) + ": this " + owner_name(kind) +
                                 " belongs to a scene that is gone");
    }
    return *handle;
}

void push_vector(lua_State* lua, const Vector3& v) {
    constexpr const char* kAxes[] = {"x", "y", "z"};
    lua_createtable(lua, 3, 3);
    for (int i = 0; i < 3; ++i) {
        lua_pushnumber(lua, v[i]);
        lua_rawseti(lua, -2, i + 1);
        lua_pushnumber(lua, v[i]);
        lua_setfield(lua, -2, kAxes[i]);
    }
}

void register_api(lua_State* lua) {
    lua_newtable(lua);
    lua_setfield(lua, LUA_REGISTRYINDEX, kHandles);
    for (const Handle::Kind kind : kHandleKinds) {
        make_handle_metatable(lua, owner_name(kind));
    }
    luaL_newmetatable(lua, kLessonMetatable);
    push_methods(lua, "lesson");
    lua_setfield(lua, -2, "__index");
    lua_pushcfunction(lua, &assign_to_lesson);
    lua_setfield(lua, -2, "__newindex");
    lua_pushboolean(lua, 0);
    lua_setfield(lua, -2, "__metatable");
    lua_pop(lua, 1);
    // Functions without an owner are globals.
    push_methods(lua, "");
    lua_pushglobaltable(lua);
    for (lua_pushnil(lua); lua_next(lua, -3) != 0; lua_pop(lua, 1)) {
        lua_pushvalue(lua, -2);
        lua_pushvalue(lua, -2);
        lua_rawset(lua, -5);
    }
    lua_pop(lua, 2);
    register_library_services(lua);
    make_globals_strict(lua);
}

}  // namespace fulcrum::runtime
