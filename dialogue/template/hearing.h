// The words of an utterance as the templates know them: numbers, slips of spelling put right, fillers marked.
//
// Thread: pure.  Cost: words x vocabulary comparisons at most.
#pragma once

#include "dialogue/template/graph.h"

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// One word that was heard.
struct HeardWord {
    int word = kNone;       ///< its number, kNone when the templates don't know it
    std::size_t begin = 0;  ///< bytes of the utterance
    std::size_t end = 0;
    ErrorCode slip = ErrorCode::none;  ///< spelling or orthography, when it was put right
    bool filler = false;               ///< may be skipped
};

/// Understands the words of `utterance`. `comparisons` counts the work.
[[nodiscard]] std::vector<HeardWord> hear_words(const TemplateSet& set, std::string_view utterance,
                                                std::size_t& comparisons);

}  // namespace fulcrum::dialogue
