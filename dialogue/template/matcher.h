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

#include "dialogue/template/graph.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kLongestUtterance_bytes = 1000;
inline constexpr std::size_t kMostWords = 48;  ///< longer utterances aren't understood
inline constexpr int kGreatestCost = 120;  ///< a path that costs more isn't taken for the sentence

/// One place of the sentence as it was said and as it should be.
struct Piece {
    Element element{};
    ErrorCode code = ErrorCode::none;
    int cost = 0;
    std::string said;       ///< the learner's own letters; empty when nothing was said
    std::size_t begin = 0;  ///< bytes of the utterance; begin == end where something is missing
    std::size_t end = 0;
    std::string right;         ///< what belongs here; empty when nothing does
    std::string short_form{};  ///< "it's", where "its" was written for it
    bool goes_on = false;      ///< the rest of the short form is the next piece's
    int item = kNone;
    Number number = Number::singular;
};

/// An utterance, understood.
struct Parse {
    int graph = kNone;
    int cost = 0;
    bool leaves_out = false;  ///< "there are two": what was counted is not said
    std::vector<Piece> pieces;
    std::vector<std::pair<std::string, std::string>> slots;  ///< slot -> value, in the order said
    std::size_t unread = 0;  ///< the byte where a reason begins that was let pass, or the end
};

/// How much a match had to do; for tests that bound it.
struct MatchWork {
    std::size_t steps = 0;        ///< arcs tried at a word
    std::size_t comparisons = 0;  ///< words compared for spelling
};

/// The best parse, or none.
[[nodiscard]] std::optional<Parse> match(const TemplateSet& set, std::string_view utterance,
                                         MatchWork* work = nullptr);

}  // namespace fulcrum::dialogue
