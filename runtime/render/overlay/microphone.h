// A microphone with its level, at the right end of the line that a learner types: whoever speaks sees that it is heard.
//
//   mic  . . ! ! !     as many of kBars bars stand as the sound is loud; the others are dots
// Its colour says whether it takes in what is said; so does a ring around it.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/scene/view.h"

namespace fulcrum::runtime {

inline constexpr int kBars = 5;

/// How wide it is, pixels.
[[nodiscard]] float microphone_width_px(const Measure& measure);

/// With its right end and middle there.
void draw_microphone(DrawList& list, const Point2& right_middle, const Measure& measure,
                     const ViewMicrophone& microphone);

}  // namespace fulcrum::runtime
