// The buttons in the upper right corner: what keys do, for who has a mouse or a finger alone.
//
// Thread: one. Cost: some shapes.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/scene/view.h"

#include <vector>

namespace fulcrum::runtime {

/// One box a button of the view, in a row that ends at `right` pixels and begins at `top`.
[[nodiscard]] std::vector<Box> lay_out_buttons(const View& view, const Measure& measure,
                                               float right, float top);

void draw_buttons(const View& view, const std::vector<Box>& boxes, const Measure& measure,
                  DrawList& list);

}  // namespace fulcrum::runtime
