// What a learner said beside how it is better said: the words that are other there are emphasised.
//
//   "watermelon is most heavy"   "A watermelon is the heaviest."   ->   "*A* watermelon is *the heaviest*."
//
// Thread: pure.  Cost: words of the one times words of the other.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/lesson/session_messages.h"

#include <string>
#include <string_view>

namespace fulcrum::runtime {

/// `right`, a sentence without asterisks, with each run of words that `said` does not have there between asterisks.
[[nodiscard]] std::string emphasise_changes(std::string_view said, std::string_view right);

/// The answer's answer as it is shown: what the learner said, clipped, below it how it is better said and the rest of the answer, a line each.
[[nodiscard]] std::string show_feedback(const SessionHud& hud,
                                        const dialogue::Catalogue& catalogue);

}  // namespace fulcrum::runtime
