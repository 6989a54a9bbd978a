// The sheet of paper on which the words of panels and cards lie.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"

namespace fulcrum::runtime {

inline constexpr float kPaperRadius = 22.0F;  // of its corners, at 720

/// With a soft shadow, and its edge.
void draw_paper(DrawList& list, const Box& box, const Measure& measure, const Colour& paper);
/// The edge alone, where the list's colours have one.
void draw_edge(DrawList& list, const Box& box, const Measure& measure, float radius_px);

}  // namespace fulcrum::runtime
