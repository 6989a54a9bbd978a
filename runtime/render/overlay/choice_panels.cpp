#include "runtime/render/overlay/choice_panels.h"

#include "runtime/render/overlay/paper.h"
#include "runtime/render/theme.h"
#include "runtime/scene/choice_columns.h"

#include <algorithm>

namespace fulcrum::runtime {

std::vector<Panel> lay_out_choices(const View& view, const Font& font, const Measure& m,
                                   float& bottom) {
    std::vector<Panel> choices;
    if (view.choices.empty()) {
        return choices;
    }
    const auto n = static_cast<int>(view.choices.size());
    const auto columns = static_cast<float>(choice_columns(n));
    const auto rows = static_cast<std::size_t>(choice_rows(n));
    const float gap = m.px(0.5F * kGap);
    const float around = 2.0F * m.px(kPadX) + m.px(kIconRoom);
    const float page = m.width_px - 2.0F * m.px(kMargin);
    const float widest = (page - (columns - 1.0F) * gap) / columns;
    float width = std::min((m.px(kInputWidth) - (columns - 1.0F) * gap) / columns, widest);
    for (const ViewChoice& choice : view.choices) {
        const MarkedText said = plain_text(choice.said);
        const float whole = set_words(font, m, said, {kBodyText, 1e9F, 1}).width_px;
        width = std::clamp(whole + around + 1.0F, width, widest);
    }
    std::vector<float> heights(rows, 0.0F);
    for (std::size_t i = 0; i < view.choices.size(); ++i) {
        const MarkedText said = plain_text(view.choices[i].said);
        const WordSettings settings{kBodyText, width - around, kMostSpokenLines};
        choices.push_back({{}, set_words(font, m, said, settings), {}});
        float& height = heights[i % rows];
        height = std::max(height, choices[i].words.height_px + m.px(kPadY));
    }
    const float left = 0.5F * (m.width_px - columns * width - (columns - 1.0F) * gap);
    for (std::size_t row = rows; row-- > 0;) {
        for (std::size_t i = row; i < choices.size(); i += rows) {
            const std::size_t column = i / rows;
            const float x = left + static_cast<float>(column) * (width + gap);
            choices[i].box = {x, bottom - heights[row], width, heights[row]};
        }
        bottom -= heights[row] + gap;
    }
    return choices;
}

Box choice_picture(const Panel& panel, const Measure& m) {
    const float side = std::min(panel.box.height, m.px(kIconRoom));
    return {panel.box.x + m.px(kPadX) - 0.5F * (side - m.px(2.0F * kIcon)),
            panel.box.middle_y() - 0.5F * side, side, side};
}

void draw_choice_papers(const View& view, const std::vector<Panel>& choices, const Measure& m,
                        DrawList& list) {
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const Box& box = choices[i].box;
        const bool chosen = static_cast<int>(i) == view.chosen;
        draw_paper(list, box, m,
                   chosen ? list.colours().selected_paper : list.colours().field_paper);
        // Not by its colour alone.
        if (chosen) {
            const float radius = std::min(m.px(kPaperRadius), 0.5F * box.height);
            list.frame_box(box, radius, m.px(4.0F), theme::kBlue);
        }
    }
}

}  // namespace fulcrum::runtime
