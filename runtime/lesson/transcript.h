// What was said in a play, in the order in which it was: a line each.
//
//    4.5 s  level    1: Near or far?
//    4.5 s  shows    Press the lever near the support.
//   12.0 s  asks     Where is it easier to press?
//   12.0 s  learner  far of the support (right; form: R:PREP)
//   12.0 s  answers  Yes. It is easier *far from the support*.
//
// Thread: lesson loop.  Cost: a line of text for each thing said.
#pragma once

#include "dialogue/partner/partner.h"
#include "runtime/lesson/answer_choices.h"
#include "runtime/lesson/question_dialogue.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

class Transcript {
  public:
    void begin_level(double time_s, int level, std::string_view title);
    void show(double time_s, std::string_view caption);  ///< an empty caption says nothing
    void ask(double time_s, std::string_view prompt);
    /// Answers to choose from, the right one first.
    void offer(double time_s, const std::vector<AnswerChoice>& choices);
    void hear(double time_s, const MarkedAnswer& answer);     ///< the learner's words
    void hear_asking(double time_s, std::string_view asked);  ///< what the learner asked
    /// What is said to either; nothing where nothing is.
    void reply(double time_s, const dialogue::Reply& reply, bool was_asked);
    void explain(double time_s, std::string_view text);
    /// The lines since the last call.
    [[nodiscard]] std::vector<std::string> take();

  private:
    void add(double time_s, const char* who, std::string_view text);

    std::vector<std::string> lines_;
};

/// How an answer was marked: "right", "wrong", "right; form: R:ADJ:FORM, M:DET", "not understood".
[[nodiscard]] std::string verdict_text(const MarkedAnswer& answer);

}  // namespace fulcrum::runtime
