// A small lesson with one question, for the tests of the lesson's session and its picture.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/lesson/session.h"
#include "runtime/scene/compile_plan.h"
#include "tests/unit/runtime/progress/test_store.h"
#include "tests/unit/runtime/rig.h"

namespace fulcrum::runtime::test {

inline BodyDescription thing(const std::string& name, double mass_kg) {
    BodyDescription body;
    body.name = body.noun = body.model = name;
    body.mass_kg = mass_kg;
    body.movable = true;
    body.line = 3;
    return body;
}

inline LessonDescription two_things() {
    LessonDescription lesson;
    lesson.id = "two";
    lesson.title = "Two things";
    lesson.level = "A1";
    lesson.bodies = {thing("apple", 0.2), thing("egg", 0.06)};
    lesson.bucket.present = true;
    QuestionDescription question;
    question.id = "heaviest";
    question.prompt = "Which one is the heaviest?";
    question.answers = {"[a|an|the] {thing} is the <superlative:heavy> [one]"};
    question.line = 7;
    lesson.questions = {question};
    return lesson;
}

inline const dialogue::Catalogue& words() {
    static const dialogue::Catalogue catalogue = dialogue::Catalogue::parse(
                                                     "hud.weight = felt {felt} N, true {true} N\n"
                                                     "hud.force = {newtons} N\n"
                                                     "hud.you_said = You said: {said}\n"
                                                     "hud.better = Better: {sentence}\n"
                                                     "feedback.praise.1 = Yes!\n"
                                                     "feedback.recast = Yes. {sentence}\n"
                                                     "feedback.prompt = Once more: {gap}\n"
                                                     "feedback.repaired = Now right.\n"
                                                     "feedback.wrong_meaning = Not yet.\n"
                                                     "feedback.not_understood.1 = Say it again.\n")
                                                     .value();
    return catalogue;
}

using MemoryStore = TestStore;

/// The same with a second question, "lightest".
inline LessonDescription two_questions() {
    LessonDescription lesson = two_things();
    QuestionDescription question = lesson.questions[0];
    question.id = "lightest";
    question.prompt = "Which one is the lightest?";
    question.answers = {"[a|an|the] {thing} is the <superlative:light> [one]"};
    question.line = 9;
    lesson.questions.push_back(question);
    return lesson;
}

struct Play {
    explicit Play(LessonDescription played = two_things(), const PlanOptions& options = {})
        : lesson(std::move(played)), plan(compile_plan(lesson, options, nullptr).value()) {}

    LessonDescription lesson;
    MemoryStore store;
    Plan plan;
    std::unique_ptr<LessonSession> session =
        LessonSession::create(lesson, plan, words(), store, random_record_id(), "v1").value();
    double time_s = 0.0;

    const LessonFrame& frame(SessionInput input = {}) {
        input.clock_s = input.time_s = time_s;
        input.dt_s = 1.0 / 60.0;
        time_s += input.dt_s;
        return session->begin_frame(input);
    }
    const LessonFrame& hear(const std::string& words_said) {
        SessionInput input;
        input.heard = words_said;
        return frame(std::move(input));
    }
    /// Frames in which nothing happens, for so long; gives the answers that the lesson was told of.
    std::vector<AnsweredEvent> wait(double seconds) {
        std::vector<AnsweredEvent> told;
        for (const double until_s = time_s + seconds; time_s < until_s;) {
            for (const LessonEvent& event : frame().events) {
                if (const auto* answered = std::get_if<AnsweredEvent>(&event)) {
                    told.push_back(*answered);
                }
            }
            reply();
        }
        return told;
    }
    /// Begins, and asks.
    void ask(const std::string& question = "heaviest") {
        frame();
        reply({AskCommand{question}});
    }
    /// Hears it, and judges it; what the lesson is told of it.
    AnsweredEvent answer(const std::string& words_said, bool right) {
        hear(words_said);
        reply({VerdictCommand{"heaviest", right}});
        return told<AnsweredEvent>(frame());
    }
    /// The event of this kind; fails the test where there is none.
    template <class Event>
    static Event told(const LessonFrame& frame) {
        for (const LessonEvent& event : frame.events) {
            if (const auto* found = std::get_if<Event>(&event)) {
                return *found;
            }
        }
        throw std::runtime_error("the lesson was not told of it");
    }
    /// Asks, hears, and judges the answer right.
    void say_rightly(const std::string& words_said) {
        reply({AskCommand{"heaviest"}});
        hear(words_said);
        reply({VerdictCommand{"heaviest", true}});
    }
    SessionOutput reply(std::vector<LessonCommand> commands = {}) {
        LessonReply answer;
        answer.commands = std::move(commands);
        auto output = session->finish_frame(answer);
        REQUIRE(output.has_value());
        return *output;
    }
    bool refuses(LessonCommand command) {
        LessonReply answer;
        answer.commands.push_back(std::move(command));
        return !session->finish_frame(answer).has_value();
    }
};

template <class Event>
const Event* find(const LessonFrame& frame) {
    for (const LessonEvent& event : frame.events) {
        if (const auto* found = std::get_if<Event>(&event)) {
            return found;
        }
    }
    return nullptr;
}

}  // namespace fulcrum::runtime::test
