#include "runtime/render/overlay/find_measure.h"

#include "runtime/render/overlay/menu.h"
#include "runtime/render/overlay/panels.h"

#include <algorithm>
#include <vector>

namespace fulcrum::runtime {
namespace {

constexpr int kTries = 5;  // smaller sizes between the usual one and the one asked for

bool has_room(const std::vector<Box>& boxes, const Measure& m) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box& box = boxes[i];
        if (box.x < 0.0F || box.y < 0.0F || box.right() > m.width_px ||
            box.bottom() > m.height_px ||
            std::any_of(boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Box& other) { return box.meets(other); })) {
            return false;
        }
    }
    return true;
}

}  // namespace

Measure find_measure(const View& view, Font& font, int width, int height) {
    const double larger = std::max(view.look.text_scale - 1.0, 0.0);
    for (int tries = kTries; larger > 0.0 && tries > 0; --tries) {
        const Measure measure(width, height, 1.0 + larger * tries / kTries);
        const PanelLayout panels = lay_out_panels(view, font, measure);
        std::vector<Box> boxes = panels.shown();
        for (const MenuCard& card : lay_out_menu(view, measure, panels.papers()).cards) {
            boxes.push_back(card.box);
        }
        if (has_room(boxes, measure)) {
            return measure;
        }
    }
    return {width, height};
}

}  // namespace fulcrum::runtime
