// Which entry of its list each slot has in a sentence that the program makes.
//
//   "the {thing} is on the {other}", with the same words   nothing named       the ball is on the box
//                                                          other = ball        the box is on the ball
//
// Thread: pure.  Cost: a comparison for each entry and slot.
#pragma once

#include "dialogue/template/graph.h"

#include <string>
#include <utility>
#include <vector>

namespace fulcrum::dialogue {

/// By slot the number of its entry: the one that `slots` names; of a slot that is not named, or named with what its list has not, the first
/// that no other slot has, for two things in one sentence are two.
[[nodiscard]] std::vector<int> wanted_entries(
    const TemplateSet& set, const std::vector<std::pair<std::string, std::string>>& slots);

}  // namespace fulcrum::dialogue
