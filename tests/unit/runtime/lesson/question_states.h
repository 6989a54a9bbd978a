// A dialogue about two questions, brought into each of its states, and what may happen to it there.
#pragma once

#include "runtime/lesson/question_dialogue.h"
#include "runtime/lesson/questions.h"
#include "tests/unit/runtime/lesson/session_fixture.h"

namespace fulcrum::runtime::test {

inline constexpr const char* kRight = "the apple is the heaviest";
inline constexpr const char* kSlip = "the apple is the most heavy";
inline constexpr const char* kWrong = "the egg is the heaviest";
inline constexpr const char* kNonsense = "bla bla bla";
inline constexpr double kLongEnough_s = 30.0;  // longer than any invitation

inline QuestionDialogue make_dialogue() {
    return {compile_questions(two_questions()).value(), words()};
}

// Brings a dialogue about "heaviest" into each state, at time 0.
using State = dialogue::CourseState;

inline QuestionDialogue in_state(State state) {
    QuestionDialogue dialogue = make_dialogue();
    const auto answer = [&](const char* said, bool right) {
        (void)dialogue.ask("heaviest", 0.0);
        (void)dialogue.hear(said, 1.0, 0.0);
        (void)dialogue.judge("heaviest", right, 0.0);
    };
    switch (state) {
        case State::idle:
            break;
        case State::asked:
            (void)dialogue.ask("heaviest", 0.0);
            break;
        case State::heard:
            (void)dialogue.ask("heaviest", 0.0);
            (void)dialogue.hear(kRight, 1.0, 0.0);
            break;
        case State::replaying:
            answer(kWrong, false);
            break;
        case State::invited:
        case State::heard_again:
            answer(kSlip, true);
            answer(kSlip, true);
            if (state == State::heard_again) {
                (void)dialogue.hear(kRight, 1.0, 0.0);
            }
            break;
        case State::left:
            (void)dialogue.ask("heaviest", 0.0);
            for (int i = 0; i < dialogue::ConversationSettings{}.unheard_tries; ++i) {
                (void)dialogue.hear(kNonsense, 1.0, 0.0);
            }
            break;
        case State::done:
            answer(kRight, true);
            break;
    }
    REQUIRE(dialogue.state() == state);
    return dialogue;
}

inline std::vector<AnsweredEvent> told(const QuestionTurn& turn) {
    std::vector<AnsweredEvent> answers;
    for (const LessonEvent& event : turn.events) {
        if (const auto* answered = std::get_if<AnsweredEvent>(&event)) {
            answers.push_back(*answered);
        }
    }
    return answers;
}

inline QuestionTurn take(QuestionDialogue& dialogue, const std::string& what) {
    if (what == "ask the same") {
        return dialogue.ask("heaviest", 1.0);
    }
    if (what == "ask another") {
        return dialogue.ask("lightest", 1.0);
    }
    if (what == "right" || what == "wrong") {
        return dialogue.judge("heaviest", what == "right", 1.0);
    }
    if (what == "other verdict") {
        return dialogue.judge("lightest", true, 1.0);
    }
    if (what == "little time" || what == "much time") {
        return dialogue.step(what == "little time" ? 1.0 : kLongEnough_s);
    }
    if (what == "close") {
        dialogue.close();
        return {};
    }
    if (what == "end of exchange") {
        dialogue.end_exchange();
        return {};
    }
    return dialogue.hear(what, 1.0, 1.0);
}

}  // namespace fulcrum::runtime::test
