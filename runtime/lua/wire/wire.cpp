#include "runtime/lua/wire/wire.h"

#include "runtime/lua/wire/wire_archive.h"
#include "runtime/lua/wire/wire_layout.h"

#include <cstring>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::uint64_t kMaxBudget = 1'000'000'000'000;
constexpr std::uint64_t kMaxMemoryBytes = 256U << 20U;

template <class Archive, class Source>
void source(Archive& a, Source& value) {
    a.text("a file's name", value.name, 256);
    a.source_text("a file's text", value.text);
}

template <class Archive, class Load>
void load(Archive& a, Load& value) {
    source(a, value.lesson);
    source(a, value.hand);
    a.integer("seed", value.seed, 0, INT64_MAX);
    a.integer("memory", value.memory_bytes, 1, kMaxMemoryBytes);
    a.integer("budget", value.load_instructions, 0, kMaxBudget);
    a.integer("budget", value.frame_instructions, 0, kMaxBudget);
    source(a, value.second_hand);
}

template <class Archive, class Answer>
void module_answer(Archive& a, Answer& value) {
    a.flag("found", value.found);
    source(a, value.source);
    a.text("problem", value.problem, kMaxTextBytes);
}

template <class Archive, class AnyError>
void script_error(Archive& a, AnyError& value) {
    a.text("an error's message", value.message, kMaxTextBytes);
    a.text("an error's file", value.file, 256);
    a.integer("an error's line", value.line, 0, 10'000'000);
}

/// Length and kind first, then what `fields` writes.
template <class Fields>
void frame_message(WireKind kind, Bytes& out, Fields fields) {
    const std::size_t start = out.size();
    wire::Writer writer(out);
    writer.raw(std::uint32_t{0});
    writer.raw(static_cast<std::uint8_t>(kind));
    fields(writer);
    const auto length = static_cast<std::uint32_t>(out.size() - start - sizeof(std::uint32_t));
    std::memcpy(out.data() + start, &length, sizeof(length));
}

template <class T, class Fields>
Expected<T> read_message(std::span<const std::uint8_t> bytes, Fields fields) {
    wire::Reader reader(bytes);
    T value;
    fields(reader, value);
    return reader.result(std::move(value));
}

}  // namespace

Error to_error(const ScriptError& error) {
    std::string where = error.file;
    if (!where.empty() && error.line > 0) {
        where += ':' + std::to_string(error.line);
    }
    return Error{error.message, std::move(where), {}};
}

void encode(const LoadMessage& message, Bytes& out) {
    frame_message(WireKind::load, out, [&](auto& a) { load(a, message); });
}
void encode(const ModuleRequest& message, Bytes& out) {
    frame_message(WireKind::module_request, out,
                  [&](auto& a) { a.text("module", message.name, kMaxNameBytes); });
}
void encode(const ModuleAnswer& message, Bytes& out) {
    frame_message(WireKind::module_answer, out, [&](auto& a) { module_answer(a, message); });
}
void encode(const PrintCommand& message, Bytes& out) {
    frame_message(WireKind::print, out,
                  [&](auto& a) { a.text("print", message.text, kMaxTextBytes); });
}
void encode(const LessonDescription& message, Bytes& out) {
    frame_message(WireKind::description, out, [&](auto& a) { wire::description(a, message); });
}
void encode(const LessonFrame& message, Bytes& out) {
    frame_message(WireKind::frame, out, [&](auto& a) { wire::frame(a, message); });
}
void encode(const LessonReply& message, Bytes& out) {
    frame_message(WireKind::reply, out,
                  [&](auto& a) { wire::reply(a, message, wire::ReplyBounds{}); });
}
void encode(const ScriptError& message, Bytes& out) {
    frame_message(WireKind::error, out, [&](auto& a) { script_error(a, message); });
}

Expected<LoadMessage> decode_load(std::span<const std::uint8_t> bytes) {
    return read_message<LoadMessage>(bytes, [](auto& a, auto& value) { load(a, value); });
}
Expected<ModuleRequest> decode_module_request(std::span<const std::uint8_t> bytes) {
    return read_message<ModuleRequest>(
        bytes, [](auto& a, auto& value) { a.text("module", value.name, kMaxNameBytes); });
}
Expected<ModuleAnswer> decode_module_answer(std::span<const std::uint8_t> bytes) {
    return read_message<ModuleAnswer>(bytes, [](auto& a, auto& value) { module_answer(a, value); });
}
Expected<PrintCommand> decode_print(std::span<const std::uint8_t> bytes) {
    return read_message<PrintCommand>(
        bytes, [](auto& a, auto& value) { a.text("print", value.text, kMaxTextBytes); });
}
Expected<LessonDescription> decode_description(std::span<const std::uint8_t> bytes) {
    return read_message<LessonDescription>(bytes, [](auto& a, auto& value) {
        wire::description(a, value);
        if (const char* problem = wire::find_contradiction(value); problem != nullptr) {
            a.refuse("the description", problem);
        }
    });
}
Expected<LessonFrame> decode_frame(std::span<const std::uint8_t> bytes) {
    return read_message<LessonFrame>(bytes, [](auto& a, auto& value) { wire::frame(a, value); });
}
Expected<LessonReply> decode_reply(std::span<const std::uint8_t> bytes,
                                   const LessonDescription& description) {
    const wire::ReplyBounds bounds{static_cast<std::int32_t>(description.bodies.size()),
                                   static_cast<std::int32_t>(description.forces.size()),
                                   &description};
    return read_message<LessonReply>(bytes,
                                     [&](auto& a, auto& value) { wire::reply(a, value, bounds); });
}
Expected<ScriptError> decode_error(std::span<const std::uint8_t> bytes) {
    return read_message<ScriptError>(bytes, [](auto& a, auto& value) { script_error(a, value); });
}

}  // namespace fulcrum::runtime
