#include "runtime/render/overlay/paper.h"

namespace fulcrum::runtime {

void draw_paper(DrawList& list, const Box& box, const Measure& measure, const Colour& paper) {
    Box below = box;
    below.y += measure.px(3.0F);
    list.shadow_box(below, measure.px(kPaperRadius), measure.px(16.0F),
                    with_alpha(list.colours().ink, 0.22F));
    list.fill_box(box, measure.px(kPaperRadius), paper);
    draw_edge(list, box, measure, measure.px(kPaperRadius));
}

void draw_edge(DrawList& list, const Box& box, const Measure& measure, float radius_px) {
    constexpr float kEdge = 3.0F;  // at 720
    if (list.colours().has_frames) {
        list.frame_box(box, radius_px, measure.px(kEdge), list.colours().ink);
    }
}

}  // namespace fulcrum::runtime
