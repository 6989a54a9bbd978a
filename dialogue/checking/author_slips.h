// Slips of who writes sentences for others, in words that may be good English for something else when a learner says them: "The wooden
// block float." may be half a sentence there, in a lesson's caption it is none.
//
// Thread: pure.  Cost: one pass over the words.
#pragma once

#include "dialogue/checking/checked_text.h"
#include "dialogue/checking/reading.h"

#include <string_view>
#include <vector>

namespace fulcrum::dialogue {

/// What is to be another word in `text`, the first of each sentence:
///   "The wooden block float."   of a thing that stands there, with no other verb: floats
///   "Lifts the block."          nobody is told of: lift
///   "Which one are light?"      is
///   "Where float the block?"    "does" before what it is about
[[nodiscard]] std::vector<FreeError> find_author_slips(const std::vector<FreeSentence>& sentences,
                                                       std::string_view text);

/// "Why float the block?", which only means "what for", and "What is made the block?": the sentence as it stands; "" where there is none.
[[nodiscard]] std::string find_doubtful_question(const std::vector<FreeSentence>& sentences,
                                                 std::string_view text);

}  // namespace fulcrum::dialogue
