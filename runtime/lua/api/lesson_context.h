// What the functions of a lesson work on, on the lesson's side: what it has declared, how things stand, what it wants.
//
// Thread: that of the lesson's process.
#pragma once

#include "runtime/lua/api/binding_table.h"
#include "runtime/lua/sandbox/script_state.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_messages.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::runtime {

/// What a script is doing now: it decides what it may call.
enum class LessonPhase : std::uint8_t { loading, starting, running };

/// A thing in Lua: full userdata holding one of these. An old handle is refused by its generation.
struct Handle {
    enum class Kind : std::uint8_t { world, tool, body, force, hand, material, kite };
    Kind kind = Kind::world;
    std::int32_t index = 0;
    std::uint32_t generation = 0;
};

/// What a part of a lesson may need of another.
enum class Need : std::uint8_t {
    bucket,   ///< world:bucket
    movable,  ///< a body that is movable, so that there is a world that moves bodies
    kite,     ///< world:kite
    hands,    ///< a second world:hand
};

struct LessonContext {
    LessonPhase phase = LessonPhase::loading;
    bool is_hand = false;          ///< a simulated hand: it looks and does nothing
    std::uint32_t generation = 1;  ///< of every handle of this scene
    LessonDescription description{};
    LessonFrame frame{};                ///< the newest; its bodies are as many as the description's
    std::vector<double> felt_weight_N;  ///< empty before ReadyEvent
    std::optional<double> day;          ///< nothing before ReadyEvent
    std::vector<PastAnswers> past;      ///< empty before ReadyEvent
    std::vector<KnownLesson> lessons;   ///< likewise
    std::vector<MaterialGrades> grades;   ///< one a material; empty before ReadyEvent
    LessonReply reply{};                  ///< being filled
    int n_prints = 0;                     ///< in this frame
    std::vector<FieldCommand> fields;     ///< how each declared force stands
    std::vector<bool> covered;            ///< by body, as far as any was covered
    std::optional<KiteDescription> kite;  ///< as it was built last
    int lesson_ref = LUA_NOREF;           ///< the table that lesson{} gave
    std::size_t most_hands = 1;           ///< as lesson{} says
    std::size_t n_hands = 0;              ///< how often world:hand was called
    int force_function_ref = LUA_NOREF;
    std::vector<std::pair<std::string, int>> judges;   ///< question -> its `right`
    std::vector<std::pair<std::string, int>> tellers;  ///< what is known -> its `answer`
    std::int32_t touched = kNoBody;                    ///< the body that was touched last
    std::vector<int> listeners;                        ///< L:listen
    std::vector<std::pair<Need, ScriptError>> needs;   ///< noted in L:start, judged after it
};

/// How many hands somebody moves.
[[nodiscard]] inline std::size_t count_hands(const LessonFrame& frame) noexcept {
    return 1 + frame.more_hands.size();
}

/// The context of the script that runs.
[[nodiscard]] LessonContext& context_of(lua_State* lua) noexcept;
/// A getter's result.
inline int push_text(lua_State* lua, const std::string& text) {
    lua_pushlstring(lua, text.data(), text.size());
    return 1;
}
/// Adds a command to the reply; raises when there are too many.
void add_command(lua_State* lua, LessonCommand command);

/// Pushes the one object that stands for a thing; the same each time, so that == and table keys work.
void push_handle(lua_State* lua, Handle::Kind kind, std::int32_t index);
/// The handle at `index` if it is of this kind and of this scene; raises otherwise, naming the function called.
[[nodiscard]] Handle check_handle(lua_State* lua, int index, Handle::Kind kind, const char* called);
/// Is it a handle of that kind? (of whatever generation)
[[nodiscard]] const Handle* to_handle(lua_State* lua, int index);
/// Pushes {x, y, z} that also has fields x, y and z.
void push_vector(lua_State* lua, const Vector3& v);

/// Puts metatables of all handles and the global functions into the state, and makes its globals strict.
void register_api(lua_State* lua);
/// Reading a global that was never assigned raises a sentence from now on.
void make_globals_strict(lua_State* lua);
/// Puts what the shared library gets from the program into the registry, as kLibraryServices.
void register_library_services(lua_State* lua);
/// What was given, as people say it: "nothing", "3", "the text \"x\"", "a table".
[[nodiscard]] std::string given_text(lua_State* lua, int index);
/// Checks the arguments of `binding` from stack index `first` on; raises the sentence that says what is wrong.
[[nodiscard]] Arguments check_arguments(lua_State* lua, int first, const Binding& binding);

}  // namespace fulcrum::runtime
