// A lesson played in this process, and all that it sends looked at as the program looks at it: by encoding and decoding it.
#pragma once

#include "runtime/lua/host/lesson_host.h"
#include "tests/support/choices.h"
#include "tests/support/generated_values.h"

#include <string>
#include <vector>

namespace fulcrum::test {
using namespace runtime;

/// What both sides said.
struct BothSides {
    std::string lesson;  ///< why the lesson's side refused it; empty where it did not
    std::string
        program;  ///< why the program's side would not take what the lesson's side sent; empty where it did
    std::vector<std::string> prints;
};

inline constexpr std::size_t kMessageHead = 5;  // bytes

template <class Message>
std::span<const std::uint8_t> encoded(const Message& message, Bytes& bytes) {
    bytes.clear();
    encode(message, bytes);
    return std::span<const std::uint8_t>(bytes).subspan(kMessageHead);
}

/// A frame as far out as the wire lets one be: what the program hands to the lesson.
inline LessonFrame generated_frame(Choices& choices, const LessonDescription& description) {
    const auto number = [&] { return generated_number(choices, -kMaxTold, kMaxTold); };
    const auto vector = [&] { return Vector3(number(), number(), number()); };
    LessonFrame frame;
    frame.dt_s = 1.0 / 60.0;
    frame.time_s = generated_number(choices, 0.0, kMaxTold);
    frame.tool_pose_W.position = vector();
    frame.tool_twist_W = {vector(), vector()};
    frame.applied_W = {vector(), vector()};
    for (const BodyDescription& body : description.bodies) {
        BodyState state;
        state.pose_W.position = choices.chance(50) ? body.position_W : vector();
        state.velocity_W = vector();
        state.where = static_cast<BodyWhere>(choices.below(5));
        frame.bodies.push_back(state);
        if (body.hinge) {
            frame.hinges.push_back(
                {number(), number(), number(), std::abs(number()), number(), 1.0});
        }
    }
    frame.events = {ReadyEvent{}, KeyEvent{"space"}};
    for (std::size_t i = 0; i < description.bodies.size(); ++i) {
        frame.events.emplace_back(BodyEvent{static_cast<BodyEvent::Kind>(choices.below(4)),
                                            static_cast<std::int32_t>(i), 1.0});
    }
    for (const QuestionDescription& question : description.questions) {
        frame.events.emplace_back(JudgeEvent{question.id, {{"thing", "an apple"}}});
    }
    for (const KnowledgeDescription& known : description.knowledge) {
        frame.events.emplace_back(AskedEvent{known.id, {{"thing", "an apple"}}});
    }
    return frame;
}

/// Loads the message's lesson and plays so many frames.
inline BothSides play_both_sides(const LoadMessage& message, Choices choices, int frames) {
    BothSides told;
    HostServices services;
    services.find_module = [](const std::string&) {
        return ModuleAnswer{false, {}, "there are no modules here"};
    };
    services.print_while_loading = [&](const std::string& text) { told.prints.push_back(text); };
    LessonHost host(message, services);
    Bytes bytes;
    if (const auto error = host.load()) {
        told.lesson = to_sentence(to_error(*error));
        const auto taken = decode_error(encoded(*error, bytes));
        told.program = taken ? "" : taken.error().message;
        return told;
    }
    const auto description = decode_description(encoded(host.description(), bytes));
    if (!description) {
        told.program = description.error().message;
        return told;
    }
    for (int i = 0; i < frames; ++i) {
        const auto frame = decode_frame(encoded(generated_frame(choices, *description), bytes));
        if (!frame) {
            told.program = frame.error().message;
            return told;
        }
        LessonReply reply;
        if (const auto error = host.run_frame(*frame, reply)) {
            told.lesson = to_sentence(to_error(*error));
            return told;
        }
        const auto taken = decode_reply(encoded(reply, bytes), *description);
        if (!taken) {
            told.program = taken.error().message;
            return told;
        }
        for (const LessonCommand& command : taken->commands) {
            if (const auto* print = std::get_if<PrintCommand>(&command)) {
                told.prints.push_back(print->text);
            }
        }
    }
    return told;
}

}  // namespace fulcrum::test
