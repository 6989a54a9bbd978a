// What the answers to a question can mean, each with a sentence that means it: for whoever tries a question before a learner does.
//
// Thread: pure.  Cost: a sentence made for each meaning.
#pragma once

#include "dialogue/marking/question.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// A meaning: the slots that are filled, as a mark has them, and a right sentence for it.
struct Meaning {
    std::vector<std::pair<std::string, std::string>> slots;
    std::string said;
};

/// The meanings of the answers, each once, those of short answers and of what is turned round behind them; `most` of each at least
/// where there are more.
struct Meanings {
    std::vector<Meaning> some;
    bool all = true;  ///< there are no others
};

/// Of each answer first what it means with each single word of its lists, then the rest, as far as `most` goes (1 or more).
[[nodiscard]] Meanings meanings_of(const Question& question, std::size_t most);

}  // namespace fulcrum::dialogue
