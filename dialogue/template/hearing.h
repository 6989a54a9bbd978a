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
    std::string_view short_form{};  ///< "it's": this word and the next were written as one, "its"
    bool doubled =
        false;  ///< a determiner beside another one, "the a": may be skipped, as an error
};

/// "Its": whose it is, or "it's" without its apostrophe. Only where the templates have both is there a choice.
enum class Its : std::uint8_t { owner, contraction };

/// True when `utterance` has an "its" that can be either.
[[nodiscard]] bool its_is_open(const TemplateSet& set, std::string_view utterance);

/// Understands the words of `utterance`. `comparisons` counts the work.
[[nodiscard]] std::vector<HeardWord> hear_words(const TemplateSet& set, std::string_view utterance,
                                                std::size_t& comparisons,
                                                Its its = Its::contraction);

}  // namespace fulcrum::dialogue
