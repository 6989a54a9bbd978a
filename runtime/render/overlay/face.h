// The face of the helper that speaks: the program's own sign, a wedge with a beam that lies level on it.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

/// Its mouth is open while `speaks`; happy it smiles broadly, thoughtful it looks up and aside and its mouth is small.
void draw_face(DrawList& list, const Point2& middle, float radius_px, ViewMood mood, bool speaks);

}  // namespace fulcrum::runtime
