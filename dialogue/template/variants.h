// Sentences that follow from an author's by English alone: what says the same in other words, its negation, and that there is no
// difference. So every lesson understands them.
//
//   "{thing} is <comparative:heavy> [than {other}]"   "… is heavier than the other one", "… is the heavier one", "… weighs more";
//                                                     "the egg is not as heavy as the apple": of the other, the same
//   "{thing} is the <superlative:heavy>"              "… is heavier than the others", "the others are not as heavy as …", "… weighs most"
//   either                                            "… is not the heaviest"; "they weigh the same", "neither"
//   "it is {thing}", "{thing} <made_of:{material}>"   "it is not the egg", "it is not made of metal"
//   "{thing} is <adjective:{feel}>"                   "it is not soft"
//
// Each is a graph of its own, with the same errors as any; where there is no room for it, it is left out.
//
// Thread: pure.  Cost: linear in the arcs; a sentence gets a dozen of them at most.
#pragma once

#include "dialogue/template/graph_builder.h"

#include <string>
#include <vector>

namespace fulcrum::dialogue {

/// Adds them for the author's `sentences`, which are the set's answers.
void add_variants(TemplateSet& set, const ParsedRules& rules,
                  const std::vector<std::string>& sentences);

}  // namespace fulcrum::dialogue
