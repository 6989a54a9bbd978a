// What somebody is told who was not understood or wants help: how a sentence goes, and what may stand in it. It never says the answer.
//
//   1st time    once more (nothing of this)
//   2nd         the sentence with gaps: "… is the heaviest."
//   from then   what can be said for the gaps: "a watermelon, an apple or an egg"
//
// Where the answers of a question are different sentences ("far from the support", "near the support"), the first of them would tell
// which is meant; then what each of them says is listed. A question's whole sentence is shown where the learner is to ask.
//
// Thread: pure.  Cost: some sentences made from the templates.
#pragma once

#include "dialogue/marking/question.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

struct Help {
    enum class Kind : std::uint8_t { frame, example, choices };
    Kind kind = Kind::frame;
    std::string sentence{};              ///< of a frame and an example
    std::vector<std::string> choices{};  ///< what may be said
};

/// Help for somebody who was not understood `rung` times; 2 at least, anything above 3 is 3.
[[nodiscard]] Help help_for(const Question& question, int rung);

}  // namespace fulcrum::dialogue
