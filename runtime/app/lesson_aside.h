// What a lesson's own functions say aside: things as they stand, no time passes, and nothing else comes of it. While no answer is
// outstanding.
#pragma once

#include "runtime/lesson/answer_choices.h"
#include "runtime/lesson/session.h"
#include "runtime/lua/process/lesson_process.h"

#include <string>
#include <vector>

namespace fulcrum::runtime {

class LessonAside {
  public:
    /// Both outlive it.
    LessonAside(LessonProcess& process, const LessonSession& session)
        : process_(process), session_(session) {}

    /// The lesson's verdict about a meaning.
    [[nodiscard]] Expected<bool> ask_verdict(const JudgeEvent& judge) const;
    /// What it tells who asks for something; empty where it does not know that.
    [[nodiscard]] Expected<std::string> ask_knowledge(const AskedEvent& asked) const;
    /// It hears of the event as of any other; what it replies is not done. An error is the lesson's own.
    [[nodiscard]] Expected<void> happen(const LessonEvent& event) const;
    /// Answers to the question of now to choose from; none where nothing is asked.
    [[nodiscard]] Expected<std::vector<AnswerChoice>> make_choices() const;

  private:
    [[nodiscard]] Expected<LessonReply> ask(const LessonEvent& event) const;

    LessonProcess& process_;
    const LessonSession& session_;
};

}  // namespace fulcrum::runtime
