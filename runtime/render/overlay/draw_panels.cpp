#include "runtime/render/overlay/draw_panels.h"

#include "runtime/render/overlay/face.h"
#include "runtime/render/overlay/icons.h"
#include "runtime/render/overlay/microphone.h"
#include "runtime/render/overlay/paper.h"
#include "runtime/render/theme.h"

#include <algorithm>
#include <string>

namespace fulcrum::runtime {

namespace {

/// Words in a panel, behind `indent` at 720.
void draw_words(DrawList& list, const Panel& panel, const Measure& m, float indent, float align,
                const Colour& ink) {
    const float room = panel.box.width - 2.0F * m.px(kPadX) - m.px(indent);
    list.text(panel.words, panel.box.x + m.px(kPadX + indent),
              panel.box.middle_y() - 0.5F * panel.words.height_px, room, align, ink,
              list.colours().emphasis_ink);
}

Point2 icon_place(const Panel& panel, const Measure& m) {
    return {panel.box.x + m.px(kPadX + kIcon), panel.box.middle_y()};
}

void draw_banner(const View& view, const Panel& panel, const Measure& m, DrawList& list) {
    const bool error = view.banner_is_error;
    draw_paper(list, panel.box, m,
               error ? list.colours().error_paper : list.colours().feedback_paper);
    list.frame_box(panel.box, m.px(kPaperRadius), m.px(4.0F),
                   error ? theme::kVermillion : theme::kBlue);
    if (error) {
        draw_warning_icon(list, icon_place(panel, m), m.px(1.15F * kIcon));
    } else {
        draw_notice_icon(list, icon_place(panel, m), m.px(kIcon));
    }
    draw_words(list, panel, m, kIconRoom, 0.0F,
               error ? list.colours().error_ink : list.colours().ink);
}

void draw_level(const View& view, const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, list.colours().paper);
    float x = panel.box.x + m.px(kLevelPad);
    if (view.level > 0) {
        const float radius = m.px(1.2F * kIcon);
        list.fill_disc({x + radius, panel.box.middle_y()}, radius, list.colours().emphasis_ink);
        const Paragraph number = set_words(list.font(), m, plain_text(std::to_string(view.level)),
                                           {kSmallText, 4.0F * radius, 1, Face::bold});
        list.text(number, x, panel.box.middle_y() - 0.5F * number.height_px, 2.0F * radius, 0.5F,
                  list.colours().paper, list.colours().paper);
        x += m.px(kIconRoom);
    } else {
        x += m.px(kPadX - kLevelPad);
    }
    const float height = panel.words.height_px + panel.second.height_px;
    const float top = panel.box.middle_y() - 0.5F * height;
    list.text(panel.words, x, top, 0.0F, 0.0F, list.colours().ink, list.colours().emphasis_ink);
    list.text(panel.second, x, top + panel.words.height_px, 0.0F, 0.0F, list.colours().soft_ink,
              list.colours().emphasis_ink);
}

void draw_score(const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, list.colours().paper);
    draw_star_icon(list, {panel.box.x + m.px(16.0F + 1.15F * kIcon), panel.box.middle_y()},
                   m.px(1.25F * kIcon), true);
    list.text(panel.words, panel.box.x + m.px(16.0F + kIconRoom),
              panel.box.middle_y() - 0.5F * panel.words.height_px, 0.0F, 0.0F, list.colours().ink,
              list.colours().ink);
}

void draw_lights(const std::vector<bool>& lights, const Panel& panel, const Measure& m,
                 DrawList& list) {
    draw_paper(list, panel.box, m, list.colours().paper);
    float x = panel.box.x + m.px(kLevelPad);
    for (std::size_t i = 0; i < std::min(lights.size(), kMostLightSigns); ++i) {
        draw_light_icon(list, {x + m.px(0.5F * kLightSign), panel.box.middle_y()},
                        m.px(0.4F * kLightSign), lights[i]);
        x += m.px(kLightSign);
    }
    list.text(panel.words, x + m.px(kPadY), panel.box.middle_y() - 0.5F * panel.words.height_px,
              0.0F, 0.0F, list.colours().ink, list.colours().ink);
}

