// A pupil who answers from a list, one line to each question in turn, or as a simulated learner; after a moment's thought.
// A line that begins with "?" is asked instead when its turn has come, between questions or, where the next one came first,
// while it is open; that question waits for the line after it.
// A question of the pupil's among the answers is put off until the open one is answered, and the next line is said then.
// An invitation to say a right answer once more is no question: it is left to pass.
// Used by --say, by lessons' tests and by headless runs; the words go the same way as typed ones.
#pragma once

#include "haptics/base/error.h"
#include "runtime/lesson/learner_model.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

inline constexpr double kThinking_s = 1.0;  ///< before an answer

class SimulatedPupil {
  public:
    explicit SimulatedPupil(std::vector<std::string> lines, double thinking_s = kThinking_s);
    explicit SimulatedPupil(const LearnerModel& model, double thinking_s = kThinking_s);

    /// Reads one answer a line; blank lines and lines that begin with # are passed over.
    [[nodiscard]] static Expected<std::vector<std::string>> read_lines(const std::string& path);

    /// The answer to a question that has been open since `asked_at_s`, when it is time for it, or what is asked instead; at
    /// most one answer a question. An error is the lesson's own, from its verdict.
    [[nodiscard]] Expected<std::optional<std::string>> answer(double asked_at_s, double now_s,
                                                              const dialogue::Question& question,
                                                              const Verdict& verdict);

    /// What the pupil asks: a line that begins with "?", once it is its turn and the pause since the last thing said is over.
    [[nodiscard]] std::optional<std::string> ask(double now_s);

    /// The lines that were not said yet.
    [[nodiscard]] const std::deque<std::string>& left() const { return lines_; }

  private:
    std::deque<std::string> lines_;
    std::optional<LearnerModel> model_;
    double thinking_s_;
    double answered_question_asked_at_s_ = -1.0;
    double spoke_at_s_ = 0.0;
};

}  // namespace fulcrum::runtime
