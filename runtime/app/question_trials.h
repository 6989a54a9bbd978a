// A lesson's questions tried before a learner meets them: `right` of each is called with all that its answers can mean, when it is
// asked, and what may happen at any moment does: keys are pressed, things are touched.
//
// Thread: that of the run.  Cost: one exchange with the lesson's process a meaning, at most some hundred a question.
#pragma once

#include "dialogue/marking/meanings.h"
#include "runtime/app/lesson_run.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Tries each question once; the run lives longer. When `right` fails nothing more is tried.
class QuestionTrials {
  public:
    explicit QuestionTrials(LessonRun& run) : run_(run) {}

    /// Once a frame: tries the question that is open, once a learner has had time to read it.
    void try_open_one(double now_s);
    /// After the play: tries those that were not asked in it. What is not right then may be right when they are asked.
    void try_others();

    /// What `right` failed with when its question was asked; it says which sentence was tried.
    [[nodiscard]] const std::optional<Error>& failed() const { return failed_; }
    /// What is no mistake and hardly meant, a sentence with its line each: nothing that a learner can say is right; help that
    /// says what is right; `right` fails where the play did not come to its question.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  private:
    /// How many of the meanings are right.
    [[nodiscard]] Expected<std::size_t> count_right(const QuestionDescription& described,
                                                    const std::vector<dialogue::Meaning>& meanings);
    /// Notes a question whose own sentences mean nothing.
    bool note_unanswerable(const QuestionDescription& described,
                           const dialogue::Meanings& meanings);
    /// Notes help that says what is right, where something else could be said.
    [[nodiscard]] Expected<void> try_help(const QuestionDescription& described,
                                          const dialogue::Question& question);

    LessonRun& run_;
    std::set<std::string> tried_;
    std::optional<Error> failed_;
    std::vector<std::string> notes_;
};

/// Presses each key and touches each thing that is seen and can be touched. An error is the lesson's own, and says what was done.
[[nodiscard]] Expected<void> try_events(LessonRun& run);

}  // namespace fulcrum::runtime
