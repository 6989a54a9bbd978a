// The panel "Why do I feel this?": each part of the force with its name, its newtons and direction, and a bar as long as its share.
//
//   [title          ]      on the left, between what stands above and what stands below; as many rows as there is room for,
//   [name   2.8 N up]      the strongest first; without room for one it is not shown
//   [======---------]
//
// Thread: one (it asks the font). Cost: setting the words, each frame that it is shown.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/scene/view.h"

#include <vector>

namespace fulcrum::runtime {

struct WhyRow {
    Paragraph name;
    Paragraph amount;
    Box bar;  ///< the whole length, of which the part is filled
    double part = 0.0;
    bool against = false;
    float top = 0.0F;
};

/// Without width where it is not shown.
struct WhyLayout {
    Box box;
    Paragraph title;
    std::vector<WhyRow> rows;
};

/// `room`: where it may stand, pixels.
[[nodiscard]] WhyLayout lay_out_why(const ViewWhy& why, const Font& font, const Measure& measure,
                                    const Box& room);
void draw_why(const WhyLayout& layout, const Measure& measure, DrawList& list);

}  // namespace fulcrum::runtime
