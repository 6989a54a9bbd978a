// A font, and how boxes of the overlay lie to one another.
#pragma once

#include "runtime/render/overlay/measure.h"
#include "runtime/render/renderer.h"

namespace fulcrum::runtime {

inline Font andika() {
    return Font(RendererSettings{}.font_folder);
}

inline bool overlap(const Box& a, const Box& b) {
    constexpr float kTouch = 0.01F;
    return a.x + kTouch < b.right() && b.x + kTouch < a.right() && a.y + kTouch < b.bottom() &&
           b.y + kTouch < a.bottom();
}

inline bool inside(const Box& box, const Measure& m) {
    return box.x >= -0.01F && box.y >= -0.01F && box.right() <= m.width_px + 0.01F &&
           box.bottom() <= m.height_px + 0.01F;
}

}  // namespace fulcrum::runtime
