// Finds which sentence of a template set was said, and where it departs from the right one.
//
// The utterance is matched against all graphs by the shortest path over (node, word): an arc advances by the words it
// says, a filler ("um", "I think") may be skipped. Nodes are numbered upwards, so one pass over the arcs finds the least
// cost: sum of the costs of the labelled errors on the way. An unknown word is taken for the one nearest word of the
// templates when the spelling differs by a slip; otherwise nothing matches: what isn't known is never waved through, for
// it may turn the meaning round ("not", "less").
//
// Thread: pure.  Cost: at most arcs x kMostWords steps and words x kMostWords comparisons; counted in `MatchWork`.
#pragma once

#include "dialogue/template/parse.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace fulcrum::dialogue {

inline constexpr std::size_t kLongestUtterance_bytes = 1000;
inline constexpr std::size_t kMostWords = 48;  ///< longer utterances aren't understood
inline constexpr int kGreatestCost = 120;  ///< a path that costs more isn't taken for the sentence

/// How much a match had to do; for tests that bound it.
struct MatchWork {
    std::size_t steps = 0;        ///< arcs tried at a word
    std::size_t comparisons = 0;  ///< words compared for spelling
};

/// The best parse, or none.
[[nodiscard]] std::optional<Parse> match(const TemplateSet& set, std::string_view utterance,
                                         MatchWork* work = nullptr);

}  // namespace fulcrum::dialogue
