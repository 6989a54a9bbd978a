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
        false;            ///< a determiner beside another one, "the a": may be skipped, as an error
    bool unread = false;  ///< of a reason behind the answer: a filler too, and nobody looked at it
};

/// "Its": whose it is, or "it's" without its apostrophe. Only where the templates have both is there a choice.
enum class Its : std::uint8_t { owner, contraction };

/// What a reason begins with: "because"; or "so" before a clause as well, which elsewhere is a filler.
enum class Reason : std::uint8_t { because, so_too };

/// What follows such a word is a reason, and not the answer: "because", "cos", "since".
[[nodiscard]] bool begins_reason(std::string_view word);

/// True when `utterance` has an "its" that can be either.
[[nodiscard]] bool its_is_open(const TemplateSet& set, std::string_view utterance);

/// True when `utterance` may have a clause that begins with "so".
[[nodiscard]] bool has_consequence(const TemplateSet& set, std::string_view utterance);

/// It says nothing of its own: "yes", "I think so", "I can feel it", "isn't it?".
[[nodiscard]] bool is_frame(std::string_view utterance);

/// Understands the words of `utterance`. `comparisons` counts the work.
[[nodiscard]] std::vector<HeardWord> hear_words(const TemplateSet& set, std::string_view utterance,
                                                std::size_t& comparisons,
                                                Its its = Its::contraction,
                                                Reason reason = Reason::because);

}  // namespace fulcrum::dialogue
