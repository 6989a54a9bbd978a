// What a grammar of English cannot read although no rule finds an error in it. For whoever writes sentences for others, not for learners: one
// good sentence in some thirty is told as well.
//
// Thread: as the judge.  Cost: a parse for each clause.
#pragma once

#include "dialogue/checking/judge.h"
#include "dialogue/checking/reading.h"

#include <string>
#include <string_view>

namespace fulcrum::dialogue {

/// `text`, what `sentence` has from its word `first` on, as a judge reads it: what begins with a common word begins small, and has a stop.
[[nodiscard]] std::string for_judge(const FreeSentence& sentence, int first, std::string text);

/// The first clause of `text` that `judge` cannot read whole, as it stands there; "" where there is none. Clauses are parted by stops and
/// colons; what has no verb, such as "Lighter or heavier?", is no clause and passes.
[[nodiscard]] std::string find_unread(SentenceJudge& judge,
                                      const std::vector<FreeSentence>& sentences,
                                      std::string_view text);

}  // namespace fulcrum::dialogue
