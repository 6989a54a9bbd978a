// The panels of answers to choose from, each with a picture of its own, in the columns of choice_columns.h.
//
// Thread: one (it asks the font). Cost: setting the words, each frame.
#pragma once

#include "runtime/render/overlay/panel.h"
#include "runtime/scene/view.h"

#include <vector>

namespace fulcrum::runtime {

/// As the view's, above `bottom`, which rises above them; as wide as their words need.
[[nodiscard]] std::vector<Panel> lay_out_choices(const View& view, const Font& font,
                                                 const Measure& measure, float& bottom);

/// Where a choice's picture belongs.
[[nodiscard]] Box choice_picture(const Panel& panel, const Measure& measure);

/// The papers on which their pictures lie; before their words.
void draw_choice_papers(const View& view, const std::vector<Panel>& choices, const Measure& measure,
                        DrawList& list);

}  // namespace fulcrum::runtime
