// Checks what a lesson passes, by the binding table's types, units and ranges, and says what is wrong in one sentence.
#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"
#include "runtime/lua/sandbox/safe_library.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kMaxShownBytes = 40;

const char* type_words(ParameterType type) {
    switch (type) {
        case ParameterType::number:
            return "a number";
        case ParameterType::integer:
            return "a whole number";
        case ParameterType::flag:
            return "true or false";
        case ParameterType::text:
            return "a text";
        case ParameterType::name:
            return "a plain name (a to z, 0 to 9, _ and -)";
        case ParameterType::vector:
            return "a place such as {0, 0.5, 0}";
        case ParameterType::function:
            return "a function";
        case ParameterType::texts:
            return "a list of texts";
        case ParameterType::lists:
            return "a table of lists of texts";
        case ParameterType::values:
            return "a table of numbers and texts";
    }
    return "something else";
}

/// One parameter of one call: where to find it, and how errors call it.
struct Place {
    const Parameter& parameter;
    std::string label;
    int index;
};

[[noreturn]] void refuse(lua_State* lua, const Place& place, const std::string& got) {
    const std::string range = range_text(place.parameter);
    // A number that is merely too large needs no lesson about types.
    const bool only_range =
        lua_type(lua, place.index) == LUA_TNUMBER && place.parameter.type == ParameterType::number;
    const std::string type = only_range ? "" : type_words(place.parameter.type);
    const std::string gap = type.empty() || range.empty()                              ? ""
                            : *place.parameter.unit != '\0' || range.starts_with("of") ? " "
                                                                                       : ", ";
    raise_in_lesson(lua, place.label + " is " + type + gap + range + "; got " + got);
}

std::string check_text(lua_State* lua, const Place& place, int index, std::size_t max_bytes) {
    if (lua_type(lua, index) != LUA_TSTRING) {
        refuse(lua, place, given_text(lua, index));
    }
    std::size_t n = 0;
    const char* text = lua_tolstring(lua, index, &n);
    if (n > max_bytes) {
        refuse(lua, place, std::to_string(n) + " bytes");
    }
    if (!is_clean_utf8({text, n})) {
        raise_in_lesson(lua, place.label + " is no clean UTF-8 text; save the file as UTF-8");
    }
    return {text, n};
}

double check_number(lua_State* lua, const Place& place, int index) {
    const double value = lua_tonumber(lua, index);
    if (lua_type(lua, index) != LUA_TNUMBER ||
        !(value >= place.parameter.low && value <= place.parameter.high)) {
        refuse(lua, place, given_text(lua, index));
    }
    return value;
}

/// {x, y, z}, {x=, y=, z=}, a body or the tool.
Vector3 check_vector(lua_State* lua, const Place& place) {
    if (lua_type(lua, place.index) != LUA_TTABLE && to_handle(lua, place.index) == nullptr) {
        refuse(lua, place, given_text(lua, place.index));
    }
    constexpr const char* kAxes[] = {"x", "y", "z"};
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
        lua_settop(lua, std::max(place.index, lua_gettop(lua) - 1));
    }
    return v;
}

std::vector<std::string> check_texts(lua_State* lua, const Place& place, int index) {
    if (!lua_istable(lua, index)) {
        refuse(lua, place, given_text(lua, index));
    }
    index = lua_absindex(lua, index);
    const std::size_t n = lua_rawlen(lua, index);
    if (n > kMaxListItems) {
        raise_in_lesson(lua, place.label + " has " + std::to_string(n) + " items; " +
                                 std::to_string(kMaxListItems) + " are the most");
    }
    std::vector<std::string> texts;
    for (std::size_t i = 1; i <= n; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i));
        texts.push_back(check_text(lua, place, -1, kMaxTextBytes));
        lua_pop(lua, 1);
    }
    return texts;
}

