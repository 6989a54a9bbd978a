// An utterance as a template set understands it: which sentence it is, and each place of that as it was said and as it should be.
#pragma once

#include "dialogue/template/graph.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

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

}  // namespace fulcrum::dialogue
