// An answer that is marked as one sentence: what it means, by the template that fits it, and what of its form is wrong.
//
// Thread: pure.  Cost: one match (template/matcher.h).
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"

#include <string_view>

namespace fulcrum::dialogue {

/// Marks `text` as an answer to `question`, read as one sentence, whatever stops are in it.
[[nodiscard]] Mark mark_sentence(const Question& question, std::string_view text,
                                 double confidence = 1.0);

}  // namespace fulcrum::dialogue
