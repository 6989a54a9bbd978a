#include "runtime/render/overlay/buttons.h"

#include "runtime/render/overlay/icons.h"
#include "runtime/render/overlay/paper.h"
#include "runtime/render/theme.h"

namespace fulcrum::runtime {
namespace {

// At 720; see Measure. A finger's width on a tablet.
constexpr float kButtonSide = 52.0F;
constexpr float kBetweenButtons = 8.0F;
constexpr float kButtonIcon = 15.0F;

void draw_icon(ScreenButton button, bool paused, DrawList& list, const Point2& middle,
               float radius_px) {
    switch (button) {
        case ScreenButton::leave:
            return draw_leave_icon(list, middle, radius_px);
        case ScreenButton::settings:
            return draw_gear_icon(list, middle, 1.15F * radius_px);
        case ScreenButton::pause:
            return draw_pause_icon(list, middle, radius_px, paused);
        case ScreenButton::say_again:
            return draw_loudspeaker_icon(list, middle, radius_px);
        case ScreenButton::ask:
            return draw_question_icon(list, middle, radius_px);
        case ScreenButton::why:
            return draw_arrow_icon(list, middle, 1.15F * radius_px, {0.0F, 1.0F},
                                   list.colours().emphasis_ink);
    }
}

}  // namespace

std::vector<Box> lay_out_buttons(const View& view, const Measure& m, float right, float top) {
    std::vector<Box> boxes(view.buttons.size());
    for (std::size_t i = boxes.size(); i-- > 0;) {
        right -= m.px(kButtonSide);
        boxes[i] = {right, top, m.px(kButtonSide), m.px(kButtonSide)};
        right -= m.px(kBetweenButtons);
    }
    return boxes;
}

void draw_buttons(const View& view, const std::vector<Box>& boxes, const Measure& m,
                  DrawList& list) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        draw_paper(list, boxes[i], m, list.colours().paper);
        draw_icon(view.buttons[i], view.paused, list, {boxes[i].middle_x(), boxes[i].middle_y()},
                  m.px(kButtonIcon));
    }
}

}  // namespace fulcrum::runtime
