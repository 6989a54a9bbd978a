#include "runtime/render/overlay/paper.h"

#include "runtime/render/theme.h"

namespace fulcrum::runtime {

void draw_paper(DrawList& list, const Box& box, const Measure& measure, const Colour& paper) {
    Box below = box;
    below.y += measure.px(3.0F);
    list.shadow_box(below, measure.px(kPaperRadius), measure.px(16.0F),
                    with_alpha(theme::kInk, 0.22F));
    list.fill_box(box, measure.px(kPaperRadius), paper);
}

}  // namespace fulcrum::runtime