/// Goes through a table with text keys, in the order of the keys.
template <class Each>
void for_each_name(lua_State* lua, const Place& place, Each each) {
    if (!lua_istable(lua, place.index)) {
        refuse(lua, place, given_text(lua, place.index));
    }
    std::vector<std::string> names;
    for (lua_pushnil(lua); lua_next(lua, place.index) != 0; lua_pop(lua, 1)) {
        if (lua_type(lua, -2) != LUA_TSTRING || names.size() >= kMaxListItems) {
            raise_in_lesson(lua, place.label + " is a table with at most " +
                                     std::to_string(kMaxListItems) + " named items");
        }
        names.push_back(check_text(lua, place, -2, kMaxNameBytes));
    }
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) {
        lua_pushlstring(lua, name.data(), name.size());
        lua_rawget(lua, place.index);
        each(name);
        lua_pop(lua, 1);
    }
}

std::string check_value(lua_State* lua, const Place& place) {
    if (lua_type(lua, -1) == LUA_TBOOLEAN) {
        return lua_toboolean(lua, -1) != 0 ? "true" : "false";
    }
    if (lua_type(lua, -1) == LUA_TNUMBER) {
        lua_pushvalue(lua, -1);
        std::string text = lua_tostring(lua, -1);
        lua_pop(lua, 1);
        return text;
    }
    return check_text(lua, place, -1, kMaxTextBytes);
}

void check_tables(lua_State* lua, const Place& place, Argument& argument) {
    if (place.parameter.type == ParameterType::texts) {
        argument.texts = check_texts(lua, place, place.index);
    } else if (place.parameter.type == ParameterType::lists) {
        for_each_name(lua, place, [&](const std::string& name) {
            if (!is_name(name)) {
                raise_in_lesson(lua, place.label + " has a list \"" +
                                         clean_text(name, kMaxShownBytes) +
                                         "\"; a list's name is plain (a to z, 0 to 9, _ and -)");
            }
            argument.lists.emplace_back(name, check_texts(lua, place, -1));
        });
    } else {
        for_each_name(lua, place, [&](const std::string& name) {
            argument.values.emplace_back(name, check_value(lua, place));
        });
    }
}

void check_given(lua_State* lua, const Place& place, Argument& argument) {
    switch (place.parameter.type) {
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

void take_default(const Parameter& parameter, Argument& argument) {
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

/// The value at `index`, or its default, or the error that it is missing.
Argument check_one(lua_State* lua, const Parameter& parameter, std::string label, int index) {
    Argument argument;
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

/// Every field of the record at `index` is one of the parameters from `first_parameter` on.
void check_field_names(lua_State* lua, int index, const Binding& binding,
                       std::size_t first_parameter) {
    std::vector<std::string> known;
    for (std::size_t i = first_parameter; i < binding.parameters.size(); ++i) {
        known.emplace_back(binding.parameters[i].name);
    }
    for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
        if (lua_type(lua, -2) != LUA_TSTRING) {
            raise_in_lesson(lua, std::string(binding.name) +
                                     " takes fields with names, such as { " + known.front() +
                                     " = … }");
        }
        const std::string name = clean_text(lua_tostring(lua, -2), kMaxShownBytes);
        if (std::find(known.begin(), known.end(), name) == known.end()) {
            const std::string near = nearest_word(name, known);
            raise_in_lesson(lua, std::string(binding.name) + " has no field \"" + name + '"' +
                                     (near.empty() ? "" : "; did you mean \"" + near + "\"?"));
        }
    }
}

}  // namespace

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
        return {binding, std::move(values)};
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
    check_field_names(lua, record, binding, n_positional);
    for (std::size_t i = n_positional; i < binding.parameters.size(); ++i) {
        const Parameter& parameter = binding.parameters[i];
        lua_pushstring(lua, parameter.name);
        lua_rawget(lua, record);
        values.push_back(check_one(lua, parameter, std::string(binding.name) + '.' + parameter.name,
                                   lua_gettop(lua)));
    }
    return {binding, std::move(values)};
}

}  // namespace fulcrum::runtime
