// Checks what a lesson passes, by the binding table's types, units and ranges, and says what is wrong in one sentence.
#include "runtime/lua/api/argument_place.h"
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/sandbox/safe_library.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fulcrum::runtime {
namespace {

double check_number(lua_State* lua, const Place& place, int index) {
    const double value = lua_tonumber(lua, index);
    if (lua_type(lua, index) != LUA_TNUMBER ||
        !(value >= place.parameter.low && value <= place.parameter.high)) {
        refuse(lua, place, given_text(lua, index));
    }
    return value;
}

void check_choice(lua_State* lua, const Place& place, PlainArgument& argument) {
    if (lua_type(lua, place.index) != LUA_TSTRING) {
        refuse(lua, place, given_text(lua, place.index));
    }
    argument.text = check_text(lua, place, place.index, kMaxTextBytes);
    const std::vector<std::string> names = choices_of(place.parameter);
    if (std::find(names.begin(), names.end(), argument.text) == names.end()) {
        const std::string near = nearest_word(argument.text, names);
        refuse(lua, place,
               given_text(lua, place.index) +
                   (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
    }
}

/// What world:material gave is found by its index, the program's own by its name.
void check_material(lua_State* lua, const Place& place, PlainArgument& argument) {
    const Handle* handle = to_handle(lua, place.index);
    if (handle != nullptr && handle->kind == Handle::Kind::material) {
        argument.material =
            check_handle(lua, place.index, Handle::Kind::material, place.label.c_str()).index;
    } else if (lua_type(lua, place.index) == LUA_TSTRING) {
        argument.text = check_text(lua, place, place.index, kMaxTextBytes);
    } else {
        refuse(lua, place, given_text(lua, place.index));
    }
}

void check_given(lua_State* lua, const Place& place, PlainArgument& argument) {
    switch (place.parameter.type) {
        case ParameterType::choice:
            check_choice(lua, place, argument);
            break;
        case ParameterType::material:
            check_material(lua, place, argument);
            break;
        case ParameterType::number:
            argument.number = check_number(lua, place, place.index);
            break;
        case ParameterType::integer:
            argument.number = check_number(lua, place, place.index);
            if (argument.number != std::floor(argument.number)) {
                refuse(lua, place, given_text(lua, place.index));
            }
            break;
        case ParameterType::flag:
            if (!lua_isboolean(lua, place.index)) {
                refuse(lua, place, given_text(lua, place.index));
            }
            argument.flag = lua_toboolean(lua, place.index) != 0;
            break;
        case ParameterType::text:
            argument.text =
                check_text(lua, place, place.index, static_cast<std::size_t>(place.parameter.high));
            break;
        case ParameterType::name:
            argument.text = check_text(lua, place, place.index, kMaxTextBytes);
            if (!is_name(argument.text)) {
                refuse(lua, place, given_text(lua, place.index));
            }
            break;
        case ParameterType::vector:
            argument.vector = check_vector(lua, place);
            break;
        case ParameterType::function:
            if (!lua_isfunction(lua, place.index)) {
                refuse(lua, place, given_text(lua, place.index));
            }
            argument.stack_index = place.index;
            break;
        default:
            check_tables(lua, place, argument);
    }
}

void take_default(const Parameter& parameter, PlainArgument& argument) {
    const std::string_view fallback = parameter.fallback;
    if (fallback == "nil") {
        return;
    }
    switch (parameter.type) {
        case ParameterType::number:
        case ParameterType::integer:
            argument.number = std::strtod(parameter.fallback, nullptr);
            break;
        case ParameterType::flag:
            argument.flag = fallback == "true";
            break;
        case ParameterType::vector: {
            double v[3] = {0, 0, 0};
            if (std::sscanf(parameter.fallback, "{%lf, %lf, %lf}", &v[0], &v[1], &v[2]) == 3) {
                argument.vector = Vector3(v[0], v[1], v[2]);
            }
            break;
        }
        default:
            argument.text = fallback;
    }
}

/// A value on top of the stack that stands in a record without a name.
[[noreturn]] void refuse_nameless(lua_State* lua, const std::string& called,
                                  const std::string& such_as) {
    const char* advice = lua_type(lua, -1) == LUA_TNUMBER
                             ? "; a fraction has a point, 1.5, and a place has braces, {0, 1, 0}"
                             : "";
    raise_in_lesson(lua, called + " takes fields with names, such as { " + such_as + " = … }; " +
                             given_text(lua, -1) + " has none" + advice);
}

/// "a, b and c".
std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const char* before = i == 0 ? "" : i + 1 == words.size() ? " and " : ", ";
        text += before + words[i];
    }
    return text;
}

/// A field that the record hasn't.
[[noreturn]] void refuse_field(lua_State* lua, const std::string& called, const std::string& name,
                               const std::vector<std::string>& known) {
    std::string problem = called + " has no field \"" + name + "\"; ";
    if (const std::string near = nearest_word(name, known); near.empty()) {
        problem += "it has ";
        problem += listed(known);
    } else {
        problem += "did you mean \"";
        problem += near;
        problem += "\"?";
    }
    raise_in_lesson(lua, problem);
}

/// Every field of the record at `index` is one of those.
void check_field_names(lua_State* lua, int index, const std::string& called,
                       std::span<const Parameter> known_fields) {
    std::vector<std::string> known;
    for (const Parameter& field : known_fields) {
        known.emplace_back(field.name);
    }
    for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
        if (lua_type(lua, -2) != LUA_TSTRING) {
            refuse_nameless(lua, called, known.front());
        }
        std::size_t length = 0;
        const char* const text = lua_tolstring(lua, -2, &length);
        if (std::find(known.begin(), known.end(), std::string_view(text, length)) == known.end()) {
            refuse_field(lua, called, clean_text(text, kMaxShownBytes), known);
        }
    }
}

/// The value at `index`, or its default, or the error that it is missing; no record.
PlainArgument check_plain(lua_State* lua, const Parameter& parameter, std::string label,
                          int index) {
    PlainArgument argument;
    if (!lua_isnoneornil(lua, index)) {
        argument.given = true;
        check_given(lua, Place{parameter, std::move(label), index}, argument);
    } else if (parameter.fallback == kRequired) {
        const std::string range = range_text(parameter);
        raise_in_lesson(lua, label + " is missing; it is " + type_words(parameter.type) +
                                 (range.empty() ? "" : " " + range));
    } else {
        take_default(parameter, argument);
    }
    return argument;
}

bool holds_function(const PlainArgument& argument) {
    return argument.stack_index != 0;
}
bool holds_function(const Argument& argument) {
    return argument.stack_index != 0 ||
           std::ranges::any_of(argument.fields, [](const auto& of) { return holds_function(of); });
}

/// A field of the record at `record` by `check(its index)`. Nothing of it stays on the stack, but what holds a function for the call.
template <class Check>
auto check_field(lua_State* lua, int record, const char* name, Check check) {
    const int top = lua_gettop(lua);
    lua_pushstring(lua, name);
    lua_rawget(lua, record);
    auto argument = check(top + 1);
    if (!holds_function(argument)) {
        lua_settop(lua, top);
    }
    return argument;
}

std::vector<PlainArgument> check_record(lua_State* lua, const Place& place) {
    if (!lua_istable(lua, place.index)) {
        refuse(lua, place, given_text(lua, place.index));
    }
    const std::span<const Parameter> fields(place.parameter.fields, place.parameter.n_fields);
    check_field_names(lua, place.index, place.label, fields);
    std::vector<PlainArgument> arguments;
    for (const Parameter& field : fields) {
        arguments.push_back(check_field(lua, place.index, field.name, [&](int index) {
            return check_plain(lua, field, place.label + '.' + field.name, index);
        }));
    }
    return arguments;
}

Argument check_one(lua_State* lua, const Parameter& parameter, std::string label, int index) {
    if (parameter.type != ParameterType::record || lua_isnoneornil(lua, index)) {
        return {check_plain(lua, parameter, std::move(label), index), {}};
    }
    Argument argument;
    argument.given = true;
    argument.fields = check_record(lua, Place{parameter, std::move(label), index});
    return argument;
}

}  // namespace

