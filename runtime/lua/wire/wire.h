// The bytes that the program and a lesson's process send each other: every message, its limits, and
// its checks.
//
//   u32 length of the rest · u8 WireKind · the fields in order, little endian (text: u32 length,
//   then UTF-8)
//
// The program trusts nothing that a lesson's process sends: a decoder checks every length, count,
// number, name, index and text against the limits here, and gives an Error at the first that is
// wrong. Nothing is kept of a bad message.
//
// Thread: any. Cost: one pass over the bytes.
#pragma once

#include "haptics/base/error.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_messages.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace fulcrum::runtime {

inline constexpr std::size_t kMaxSourceBytes = 512U << 10U;  ///< one Lua file
inline constexpr std::size_t kMaxMessageBytes = 2U << 20U;   ///< program -> lesson
inline constexpr std::size_t kMaxAnswerBytes = 512U << 10U;  ///< lesson -> program
inline constexpr std::size_t kMaxNameBytes = 48;    ///< ids, names of bodies, models, sounds, keys
inline constexpr std::size_t kMaxTextBytes = 1000;  ///< captions, prompts, templates, prints
inline constexpr std::size_t kMaxCommands = 256;    ///< in one reply
inline constexpr std::size_t kMaxEvents = 1024;     ///< in one frame
inline constexpr std::size_t kMaxQuestions = 200;
inline constexpr std::size_t kMaxListItems = 200;  ///< answers, list words, test lines, slots
inline constexpr double kMaxCoordinate_m = 1e4;
inline constexpr double kMaxSpeed_m_per_s = 1e3;
/// What the program tells of the scene is within this, whatever unit it has: a tool at the edge of a scene is beyond what a lesson may say,
/// and a body that has fallen for long. What a lesson says back of it is within it too.
inline constexpr double kMaxTold = 1e9;
inline constexpr double kMaxLessonForce_N =
    100.0;  ///< of a lesson's force function; the gate limits far below
inline constexpr double kMaxLessonTorque_Nm = 10.0;                  ///< likewise, about the tool
inline constexpr double kMaxLessonStiffness_N_per_m = 5000.0;        ///< each entry of dF/dx
inline constexpr double kMaxLessonDamping_Ns_per_m = 100.0;          ///< each entry of dF/dv
inline constexpr double kMaxLessonTorqueStiffness_Nm_per_m = 500.0;  ///< each entry of dT/dx

enum class WireKind : std::uint8_t {
    load,            ///< program -> lesson: LoadMessage
    module_answer,   ///< program -> lesson: ModuleAnswer
    frame,           ///< program -> lesson: LessonFrame
    module_request,  ///< lesson -> program: ModuleRequest, while loading
    print,           ///< lesson -> program: PrintCommand, while loading
    description,     ///< lesson -> program: LessonDescription; loading has succeeded
    reply,           ///< lesson -> program: LessonReply
    error,           ///< lesson -> program: ScriptError; the process ends after it
};

/// A Lua file: the name that errors show, and its text. No text: there is no such file.
struct LuaSource {
    std::string name;
    std::string text;
};

/// What a lesson's process is told first.
struct LoadMessage {
    LuaSource lesson;
    LuaSource hand;                           ///< the simulated hand's file; empty name for none
    std::uint64_t seed = 1;                   ///< of math.random
    std::uint64_t memory_bytes = 64U << 20U;  ///< each Lua state
    std::uint64_t load_instructions = 0;      ///< budget of loading and start
    std::uint64_t frame_instructions = 0;     ///< budget of one frame
    LuaSource second_hand{};                  ///< likewise of another simulated hand
};

/// `require "name"`.
struct ModuleRequest {
    std::string name;
};

/// The module's text, or why there is none.
struct ModuleAnswer {
    bool found = false;
    LuaSource source;
    std::string problem;  ///< a clause, when not found
};

/// A Lua error with its place.
struct ScriptError {
    std::string message;    ///< a clause without place and full stop
    std::string file;       ///< empty when unknown
    std::int32_t line = 0;  ///< 0 when unknown
};

/// As the program tells it: where is "file:line" as far as known.
[[nodiscard]] Error to_error(const ScriptError& error);

using Bytes = std::vector<std::uint8_t>;

/// Appends the whole message, length and kind first, to `out`. Sending checks nothing: the receiver
/// does.
void encode(const LoadMessage& message, Bytes& out);
void encode(const ModuleRequest& message, Bytes& out);
void encode(const ModuleAnswer& message, Bytes& out);
void encode(const PrintCommand& message, Bytes& out);
void encode(const LessonDescription& message, Bytes& out);
void encode(const LessonFrame& message, Bytes& out);
void encode(const LessonReply& message, Bytes& out);
void encode(const ScriptError& message, Bytes& out);

/// `bytes` is what follows the kind. Each fails with one clause that names the field.
[[nodiscard]] Expected<LoadMessage> decode_load(std::span<const std::uint8_t> bytes);
[[nodiscard]] Expected<ModuleRequest> decode_module_request(std::span<const std::uint8_t> bytes);
[[nodiscard]] Expected<ModuleAnswer> decode_module_answer(std::span<const std::uint8_t> bytes);
[[nodiscard]] Expected<PrintCommand> decode_print(std::span<const std::uint8_t> bytes);
[[nodiscard]] Expected<LessonDescription> decode_description(std::span<const std::uint8_t> bytes);
[[nodiscard]] Expected<LessonFrame> decode_frame(std::span<const std::uint8_t> bytes);
/// Indices of bodies and forces and names of questions are checked against the lesson's own
/// `description`.
[[nodiscard]] Expected<LessonReply> decode_reply(std::span<const std::uint8_t> bytes,
                                                 const LessonDescription& description);
[[nodiscard]] Expected<ScriptError> decode_error(std::span<const std::uint8_t> bytes);

/// True when `text` is a name: 1 to kMaxNameBytes of a-z, 0-9, '_' and '-', the first a letter or
/// digit.
[[nodiscard]] bool is_name(std::string_view text);
/// True when `text` is the name of a picture beside a lesson: letters, digits, blanks, '_', '-' and '.', not first a '.' or a
/// blank, kMaxNameBytes at most, ending in .png, .jpg or .jpeg, in capitals or not.
[[nodiscard]] bool is_picture_name(std::string_view text);
/// True when `text` is UTF-8 without overlong forms or surrogates, and has no control characters
/// but newline and tab.
[[nodiscard]] bool is_clean_utf8(std::string_view text);

}  // namespace fulcrum::runtime
