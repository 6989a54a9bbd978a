// Places that are told without what they are places of: "on top", "in the middle", "under it", where a template has
// "{place} the {thing}" with "on top of", "in the middle of", "under" in its list. They are right where they are so of anything.
//
// Thread: pure.  Cost: linear in the arcs.
#pragma once

#include "dialogue/template/graph_builder.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// Adds them for the author's `sentences`, which are the set's answers; where there is no room, none.
void add_place_answers(TemplateSet& set, const ParsedRules& rules,
                       const std::vector<std::string>& sentences);

}  // namespace fulcrum::dialogue
