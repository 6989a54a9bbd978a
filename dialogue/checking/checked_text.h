// A free English text with what is wrong in its form.
#pragma once

#include "dialogue/english/error_code.h"

#include <cstddef>
#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// One error of form in a text.
struct FreeError {
    ErrorCode code = ErrorCode::none;
    std::size_t begin = 0;  ///< bytes of the text, [begin, end); empty where something is missing
    std::size_t end = 0;
    std::string said;   ///< those bytes
    std::string right;  ///< what belongs there; empty where nothing does
    /// These words can be told without their sentence; a verb, a pronoun or an order needs all of it.
    bool alone = true;
};

/// A text, checked.
struct CheckedText {
    std::vector<FreeError> errors;  ///< in the order of the text, none over another
    std::string corrected;          ///< the text with all of them put right; all else as it was
    std::string marked;             ///< the same with what was put right in *asterisks*
    bool settled =
        true;  ///< nothing more is found in `corrected`; false where mending came to no end
    /// `corrected` is English: settled, a judge finds that all of it fits, and no rule has a doubt. Only `advise` says so.
    bool proven = false;
    /// Where nothing is wrong that a rule knows: the first clause that a grammar cannot read whole (unread.h); "" where it can. Only `review`
    /// says so.
    std::string unread{};
};

}  // namespace fulcrum::dialogue
