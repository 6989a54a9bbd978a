// Texts, and the tables that hold them, out of what a lesson passes; and the sentence for what is none.
#include "dialogue/unicode.h"
#include "runtime/lua/api/argument_place.h"
#include "runtime/lua/sandbox/safe_library.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {

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
        case ParameterType::rules:
            return "a table of texts with names";
        case ParameterType::values:
            return "a table of numbers, true and false";
        case ParameterType::choice:
            return "";
        case ParameterType::record:
            return "a table of fields { … }";
        case ParameterType::material:
            return "a material or the name of one";
        case ParameterType::boxes:
            return "a list of boxes { at = {x, y, z}, size = {x, y, z} }";
    }
    return "something else";
}

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
        refuse(lua, place, std::to_string(n) + " letters");
    }
    if (!is_clean_utf8({text, n})) {
        raise_in_lesson(lua, place.label + " is no clean UTF-8 text; save the file as UTF-8");
    }
    std::string whole = dialogue::composed({text, n});
    if (whole.size() > max_bytes) {  // some characters are longer in NFC
        refuse(lua, place, std::to_string(whole.size()) + " letters");
    }
    return whole;
}

namespace {

/// What has a name among the `n` texts of a list is an error: it would be passed over.
void check_only_items(lua_State* lua, const Place& place, int index, std::size_t n) {
    for (lua_pushnil(lua); lua_next(lua, index) != 0; lua_pop(lua, 1)) {
        if (lua_type(lua, -2) == LUA_TSTRING) {
            const std::string name = clean_text(lua_tostring(lua, -2), kMaxShownBytes);
            raise_in_lesson(lua,
                            place.label + " has a field \"" + name +
                                "\" among its texts; write texts alone, { \"…\", \"…\" }" +
                                (n == 0 ? "" : ", or a comma and a brace where it should end"));
        }
        if (lua_isinteger(lua, -2) == 0 || lua_tointeger(lua, -2) < 1 ||
            std::cmp_greater(lua_tointeger(lua, -2), n)) {
            raise_in_lesson(lua, place.label + " has nothing at one of its places before " +
                                     given_text(lua, -1) + "; is a name there that has no value?");
        }
    }
}

std::vector<std::string> check_texts(lua_State* lua, const Place& place, int index) {
    if (!lua_istable(lua, index)) {
        refuse(lua, place, given_text(lua, index) + "; put braces around it, { \"…\", \"…\" }");
    }
    index = lua_absindex(lua, index);
    const std::size_t n = lua_rawlen(lua, index);
    if (n > kMaxListItems) {
        raise_in_lesson(lua, place.label + " has " + std::to_string(n) + " items; " +
                                 std::to_string(kMaxListItems) + " are the most");
    }
    check_only_items(lua, place, index, n);
    std::vector<std::string> texts;
    const Parameter item{"", ParameterType::text, "", 0, static_cast<double>(kMaxTextBytes)};
    for (std::size_t i = 1; i <= n; ++i) {
        lua_rawgeti(lua, index, static_cast<lua_Integer>(i));
        const Place at{item, place.label + "[" + std::to_string(i) + "]", lua_gettop(lua)};
        if (lua_type(lua, -1) == LUA_TNUMBER) {
            const std::string number = given_text(lua, -1);
            refuse(lua, at,
                   std::string(number)
                       .append("; put it in quotation marks, \"")
                       .append(number)
                       .append("\""));
        }
        texts.push_back(check_text(lua, at, at.index, kMaxTextBytes));
        lua_pop(lua, 1);
    }
    return texts;
}

const char* example_of(ParameterType type) {
    return type == ParameterType::lists   ? ", such as { colour = { \"red\", \"blue\" } }"
           : type == ParameterType::rules ? ", such as { place = \"(on|under) the table\" }"
                                          : "";
}

/// Goes through a table with text keys, in the order of the keys.
template <class Each>
void for_each_name(lua_State* lua, const Place& place, Each each) {
    if (!lua_istable(lua, place.index)) {
        refuse(lua, place, given_text(lua, place.index));
    }
    std::vector<std::string> names;
    for (lua_pushnil(lua); lua_next(lua, place.index) != 0; lua_pop(lua, 1)) {
        if (lua_type(lua, -2) != LUA_TSTRING) {
            raise_in_lesson(lua, place.label + " has " + given_text(lua, -1) +
                                     " without a name; write { name = … }" +
                                     example_of(place.parameter.type));
        }
        if (names.size() >= kMaxListItems) {
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

/// The same where the names stand in templates.
template <class Each>
void for_each_plain_name(lua_State* lua, const Place& place, const std::string& what, Each each) {
    for_each_name(lua, place, [&](const std::string& name) {
        if (!is_name(name)) {
            raise_in_lesson(lua, place.label + " has a " + what + " \"" +
                                     clean_text(name, kMaxShownBytes) + "\"; a " + what +
                                     "'s name is plain (a to z, 0 to 9, _ and -)");
        }
        each(name);
    });
}

/// A box has a place and a size, and nothing else.
void check_box_names(lua_State* lua, const Place& box) {
    for (lua_pushnil(lua); lua_next(lua, box.index) != 0; lua_pop(lua, 1)) {
        const bool is_text = lua_type(lua, -2) == LUA_TSTRING;
        const std::string name = is_text ? clean_text(lua_tostring(lua, -2), kMaxShownBytes) : "";
        if (name == "at" || name == "size") {
            continue;
        }
        const std::string near = nearest_word(name, {"at", "size"});
        raise_in_lesson(lua, box.label +
                                 (is_text ? " has no field \"" + name + "\"; "
                                          : " has " + given_text(lua, -1) + " without a name; ") +
                                 (near.empty() ? "a box is { at = {x, y, z}, size = {x, y, z} }"
                                               : "did you mean \"" + near + "\"?"));
    }
}

/// A field of the box on top of the stack.
Vector3 check_box_field(lua_State* lua, const Place& box, const Parameter& field) {
    lua_getfield(lua, box.index, field.name);
    const Vector3 v = check_vector(lua, {field, box.label + '.' + field.name, lua_gettop(lua)});
    lua_pop(lua, 1);
    return v;
}

std::vector<PlacedBox> check_boxes(lua_State* lua, const Place& place) {
    constexpr Parameter kAt{"at", ParameterType::vector, "metres", -kFarthestBox_m, kFarthestBox_m};
    constexpr Parameter kSize{"size", ParameterType::vector, "metres", kLeastEdge_m, kMostEdge_m};
    if (!lua_istable(lua, place.index)) {
        refuse(lua, place, given_text(lua, place.index));
    }
    const std::size_t n = lua_rawlen(lua, place.index);
    if (n == 0 || n > kMaxBoxes) {
        raise_in_lesson(lua, place.label + " has " + std::to_string(n) + " boxes; give it 1 to " +
                                 std::to_string(kMaxBoxes));
    }
    std::vector<PlacedBox> boxes;
    for (std::size_t i = 1; i <= n; ++i) {
        lua_rawgeti(lua, place.index, static_cast<lua_Integer>(i));
        const Place box{place.parameter, place.label + '[' + std::to_string(i) + ']',
                        lua_gettop(lua)};
        if (!lua_istable(lua, box.index)) {
            raise_in_lesson(lua, box.label +
                                     " is a box { at = {x, y, z}, size = {x, y, z} }; got " +
                                     given_text(lua, box.index));
        }
        check_box_names(lua, box);
        boxes.push_back({check_box_field(lua, box, kAt), check_box_field(lua, box, kSize)});
        lua_pop(lua, 1);
    }
    return boxes;
}

/// A number, true or false, as text; `place` is the table's, `name` the field's.
std::string check_value(lua_State* lua, const Place& table, const std::string& name) {
    if (lua_type(lua, -1) == LUA_TBOOLEAN) {
        return lua_toboolean(lua, -1) != 0 ? "true" : "false";
    }
    if (lua_type(lua, -1) == LUA_TNUMBER) {
        lua_pushvalue(lua, -1);
        std::string text = lua_tostring(lua, -1);
        lua_pop(lua, 1);
        return text;
    }
    raise_in_lesson(
        lua, table.label + '.' + name + " is a number, true or false; got " + given_text(lua, -1) +
                 (lua_type(lua, -1) == LUA_TSTRING ? "; take its quotation marks away" : ""));
}

}  // namespace

void check_tables(lua_State* lua, const Place& place, PlainArgument& argument) {
    if (place.parameter.type == ParameterType::boxes) {
        argument.boxes = check_boxes(lua, place);
    } else if (place.parameter.type == ParameterType::texts) {
        argument.texts = check_texts(lua, place, place.index);
    } else if (place.parameter.type == ParameterType::lists) {
        for_each_plain_name(lua, place, "list", [&](const std::string& name) {
            Parameter words = place.parameter;
            words.type = ParameterType::texts;
            argument.lists.emplace_back(
                name, check_texts(lua, {words, place.label + '.' + name, lua_gettop(lua)},
                                  lua_gettop(lua)));
        });
    } else if (place.parameter.type == ParameterType::rules) {
        for_each_plain_name(lua, place, "rule", [&](const std::string& name) {
            Parameter rule = place.parameter;
            rule.type = ParameterType::text;
            rule.high = static_cast<double>(kMaxTextBytes);
            const int top = lua_gettop(lua);
            argument.values.emplace_back(
                name, check_text(lua, {rule, place.label + '.' + name, top}, top, kMaxTextBytes));
        });
    } else {
        for_each_name(lua, place, [&](const std::string& name) {
            argument.values.emplace_back(name, check_value(lua, place, name));
        });
    }
}

}  // namespace fulcrum::runtime
