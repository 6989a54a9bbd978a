// The verb at the end, as learners say it whose own language puts it there: "a watermelon the heaviest is".
//
//   --watermelon--> u --is--> v --the heaviest--> end
//                   u --nothing said, "is" belongs here, R:WO--> v' --the heaviest--> end' --"is", too late--> end
//
// For each verb of a sentence what follows it is copied once, without the errors in it but a missing article, so the graph
// grows by less than itself for each verb; where there is no room for that, it stays as it is.
//
// Thread: one.  Cost: linear in the arcs, for each verb.
#pragma once

#include "dialogue/template/arc_writer.h"

namespace fulcrum::dialogue {

/// Adds them to the graph between `start` and `end`.
void add_verb_last(ArcWriter& writer, int start, int end);

}  // namespace fulcrum::dialogue
