// What an answer that fits no template nearly was, so that the reply can help: the opposite of what is asked ("lighter"), a
// number that its list has not ("fifteen" of one to ten), or a thing that was only pointed at ("this one is heavier").
//
// Thread: pure.  Cost: a few matches for each opposite, number and list; only of answers that are not understood.
#pragma once

#include "dialogue/marking/mark.h"

#include <string_view>

namespace fulcrum::dialogue {

/// Fills the opposite, the other number or what was pointed with of `mark`; at most one of the three.
void find_near_miss(const TemplateSet& set, std::string_view text, Mark& mark);

}  // namespace fulcrum::dialogue
