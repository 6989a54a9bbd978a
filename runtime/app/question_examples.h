// The examples of a lesson's questions, each marked as a learner's answer would be: understood? right in meaning, by the lesson's
// own verdict? right in form? And of what a learner may ask: is it asked for, and rightly? For every way to ask the lesson's own
// function is called, so that its mistakes come out before a learner finds them.
//
// Thread: that of the run.  Cost: one match and one exchange with the lesson's process an example, or a way to ask.
#pragma once

#include "runtime/app/lesson_run.h"

#include <functional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// Is given what the lesson answers to each way to ask for what it knows as that.
using AnswerTaker =
    std::function<void(const KnowledgeDescription& known, const std::string& answer)>;

/// What came out otherwise than the lesson says, a sentence with its line each. An error is the lesson's own, from its verdict.
[[nodiscard]] Expected<std::vector<std::string>> find_unmet_examples(
    LessonRun& run, const AnswerTaker& take_answer = {});

}  // namespace fulcrum::runtime
