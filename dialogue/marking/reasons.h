// Whether a reason that was given with an answer fits it.
//
// Thread: pure.  Cost: some matches of the reason's clause.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"

#include <optional>

namespace fulcrum::dialogue {

/// A reason that no template asks for is let pass (`Mark::unread`); but where it says as much as an answer it has to be true: "the apple,
/// because it is lighter" is none. Then the same as `whole`, which claims the reason too, else none. The errors of the reason's form are
/// free English's.
[[nodiscard]] std::optional<Mark> mark_with_reason(const Question& question, const Mark& whole);

}  // namespace fulcrum::dialogue
