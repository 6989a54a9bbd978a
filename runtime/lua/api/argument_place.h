// Where one argument of one call is, and how a wrong one is refused. For check_arguments.cpp and its neighbours.
//
// Thread: that of the lesson's process.
#pragma once

#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/api/lesson_context.h"

#include <string>

namespace fulcrum::runtime {

/// Names longer than this are shortened in errors.
inline constexpr std::size_t kMaxShownBytes = 40;

/// One parameter of one call: where to find it, and how errors call it.
struct Place {
    const Parameter& parameter;
    std::string label;
    int index;
};

/// "a number", "a list of texts": what a type is, for people.
[[nodiscard]] const char* type_words(ParameterType type);
/// Raises: the argument is not what its parameter says; `got` is what was given.
[[noreturn]] void refuse(lua_State* lua, const Place& place, const std::string& got);
/// The text at stack index `index`, clean and of at most so many bytes, or raises.
[[nodiscard]] std::string check_text(lua_State* lua, const Place& place, int index,
                                     std::size_t max_bytes);
/// {x, y, z}, {x=, y=, z=}, a body or the tool, each within the parameter's range.
[[nodiscard]] Vector3 check_vector(lua_State* lua, const Place& place);
/// Lists and tables of texts, values and boxes.
void check_tables(lua_State* lua, const Place& place, PlainArgument& argument);

}  // namespace fulcrum::runtime
