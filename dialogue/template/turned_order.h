// Sentences about what is compared, with the comparison first, as other languages say it.
//
//   "the {thing} is <comparative:heavy> [than the {other}]"    "heavier is the egg", "is heavier the egg"
//
// They are nearly answers: understood, and said back in their order.
//
// Thread: pure.  Cost: the arcs of each such sentence, at most twice; where there is no room for them they are left out.
#pragma once

#include "dialogue/template/graph_builder.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// Adds them behind what is nearly an answer; the answers of `set` are compiled from `sentences`, one each in order.
void add_turned_order(TemplateSet& set, const ParsedRules& rules,
                      const std::vector<std::string>& sentences);

}  // namespace fulcrum::dialogue