Vector3 check_vector(lua_State* lua, const Place& place) {
    if (lua_type(lua, place.index) != LUA_TTABLE && to_handle(lua, place.index) == nullptr) {
        refuse(lua, place, given_text(lua, place.index));
    }
    constexpr const char* kAxes[] = {"x", "y", "z"};
    const int top = lua_gettop(lua);
    Vector3 v = Vector3::Zero();
    for (int i = 0; i < 3; ++i) {
        if (lua_type(lua, place.index) != LUA_TTABLE ||
            lua_rawgeti(lua, place.index, i + 1) == LUA_TNIL) {
            lua_getfield(lua, place.index, kAxes[i]);
        }
        if (lua_type(lua, -1) != LUA_TNUMBER) {
            raise_in_lesson(lua, place.label + " is a place such as {0, 0.5, 0}; its " + kAxes[i] +
                                     " is " + given_text(lua, -1));
        }
        v[i] = lua_tonumber(lua, -1);
        if (!(v[i] >= place.parameter.low && v[i] <= place.parameter.high)) {
            refuse(lua, place, given_text(lua, -1) + " for " + kAxes[i]);
        }
        lua_settop(lua, top);
    }
    return v;
}

std::string given_text(lua_State* lua, int index) {
    switch (lua_type(lua, index)) {
        case LUA_TNONE:
        case LUA_TNIL:
            return "nothing";
        case LUA_TNUMBER: {
            char text[32];
            std::snprintf(text, sizeof(text), "%.14g", lua_tonumber(lua, index));
            return text;
        }
        case LUA_TBOOLEAN:
            return lua_toboolean(lua, index) != 0 ? "true" : "false";
        case LUA_TSTRING: {
            std::size_t n = 0;
            const char* text = lua_tolstring(lua, index, &n);
            return "the text \"" + clean_text({text, n}, kMaxShownBytes) + '"';
        }
        case LUA_TFUNCTION:
            return "a function";
        case LUA_TTABLE:
            return "a table";
        default:
            return text_of(lua, index);
    }
}

