// Short answers that leave out what a sentence begins with, where all that is asked for stands at its end.
//
//   "the apple is <place>", place = "(on|under|next to) the {thing}"    "Next to the bowl." "It is next to the bowl."
//   "the apple is {place} the {thing}"                                  the same
//   "I put it <place>"                                                  "Next to the bowl."
//
// What was left out is given back by a recast: "The apple is next to the bowl."
//
// Thread: pure.  Cost: the arcs of each sentence's end, twice; where there is no room for them they are left out.
#pragma once

#include "dialogue/result.h"
#include "dialogue/template/graph_builder.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// Adds them behind all other graphs of `set`, whose answers are compiled from `sentences`, one each in order.
void add_tail_answers(TemplateSet& set, const ParsedRules& rules,
                      const std::vector<std::string>& sentences);

}  // namespace fulcrum::dialogue
