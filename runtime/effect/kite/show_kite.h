// A kite in the picture: itself, bridle, tail, the line as it sags, wisps that the wind carries along, and its four forces.
//
// A kite is far away and small: it, its tail and the hand's reel are drawn `seen_scale` times larger about the knot, so that the line
// ends where it does. The tail streams along the air's drag and its own weight, and waves.
//
// Thread: lesson loop; values. Cost: some microseconds.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/lesson/scenery.h"
#include "runtime/lesson/session.h"
#include "runtime/scene/description.h"
#include "runtime/scene/plan.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

/// Adds it where the lesson has one and it flies. The force on the hand, if the view has it, is told as what is felt there; where the
/// line is not felt as it is (LineFeelSettings::share, most_N), its true pull is told beside it.
void add_kite(const LessonDescription& lesson, const Plan& plan, const SessionHud& hud,
              const Scenery& scenery, const dialogue::Catalogue& catalogue, View& view);

}  // namespace fulcrum::runtime
