// The sentences of one answer, each marked alone, and what they say together. The whole is right where all that is said is right and nothing
// that is ruled out is.
//
// Thread: pure.  Cost: some matches a sentence.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/marking/question.h"
#include "dialogue/marking/said_spans.h"

#include <optional>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// One sentence of the answer, as it is understood.
struct SaidPart {
    Mark mark;
    bool denied = false;  ///< it rules out what `mark` means
};

/// The sentences `spans` of the answer `text`, one after another, without those that say nothing of their own; none where one of them is not
/// understood, for it may take back what the others say.
[[nodiscard]] std::optional<std::vector<SaidPart>> read_parts(const Question& question,
                                                              std::string_view text,
                                                              const std::vector<SaidSpan>& spans);

/// What `parts` say together, as a mark of the answer `whole`; none for what cannot stand side by side.
[[nodiscard]] std::optional<Mark> joined_mark(std::vector<SaidPart> parts, const Mark& whole);

}  // namespace fulcrum::dialogue
