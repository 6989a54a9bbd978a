// A lesson that runs in the test's own process, and a script beside it: quick to start, easy to look into.
#pragma once

#include "runtime/lua/host/lesson_host.h"

#include <memory>
#include <string>
#include <vector>

namespace fulcrum::runtime::test {

/// Runs a text in a state; its error's sentence, or what it returned as text.
inline std::string run_script(ScriptState& state, const std::string& text,
                              std::uint64_t budget = 10'000'000) {
    state.begin_budget(budget);
    std::string result;
    const auto error = state.protect([&](lua_State* lua) {
        state.load_text(lua, {"test.lua", text});
        state.call(lua, 0, 1);
        if (lua_isstring(lua, -1) != 0) {
            result = lua_tostring(lua, -1);
        }
    });
    return error ? to_sentence(to_error(*error)) : result;
}

/// Runs a text in a fresh state.
inline std::string run_script(const std::string& text) {
    ScriptState state({});
    return run_script(state, text);
}

/// The body of a lesson, between head and return; line 2 is the first of it.
struct HostedLesson {
    LoadMessage message{};
    std::string says;  ///< in lesson { … } besides, after a comma
    std::unique_ptr<LessonHost> host;
    LessonReply reply{};
    std::string prints;  ///< of loading and of every frame, each with a ';' behind it

    /// Loads; the error's sentence, empty when it went well.
    std::string load(const std::string& body, const std::string& hand = {}) {
        message.lesson = {"lesson.lua", "local L = lesson { id = \"t\", title = \"T\"" + says +
                                            " }\n" + body + "\nreturn L\n"};
        if (!hand.empty()) {
            message.hand = {"hand.lua", hand};
        }
        HostServices services;
        services.find_module = [](const std::string&) {
            return ModuleAnswer{false, {}, "there are none"};
        };
        services.print_while_loading = [this](const std::string& text) { prints += text + ';'; };
        host = std::make_unique<LessonHost>(message, services);
        const auto error = host->load();
        return error ? to_sentence(to_error(*error)) : "";
    }
    /// A frame with every body where it was declared.
    [[nodiscard]] LessonFrame frame(std::vector<LessonEvent> events = {}) const {
        LessonFrame made;
        made.dt_s = 1.0 / 60.0;
        for (const BodyDescription& body : host->description().bodies) {
            BodyState state;
            state.pose_W.position = body.position_W;
            made.bodies.push_back(state);
        }
        made.events = std::move(events);
        return made;
    }
    /// Plays a frame; the error's sentence, empty when it went well.
    std::string play(const LessonFrame& next) {
        const auto error = host->run_frame(next, reply);
        for (const LessonCommand& command : reply.commands) {
            if (const auto* print = std::get_if<PrintCommand>(&command)) {
                prints += print->text + ';';
            }
        }
        return error ? to_sentence(to_error(*error)) : "";
    }
    std::string play() { return play(frame()); }
    /// Loads `body` inside start(world); then the error's sentence.
    std::string start(const std::string& body) {
        return load("function L:start(world) " + body + "\nend");
    }
    /// The last reply's commands of one kind.
    template <class Command>
    [[nodiscard]] std::vector<Command> commands() const {
        std::vector<Command> found;
        for (const LessonCommand& command : reply.commands) {
            if (const auto* wanted = std::get_if<Command>(&command)) {
                found.push_back(*wanted);
            }
        }
        return found;
    }
};

}  // namespace fulcrum::runtime::test
