// The lines that a partner in a process of its own reads and writes: one JSON object a line, UTF-8.
//
//   to it     {"turn": 3, "level": "A1", "prompt": "Which one is the heaviest?", "said": "watermelon is most heavy", "kind": "recast",
//              "attempt": 1, "corrected": "A watermelon is the heaviest.", "errors": ["R:ADJ:FORM"], "ours": "Yes. A watermelon is …"}
//             {"turn": 4, "level": "A1", "asks": "What is this?", "ours": "It is an apple."}       the learner asks
//   from it   {"turn": 3, "text": "Good! We say: a watermelon is *the heaviest*."}
// "kind" is a FeedbackKind (conversation/turn.h): what was decided about the answer, before anybody talks of it. "ours" is what the program
// says where the partner does not. No more is told: no name, no other turn, nothing of the hand.
// A text has 400 characters at most, in letters of English and its neighbours; control characters are left out, *asterisks* emphasise and
// nothing else is markup.
//
// Thread: pure.  Cost: linear in the line.
#pragma once

#include "dialogue/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

inline constexpr std::size_t kLongestPartnerText = 400;  ///< characters

struct TurnLine {
    int turn = 0;
    std::string level;
    std::string asks{};  ///< not empty: the learner asks, and the rest but `ours` isn't told
    std::string prompt{};
    std::string said{};
    std::string kind{};
    int attempt = 0;
    std::string corrected{};
    std::vector<std::string> errors{};
    std::string ours{};
};
/// Without the line's end.
[[nodiscard]] std::string write_line(const TurnLine& line);

struct TextLine {
    int turn = 0;
    std::string text;  ///< fit to be shown
};
/// An error says what is wrong with the line, as it goes on from "the partner": "says more than 400 characters".
[[nodiscard]] Expected<TextLine> read_text_line(std::string_view line);

}  // namespace fulcrum::dialogue
