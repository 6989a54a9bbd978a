// What the lesson's own functions say aside, while nothing else happens: is a meaning right, what is known; for lesson_run.cpp.
#include "runtime/app/lesson_run.h"

#include <algorithm>

namespace fulcrum::runtime {

Expected<LessonReply> LessonRun::ask_aside(const LessonEvent& event) {
    LessonFrame frame = session_->newest_frame();
    frame.dt_s = 0.0;
    frame.events = {event};
    frame.only_asks = true;
    return process_->exchange(frame);
}

Expected<bool> LessonRun::ask_verdict(const JudgeEvent& judge) {
    return ask_aside(judge).map([](const LessonReply& reply) {
        return std::ranges::any_of(reply.commands, [](const LessonCommand& command) {
            const auto* verdict = std::get_if<VerdictCommand>(&command);
            return verdict != nullptr && verdict->right;
        });
    });
}

Expected<std::string> LessonRun::ask_knowledge(const AskedEvent& asked) {
    return ask_aside(asked).map([](const LessonReply& reply) {
        for (const LessonCommand& command : reply.commands) {
            if (const auto* told = std::get_if<TellCommand>(&command)) {
                return told->text;
            }
        }
        return std::string();
    });
}

Expected<void> LessonRun::happen_aside(const LessonEvent& event) {
    return ask_aside(event).map([](const LessonReply& /*reply*/) {});
}

}  // namespace fulcrum::runtime
