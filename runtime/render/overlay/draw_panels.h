// The panels as they are drawn, where panels.h has laid them.
//
// Thread: one. Cost: some hundred shapes.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/panels.h"

namespace fulcrum::runtime {

/// Draws what was laid out.
void draw_panels(const View& view, const PanelLayout& layout, const Measure& measure,
                 DrawList& list);

}  // namespace fulcrum::runtime
