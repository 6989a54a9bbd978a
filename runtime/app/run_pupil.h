// Who answers in a run where no person does: a learner who errs at some rate, the words of the lesson's own test, those that were given, or what
// a record tells.
//
// Thread: the lesson's.
#pragma once

#include "runtime/app/replayed_input.h"
#include "runtime/app/run_request.h"
#include "runtime/lesson/session.h"
#include "runtime/lesson/simulated_pupil.h"

#include <functional>
#include <optional>
#include <string>

namespace fulcrum::runtime {

class RunPupil {
  public:
    /// Nobody.
    RunPupil() = default;
    RunPupil(const LessonDescription& description, const RunRequest& request);

    /// What is said to the question that is open, or asked while none is, when it is time for it; given once.
    [[nodiscard]] Expected<std::optional<std::string>> hear(
        double time_s, const LessonSession& session,
        const std::function<Expected<bool>(const JudgeEvent&)>& ask_verdict);
    /// What the record did besides the hand; null where none tells it.
    [[nodiscard]] ReplayedInput* replayed() { return replayed_ ? &*replayed_ : nullptr; }
    [[nodiscard]] const ReplayedInput* replayed() const {
        return replayed_ ? &*replayed_ : nullptr;
    }
    /// Whoever is simulated; nobody where a person or a record answers.
    [[nodiscard]] const std::optional<SimulatedPupil>& simulated() const { return pupil_; }
    /// The line of the L:test whose answers are given; 0 where they are somebody else's, or nobody's.
    [[nodiscard]] SourceLine say_line() const { return say_line_; }
    /// How many lines somebody gave to be said, by --say; 0 for none.
    [[nodiscard]] std::size_t n_given_lines() const { return n_given_lines_; }

  private:
    std::optional<SimulatedPupil> pupil_;
    std::optional<ReplayedInput> replayed_;
    SourceLine say_line_ = 0;
    std::size_t n_given_lines_ = 0;
};

}  // namespace fulcrum::runtime