void draw_input(const View& view, const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, list.colours().field_paper);
    list.frame_box(panel.box, m.px(kPaperRadius), m.px(4.0F), theme::kBlue);
    draw_pencil_icon(list, icon_place(panel, m), m.px(kIcon));
    const bool typed = !view.input.empty();
    draw_words(list, panel, m, kIconRoom, 0.0F,
               typed ? list.colours().ink : list.colours().soft_ink);
    if (view.microphone.visible) {
        draw_microphone(list, {panel.box.right() - m.px(kPadX), panel.box.middle_y()}, m,
                        view.microphone);
    }
    // The caret stands behind what was typed last, which may be on its left.
    const TextLine& line = panel.words.lines.front();
    const bool on_left = !typed || line.ends_left;
    const float x = panel.box.x + m.px(kPadX + kIconRoom) + (typed ? line.end_px : 0.0F) +
                    m.px(on_left ? -2.0F * kCursor : kCursor);
    const float height = 0.62F * panel.box.height;
    list.fill_box({x, panel.box.middle_y() - 0.5F * height, std::max(m.px(kCursor), 1.0F), height},
                  0.0F, theme::kBlue);
}

void draw_stars(int stars, const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, list.colours().paper);
    const float middle_y = panel.box.y + 0.5F * m.px(kEndStars);
    for (int i = 0; i < 3; ++i) {
        const float dx = m.px(2.2F * kEndStar * static_cast<float>(i - 1));
        const bool in_middle = i == 1;
        draw_star_icon(list, {panel.box.middle_x() + dx, middle_y + m.px(in_middle ? -4.0F : 6.0F)},
                       m.px(in_middle ? 1.22F * kEndStar : kEndStar), i < stars);
    }
    list.text(panel.words, panel.box.x, panel.box.y + m.px(kEndStars - kPadY), panel.box.width,
              0.5F, list.colours().ink, list.colours().emphasis_ink);
}

}  // namespace

void draw_panels(const View& view, const PanelLayout& layout, const Measure& measure,
                 DrawList& list) {
    if (layout.level.box.width > 0.0F) {
        draw_level(view, layout.level, measure, list);
    }
    if (layout.score.box.width > 0.0F) {
        draw_score(layout.score, measure, list);
    }
    if (layout.lights.box.width > 0.0F) {
        draw_lights(view.lights, layout.lights, measure, list);
    }
    draw_buttons(view, layout.buttons, measure, list);
    if (layout.stars.box.width > 0.0F) {
        draw_stars(view.stars, layout.stars, measure, list);
    }
    if (layout.feedback.box.width > 0.0F) {
        draw_paper(list, layout.feedback.box, measure, list.colours().feedback_paper);
        draw_face(list, icon_place(layout.feedback, measure), measure.px(1.15F * kIcon), view.mood,
                  view.speaks);
        draw_words(list, layout.feedback, measure, kIconRoom, 0.0F, list.colours().ink);
    }
    if (layout.caption.box.width > 0.0F) {
        draw_paper(list, layout.caption.box, measure, list.colours().paper);
        draw_words(list, layout.caption, measure, 0.0F, 0.5F, list.colours().ink);
        // One helper, at what it says last; at its edge, so that it takes no room from the words.
        if (layout.feedback.box.width <= 0.0F && view.menu.empty()) {
            const float round = measure.px(1.35F * kIcon);
            const Point2 edge{std::max(layout.caption.box.x - measure.px(0.4F * kIcon), round),
                              layout.caption.box.middle_y()};
            list.fill_disc(edge, round, list.colours().paper);  // on a dark sky too
            draw_face(list, edge, measure.px(kIcon), ViewMood::calm, view.speaks);
        }
    }
    if (layout.input.box.width > 0.0F) {
        draw_input(view, layout.input, measure, list);
    }
    for (const Panel& choice : layout.choices) {
        draw_words(list, choice, measure, kIconRoom, 0.0F, list.colours().ink);
    }
    draw_why(layout.why, measure, list);
    if (layout.banner.box.width > 0.0F) {
        draw_banner(view, layout.banner, measure, list);
    }
}

}  // namespace fulcrum::runtime
