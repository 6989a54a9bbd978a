// How large words may be in a view, that all which stands there has room.
//
// Thread: one (it asks the font). Cost: the layout of what is shown, some times over where it is crowded.
#pragma once

#include "runtime/render/overlay/measure.h"
#include "runtime/render/text/font.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

/// As large as the view wants its words, or as much less, down to the usual size, as all that stands there needs to have room.
[[nodiscard]] Measure find_measure(const View& view, Font& font, int width, int height);

}  // namespace fulcrum::runtime
