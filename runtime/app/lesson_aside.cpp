#include "runtime/app/lesson_aside.h"

#include <algorithm>

namespace fulcrum::runtime {

Expected<LessonReply> LessonAside::ask(const LessonEvent& event) const {
    LessonFrame frame = session_.newest_frame();
    frame.dt_s = 0.0;
    frame.events = {event};
    frame.only_asks = true;
    return process_.exchange(frame);
}

Expected<bool> LessonAside::ask_verdict(const JudgeEvent& judge) const {
    return ask(judge).map([](const LessonReply& reply) {
        return std::ranges::any_of(reply.commands, [](const LessonCommand& command) {
            const auto* verdict = std::get_if<VerdictCommand>(&command);
            return verdict != nullptr && verdict->right;
        });
    });
}

Expected<std::string> LessonAside::ask_knowledge(const AskedEvent& asked) const {
    return ask(asked).map([](const LessonReply& reply) {
        for (const LessonCommand& command : reply.commands) {
            if (const auto* told = std::get_if<TellCommand>(&command)) {
                return told->text;
            }
        }
        return std::string();
    });
}

Expected<void> LessonAside::happen(const LessonEvent& event) const {
    return ask(event).map([](const LessonReply& /*reply*/) {});
}

Expected<std::vector<AnswerChoice>> LessonAside::make_choices() const {
    const dialogue::Question* const question = session_.question();
    if (question == nullptr) {
        return std::vector<AnswerChoice>();
    }
    return fulcrum::runtime::make_choices(*question, [&](const AnswerSlots& slots) {
        return ask_verdict({question->id, slots});
    });
}

}  // namespace fulcrum::runtime