Arguments check_arguments(lua_State* lua, int first, const Binding& binding) {
    std::vector<Argument> values;
    const std::string owner =
        *binding.owner == '\0'
            ? ""
            : std::string(binding.owner == std::string_view("lesson") ? "L" : binding.owner) + ':';
    const std::string called = owner + binding.name;
    std::size_t n_positional = binding.parameters.size();
    if (binding.shape != CallShape::positional) {
        n_positional = binding.shape == CallShape::record ? 0 : 1;
    }
    const int n_given = lua_gettop(lua) - first + 1;
    const int n_most =
        static_cast<int>(n_positional) + (binding.shape == CallShape::positional ? 0 : 1);
    if (n_given > n_most) {
        raise_in_lesson(lua, called + " takes " + std::to_string(n_most) +
                                 (n_most == 1 ? " value" : " values") + "; got " +
                                 std::to_string(n_given));
    }
    for (std::size_t i = 0; i < n_positional; ++i) {
        const Parameter& parameter = binding.parameters[i];
        const std::string label = n_positional == 1 && binding.shape == CallShape::positional
                                      ? called
                                      : called + "'s " + parameter.name;
        values.push_back(check_one(lua, parameter, label, first + static_cast<int>(i)));
    }
    if (binding.shape == CallShape::positional) {
        return {binding.parameters, std::move(values)};
    }
    // The record: nothing at all is an empty one.
    const int record = first + static_cast<int>(n_positional);
    if (lua_isnoneornil(lua, record)) {
        lua_settop(lua, record - 1);
        lua_newtable(lua);
    } else if (!lua_istable(lua, record)) {
        raise_in_lesson(lua,
                        called + " takes a table of fields { … }; got " + given_text(lua, record));
    }
    const std::span<const Parameter> parameters(binding.parameters);
    check_field_names(lua, record, binding.name, parameters.subspan(n_positional));
    for (std::size_t i = n_positional; i < binding.parameters.size(); ++i) {
        const Parameter& parameter = binding.parameters[i];
        values.push_back(check_field(lua, record, parameter.name, [&](int index) {
            return check_one(lua, parameter, std::string(binding.name) + '.' + parameter.name,
                             index);
        }));
    }
    assert(lua_gettop(lua) == record || std::ranges::any_of(values, [](const Argument& argument) {
               return holds_function(argument);
           }));
    return {binding.parameters, std::move(values)};
}

}  // namespace fulcrum::runtime
