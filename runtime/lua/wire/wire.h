// The bytes that the program and a lesson's process send each other: every message, and its checks.
//
//   u32 length of the rest · u8 WireKind · the fields in order, little endian (text: u32 length,
//   then UTF-8)
//
// The program trusts nothing that a lesson's process sends: a decoder checks every length, count,
// number, name, index and text against the limits of wire_limits.h, and gives an Error at the first that is
// wrong. Nothing is kept of a bad message.
//
// Thread: any. Cost: one pass over the bytes.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lua/wire/wire_limits.h"
#include "runtime/scene/description.h"
#include "runtime/scene/lesson_messages.h"

#include <cstdint>
#include <span>
#include <string>

namespace fulcrum::runtime {

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

}  // namespace fulcrum::runtime
