// The one table of what a lesson can call: from it come registration, checks of arguments, editor annotations and the
// reference page. A row names a function, its parameters with type, unit, range and default, and one line of text.
//
// Thread: built once, then read only.
#pragma once

#include "haptics/geometry/shape.h"
#include "haptics/math/spatial.h"
#include "runtime/effect/field_list.h"
#include "runtime/scene/lesson_limits.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

struct lua_State;

namespace fulcrum::runtime {

struct LessonContext;
struct LibraryModule;

/// How a function is written in Lua.
enum class CallShape : std::uint8_t {
    positional,    ///< world:gravity(9.81)
    record,        ///< world:body { name = "apple" }
    named_record,  ///< L:question "heaviest" { … }: the first parameter, then the record
};

/// When a function may be called.
enum class CallTime : std::uint8_t {
    loading,    ///< while the file is read
    declaring,  ///< in L:start only
    acting,     ///< in L:start and after
    looking,    ///< always, in simulated hands too
};

/// What a parameter was given as, checked; a record's fields apart.
struct PlainArgument {
    bool given = false;
    double number = 0.0;
    bool flag = false;
    std::string text;
    Vector3 vector{Vector3::Zero()};
    std::vector<std::string> texts;
    std::vector<std::pair<std::string, std::vector<std::string>>> lists;  ///< sorted by name
    std::vector<std::pair<std::string, std::string>> values;  ///< of rules too; sorted by name
    int stack_index = 0;                                      ///< of a function
    std::int32_t material = -1;                               ///< of the description
    std::vector<PlacedBox> boxes;
};

struct Argument : PlainArgument {
    std::vector<PlainArgument> fields;  ///< of a record
};

/// The checked arguments of one call, found by the parameter's name.
class Arguments {
  public:
    Arguments(std::span<const Parameter> parameters, std::vector<Argument> values)
        : parameters_(parameters), values_(std::move(values)) {}
    /// The argument of that name; the name is one of the parameters' (asserted).
    [[nodiscard]] const Argument& operator[](std::string_view name) const;
    /// The fields of the record of that name.
    [[nodiscard]] Arguments record(std::string_view name) const;

  private:
    [[nodiscard]] std::size_t place_of(std::string_view name) const;
    std::span<const Parameter> parameters_;
    std::vector<Argument> values_;
};

/// Does the work: arguments are checked; pushes its results and returns their number.
using BoundFunction = int (*)(lua_State* lua, LessonContext& context, const Arguments& arguments);

struct Binding {
    const char* owner;  ///< "world", "hand", "body", "force", "lesson", or "" for a global
    const char* name;
    CallShape shape;
    CallTime time;
    std::vector<Parameter> parameters;
    const char* result;  ///< type for the annotations, e.g. "Body"; empty for none
    const char* text;
    BoundFunction call;
};

/// A field that is read as body.mass. Pushes one value.
struct Property {
    const char* owner;  ///< "world", "body", "material", "tool" or "force"
    const char* name;
    const char* type;  ///< for the annotations
    const char* unit;
    const char* text;
    int (*get)(lua_State* lua, LessonContext& context, std::int32_t index);
};

/// A function that a lesson may define.
struct Callback {
    const char* name;
    std::vector<std::pair<const char*, const char*>> parameters;  ///< name, type
    const char* text;
};

struct ApiTable {
    std::vector<Binding> functions;
    std::vector<Property> properties;
    std::vector<Callback> callbacks;
};

/// The whole of it.
[[nodiscard]] const ApiTable& api_table();

// Its parts, one a wrap_*.cpp.
void add_lesson_api(ApiTable& table);
void add_declaration_api(ApiTable& table);
void add_hand_api(ApiTable& table);
void add_action_api(ApiTable& table);
void add_room_api(ApiTable& table);
void add_tool_api(ApiTable& table);
void add_material_api(ApiTable& table);
void add_body_api(ApiTable& table);
void add_hinge_api(ApiTable& table);
void add_force_api(ApiTable& table);
void add_kite_api(ApiTable& table);

/// The LuaLS annotations (scripts/meta/fulcrum.lua).
[[nodiscard]] std::string make_annotations(const ApiTable& table);
/// The reference page (scripts/meta/reference.md), with the modules of scripts/lib.
[[nodiscard]] std::string make_reference(const ApiTable& table,
                                         const std::vector<LibraryModule>& library);
/// "kilograms, 0 to 10000", as errors and texts say it; empty when there is nothing to say.
[[nodiscard]] std::string range_text(const Parameter& parameter);
/// The names of a choice.
[[nodiscard]] std::vector<std::string> choices_of(const Parameter& parameter);
/// The candidate that `word` most likely stands for: the same shape by another name, or as it is written or as it is heard, at most
/// `most_steps` letters away; empty when none is so near.
[[nodiscard]] std::string nearest_word(std::string_view word,
                                       const std::vector<std::string>& candidates,
                                       std::size_t most_steps = 3);

/// Who has a name that something else was asked for: "hand:force (world:hand gives the hand)", several with "or" between;
/// empty when nothing has it.
[[nodiscard]] std::string owner_of_name(const ApiTable& table, std::string_view name);

}  // namespace fulcrum::runtime
