#include "runtime/app/lesson_aside.h"

#include <algorithm>

namespace fulcrum::runtime {
namespace {

// What the bodies that are there are called, and what they are made of.
std::vector<std::string> things_in_sight(const LessonSession& session) {
    const LessonDescription& lesson = session.description();
    const std::vector<BodyState>& states = session.newest_frame().bodies;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < std::min(states.size(), lesson.bodies.size()); ++i) {
        const BodyDescription& body = lesson.bodies[i];
        if (states[i].where == BodyWhere::hidden) {
            continue;
        }
        words.push_back(body.noun);
        if (body.material != kNoMaterial) {
            words.push_back(lesson.materials[static_cast<std::size_t>(body.material)].felt.name);
        }
    }
    return words;
}

}  // namespace

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
    return fulcrum::runtime::make_choices(
        *question,
        [&](const AnswerSlots& slots) {
            return ask_verdict({question->id, slots});
        },
        things_in_sight(session_));
}

}  // namespace fulcrum::runtime
