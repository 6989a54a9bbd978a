// Puts one frame's picture together from what the loops and the session say. Pure: the same input,
// the same view.
//
// Thread: lesson loop. Cost: a copy of the words and one entry a visible body.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/lesson/scenery.h"
#include "runtime/lesson/session.h"
#include "runtime/scene/description.h"
#include "runtime/scene/plan.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

/// The picture of a lesson that runs.
[[nodiscard]] View compose_view(const LessonDescription& lesson, const Plan& plan,
                                const SessionHud& hud, const Scenery& scenery,
                                const dialogue::Catalogue& catalogue);

}  // namespace fulcrum::runtime
