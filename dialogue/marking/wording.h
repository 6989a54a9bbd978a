// An answer of other words than English has for it: what is said back, and what of it was wrong.
//
//   "the lift it holds it up" -> The lift *holds* it up.       U:PRON: one word too many
//   "there have eight planets" -> There *are* eight planets.   R:VERB:FORM: one word for another
//   "have eight planets" -> *There are eight planets*.         R:OTHER: the words go another way
//
// Thread: pure.  Cost: one sentence made for each answer that means the same.
#pragma once

#include "dialogue/marking/mark.h"
#include "dialogue/template/parse.h"

namespace fulcrum::dialogue {

/// Marks what `parse`, of a graph of `nearly`, says of `mark.said`.
void mark_wording(const TemplateSet& set, const Parse& parse, Mark& mark);

}  // namespace fulcrum::dialogue
