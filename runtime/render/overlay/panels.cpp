#include "runtime/render/overlay/panels.h"

#include "runtime/render/overlay/icons.h"
#include "runtime/render/overlay/microphone.h"
#include "runtime/render/overlay/paper.h"
#include "runtime/render/theme.h"

#include <algorithm>
#include <string>

namespace fulcrum::runtime {

namespace {

// At 720; see Measure.
constexpr float kMargin = 20.0F;
constexpr float kGap = 10.0F;
constexpr float kPadX = 26.0F;
constexpr float kPadY = 8.0F;
constexpr float kIcon = 19.0F;      // radius of an icon in a line of words
constexpr float kIconRoom = 54.0F;  // from a panel's padding to the words behind an icon
constexpr float kWidestWords = 1000.0F;
constexpr float kInputWidth = 760.0F;
constexpr float kCursor = 3.0F;
constexpr float kEndStar = 62.0F;
constexpr int kMostSpokenLines = 3;

struct WordSettings {
    float size = kSpokenText;
    float width = kWidestWords;  ///< in pixels
    int lines = kMostSpokenLines;
    Face face = Face::regular;
};

Paragraph set_words(const Font& font, const Measure& m, const MarkedText& text,
                    const WordSettings& settings) {
    ParagraphSettings p;
    p.size_px = m.text_px(settings.size);
    p.face = settings.face;
    p.width_px = settings.width;
    p.most_lines = settings.lines;
    return set_text(font, text, p);
}

/// Room for words between the screen's margins, less `taken`, at most kWidestWords.
float word_width(const Measure& m, float taken_at_720) {
    return std::max(std::min(m.px(kWidestWords), m.width_px - 2.0F * m.px(kMargin + kPadX)) -
                        m.px(taken_at_720),
                    m.px(kSpokenText));
}

void lay_out_banner(const View& view, const Font& font, const Measure& m, float top, Panel& panel) {
    const float width = m.width_px - 2.0F * m.px(kMargin);
    const float words = width - 2.0F * m.px(kPadX) - m.px(kIconRoom);
    panel.words = set_words(font, m, plain_text(view.banner), {kBodyText, words, 3});
    panel.box = {m.px(kMargin), top, width, panel.words.height_px + 2.0F * m.px(kPadY)};
}

/// Lesson's and level's names behind a badge with the level's number.
void lay_out_level(const View& view, const Font& font, const Measure& m, float top, Panel& panel) {
    const float badge = view.level > 0 ? kIconRoom : 0.0F;
    const float words = 0.5F * m.width_px - m.px(badge);
    const std::string& first = view.title.empty() ? view.level_title : view.title;
    const std::string& second = view.title.empty() ? std::string() : view.level_title;
    panel.words = set_words(font, m, plain_text(first), {kSmallText, words, 1, Face::bold});
    float height = panel.words.height_px;
    float width = panel.words.width_px;
    if (!second.empty()) {
        panel.second = set_words(font, m, plain_text(second), {kSmallText, words, 1});
        height += panel.second.height_px;
        width = std::max(width, panel.second.width_px);
    }
    const float pad = first.empty() ? m.px(10.0F) : m.px(kPadX);
    panel.box = {m.px(kMargin), top, width + m.px(badge) + m.px(14.0F) + pad,
                 std::max(height, m.px(2.0F * kIcon)) + 2.0F * m.px(10.0F)};
}

void lay_out_score(const View& view, const Font& font, const Measure& m, float top, Panel& panel) {
    panel.words = set_words(font, m, plain_text(std::to_string(view.score)),
                            {36.0F, m.width_px, 1, Face::bold});
    const float width = panel.words.width_px + m.px(kIconRoom + 16.0F + kPadX);
    panel.box = {m.width_px - m.px(kMargin) - width, top, width,
                 panel.words.height_px + 2.0F * m.px(7.0F)};
}

/// Above the line to type in, the first at the top; `bottom` rises above them.
void lay_out_choices(const View& view, const Font& font, const Measure& m, float& bottom,
                     PanelLayout& layout) {
    const float width = std::min(m.px(kInputWidth), m.width_px - 2.0F * m.px(kMargin));
    const float words = width - 2.0F * m.px(kPadX) - m.px(kIconRoom);
    for (const ViewChoice& choice : view.choices) {
        layout.choices.push_back(
            {{}, set_words(font, m, plain_text(choice.said), {kBodyText, words, 2}), {}});
    }
    for (std::size_t i = layout.choices.size(); i-- > 0;) {
        Panel& panel = layout.choices[i];
        const float height = panel.words.height_px + m.px(kPadY);
        panel.box = {0.5F * (m.width_px - width), bottom - height, width, height};
        bottom -= height + 0.5F * m.px(kGap);
    }
}

/// The panels at the bottom, stacked upwards from the screen's lower edge; the height above which is room.
float lay_out_bottom(const View& view, const Font& font, const Measure& m, PanelLayout& layout) {
    float bottom = m.height_px - m.px(kMargin);
    const auto stack = [&](Panel& panel, float width) {
        const float height = panel.words.height_px + 2.0F * m.px(kPadY);
        panel.box = {0.5F * (m.width_px - width), bottom - height, width, height};
        bottom -= height + m.px(kGap);
    };
    if (view.input_visible) {
        // What was typed last stays in sight: the line is set from its end.
        const float width = std::min(m.px(kInputWidth), m.width_px - 2.0F * m.px(kMargin));
        const float at_end = view.microphone.visible ? microphone_width_px(m) + m.px(kGap) : 0.0F;
        const float words =
            width - 2.0F * m.px(kPadX) - m.px(kIconRoom) - m.px(2.0F * kCursor) - at_end;
        // Before anything is typed the line says how to speak.
        MarkedText text = plain_text(view.input.empty() ? view.microphone.words : view.input);
        layout.input.words = set_words(font, m, text, {kSpokenText, 1e9F, 1});
        if (view.input.empty() && layout.input.words.width_px > words) {
            // A hint is read whole: smaller, where the line is short.
            const float size = kSpokenText * words / layout.input.words.width_px;
            layout.input.words = set_words(font, m, text, {size, 1e9F, 1});
        }
        const auto& letters = layout.input.words.lines.front().letters;
        std::size_t first = 0;
        while (!view.input.empty() && first < letters.size() &&
               layout.input.words.width_px - letters[first].x_px > words) {
            ++first;
        }
        if (first > 0) {
            text.characters.erase(0, first);
            text.emphasised.assign(text.characters.size(), false);
            layout.input.words = set_words(font, m, text, {kSpokenText, 1e9F, 1});
        }
        stack(layout.input, width);
    }
    lay_out_choices(view, font, m, bottom, layout);
    if (!view.caption.empty()) {
        layout.caption.words =
            set_words(font, m, read_emphasis(view.caption), {kSpokenText, word_width(m, 0.0F)});
        stack(layout.caption, layout.caption.words.width_px + 2.0F * m.px(kPadX));
    }
    return bottom;
}

bool meet(const Box& a, const Box& b) {
    return a.width > 0.0F && b.width > 0.0F && a.x < b.right() && b.x < a.right() &&
           a.y < b.bottom() && b.y < a.bottom();
}

/// What was said to the learner: below the top row, or above what is at the bottom when it would hide the hand.
void lay_out_feedback(const View& view, const Font& font, const Measure& m, float top, float bottom,
                      const Box& hand, PanelLayout& layout) {
    Panel& panel = layout.feedback;
    panel.words =
        set_words(font, m, read_emphasis(view.feedback), {kSpokenText, word_width(m, kIconRoom)});
    const float width = panel.words.width_px + 2.0F * m.px(kPadX) + m.px(kIconRoom);
    const float height = panel.words.height_px + 2.0F * m.px(kPadY);
    const Box high{0.5F * (m.width_px - width), top, width, height};
    const Box low{high.x, std::max(bottom - height, top), width, height};
    bool& is_low = layout.moved.feedback_is_low;
    if (meet(hand, is_low ? low : high) && !meet(hand, is_low ? high : low)) {
        is_low = !is_low;
    }
    panel.box = is_low ? low : high;
}

void lay_out_stars(const Measure& m, Panel& panel) {
    const float width = m.px(7.4F * kEndStar);
    const float height = m.px(3.0F * kEndStar);
    panel.box = {0.5F * (m.width_px - width), 0.45F * m.height_px - 0.5F * height, width, height};
}

/// Words in a panel, behind `indent` at 720.
void draw_words(DrawList& list, const Panel& panel, const Measure& m, float indent, float align,
                const Colour& ink) {
    const float room = panel.box.width - 2.0F * m.px(kPadX) - m.px(indent);
    list.text(panel.words, panel.box.x + m.px(kPadX + indent),
              panel.box.middle_y() - 0.5F * panel.words.height_px, room, align, ink,
              theme::kEmphasisInk);
}

Point2 icon_place(const Panel& panel, const Measure& m) {
    return {panel.box.x + m.px(kPadX + kIcon), panel.box.middle_y()};
}

void draw_banner(const View& view, const Panel& panel, const Measure& m, DrawList& list) {
    const bool error = view.banner_is_error;
    draw_paper(list, panel.box, m, error ? theme::kErrorPaper : theme::kFeedbackPaper);
    list.frame_box(panel.box, m.px(kPaperRadius), m.px(4.0F),
                   error ? theme::kVermillion : theme::kBlue);
    if (error) {
        draw_warning_icon(list, icon_place(panel, m), m.px(1.15F * kIcon));
    } else {
        draw_notice_icon(list, icon_place(panel, m), m.px(kIcon));
    }
    draw_words(list, panel, m, kIconRoom, 0.0F, error ? theme::kErrorInk : theme::kInk);
}

void draw_level(const View& view, const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, theme::kPaper);
    float x = panel.box.x + m.px(14.0F);
    if (view.level > 0) {
        const float radius = m.px(1.2F * kIcon);
        list.fill_disc({x + radius, panel.box.middle_y()}, radius, theme::kEmphasisInk);
        const Paragraph number = set_words(list.font(), m, plain_text(std::to_string(view.level)),
                                           {kSmallText, 4.0F * radius, 1, Face::bold});
        list.text(number, x, panel.box.middle_y() - 0.5F * number.height_px, 2.0F * radius, 0.5F,
                  theme::kPaper, theme::kPaper);
        x += m.px(kIconRoom);
    } else {
        x += m.px(kPadX - 14.0F);
    }
    const float height = panel.words.height_px + panel.second.height_px;
    const float top = panel.box.middle_y() - 0.5F * height;
    list.text(panel.words, x, top, 0.0F, 0.0F, theme::kInk, theme::kEmphasisInk);
    list.text(panel.second, x, top + panel.words.height_px, 0.0F, 0.0F, theme::kSoftInk,
              theme::kEmphasisInk);
}

void draw_score(const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, theme::kPaper);
    draw_star_icon(list, {panel.box.x + m.px(16.0F + 1.15F * kIcon), panel.box.middle_y()},
                   m.px(1.25F * kIcon), true);
    list.text(panel.words, panel.box.x + m.px(16.0F + kIconRoom),
              panel.box.middle_y() - 0.5F * panel.words.height_px, 0.0F, 0.0F, theme::kInk,
              theme::kInk);
}

void draw_input(const View& view, const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, theme::kFieldPaper);
    list.frame_box(panel.box, m.px(kPaperRadius), m.px(4.0F), theme::kBlue);
    draw_pencil_icon(list, icon_place(panel, m), m.px(kIcon));
    const bool typed = !view.input.empty();
    draw_words(list, panel, m, kIconRoom, 0.0F, typed ? theme::kInk : theme::kSoftInk);
    if (view.microphone.visible) {
        draw_microphone(list, {panel.box.right() - m.px(kPadX), panel.box.middle_y()}, m,
                        view.microphone);
    }
    const float x = panel.box.x + m.px(kPadX + kIconRoom) +
                    (typed ? panel.words.width_px + m.px(kCursor) : -m.px(2.0F * kCursor));
    const float height = 0.62F * panel.box.height;
    list.fill_box({x, panel.box.middle_y() - 0.5F * height, std::max(m.px(kCursor), 1.0F), height},
                  0.0F, theme::kBlue);
}

void draw_stars(int stars, const Panel& panel, const Measure& m, DrawList& list) {
    draw_paper(list, panel.box, m, theme::kPaper);
    for (int i = 0; i < 3; ++i) {
        const float dx = m.px(2.2F * kEndStar * static_cast<float>(i - 1));
        const bool in_middle = i == 1;
        draw_star_icon(
            list,
            {panel.box.middle_x() + dx, panel.box.middle_y() + m.px(in_middle ? -4.0F : 6.0F)},
            m.px(in_middle ? 1.22F * kEndStar : kEndStar), i < stars);
    }
}

/// Level on the left, score on the right; the height below which is room.
float lay_out_top_row(const View& view, const Font& font, const Measure& m, float top,
                      PanelLayout& layout) {
    lay_out_score(view, font, m, top, layout.score);
    layout.buttons = lay_out_buttons(view, m, layout.score.box.x - m.px(kGap), top);
    float bottom = layout.score.box.bottom();
    if (view.level > 0 || !view.title.empty() || !view.level_title.empty()) {
        lay_out_level(view, font, m, top, layout.level);
        bottom = std::max(bottom, layout.level.box.bottom());
    }
    return bottom + m.px(kGap);
}

/// Between what stands above and what stands below; on the left, or on the right when it would hide the hand.
void lay_out_why_beside(const View& view, const Font& font, const Measure& m, float top,
                        float bottom, const Box& hand, PanelLayout& layout) {
    if (const Box& said = layout.feedback.box; said.width > 0.0F) {
        (layout.moved.feedback_is_low ? bottom : top) =
            layout.moved.feedback_is_low ? said.y - m.px(kGap) : said.bottom() + m.px(kGap);
    }
    const float margin = m.px(kMargin);
    const Box room{margin, top, m.width_px - 2.0F * margin, bottom - top};
    layout.why = lay_out_why(view.why, font, m, room);
    const Box left = layout.why.box;
    const Box right{room.right() - left.width, left.y, left.width, left.height};
    bool& is_right = layout.moved.why_is_right;
    if (meet(hand, is_right ? right : left) && !meet(hand, is_right ? left : right)) {
        is_right = !is_right;
    }
    if (is_right && left.width > 0.0F) {
        layout.why = lay_out_why(view.why, font, m, {right.x, top, right.width, room.height});
    }
}

}  // namespace

std::vector<Box> PanelLayout::shown() const {
    std::vector<Box> boxes;
    for (const Panel* panel : {&banner, &level, &score, &feedback, &caption, &input, &stars}) {
        if (panel->box.width > 0.0F) {
            boxes.push_back(panel->box);
        }
    }
    for (const Panel& choice : choices) {
        boxes.push_back(choice.box);
    }
    if (why.box.width > 0.0F) {
        boxes.push_back(why.box);
    }
    boxes.insert(boxes.end(), buttons.begin(), buttons.end());
    return boxes;
}

PanelLayout lay_out_panels(const View& view, Font& font, const Measure& measure, const Box& hand,
                           const MovedPanels& before) {
    PanelLayout layout;
    layout.moved = {view.feedback, before.feedback_is_low && before.said == view.feedback,
                    before.why_is_right && view.why.visible};
    float top = measure.px(kMargin);
    if (view.menu.empty()) {
        top = lay_out_top_row(view, font, measure, top, layout);
    }
    if (!view.banner.empty()) {
        lay_out_banner(view, font, measure, top, layout.banner);
        top = layout.banner.box.bottom() + measure.px(kGap);
    }
    const float bottom = lay_out_bottom(view, font, measure, layout);
    if (!view.feedback.empty()) {
        lay_out_feedback(view, font, measure, top, bottom, hand, layout);
    }
    if (view.menu.empty() && view.stars >= 0) {
        lay_out_stars(measure, layout.stars);
    } else if (view.menu.empty()) {
        lay_out_why_beside(view, font, measure, top, bottom, hand, layout);
    }
    return layout;
}

Box choice_picture(const Panel& panel, const Measure& m) {
    const float side = panel.box.height;
    return {panel.box.x + m.px(kPadX) - 0.5F * (side - m.px(2.0F * kIcon)), panel.box.y, side,
            side};
}

void draw_choice_papers(const View& view, const PanelLayout& layout, const Measure& m,
                        DrawList& list) {
    for (std::size_t i = 0; i < layout.choices.size(); ++i) {
        const Box& box = layout.choices[i].box;
        const bool chosen = static_cast<int>(i) == view.chosen;
        draw_paper(list, box, m, chosen ? theme::kSelectedPaper : theme::kFieldPaper);
        // Not by its colour alone.
        if (chosen) {
            list.frame_box(box, m.px(kPaperRadius), m.px(4.0F), theme::kBlue);
        }
    }
}

void draw_panels(const View& view, const PanelLayout& layout, const Measure& measure,
                 DrawList& list) {
    if (layout.level.box.width > 0.0F) {
        draw_level(view, layout.level, measure, list);
    }
    if (layout.score.box.width > 0.0F) {
        draw_score(layout.score, measure, list);
    }
    draw_buttons(view, layout.buttons, measure, list);
    if (layout.stars.box.width > 0.0F) {
        draw_stars(view.stars, layout.stars, measure, list);
    }
    if (layout.feedback.box.width > 0.0F) {
        draw_paper(list, layout.feedback.box, measure, theme::kFeedbackPaper);
        draw_speech_icon(list, icon_place(layout.feedback, measure), measure.px(kIcon));
        draw_words(list, layout.feedback, measure, kIconRoom, 0.0F, theme::kInk);
    }
    if (layout.caption.box.width > 0.0F) {
        draw_paper(list, layout.caption.box, measure, theme::kPaper);
        draw_words(list, layout.caption, measure, 0.0F, 0.5F, theme::kInk);
    }
    if (layout.input.box.width > 0.0F) {
        draw_input(view, layout.input, measure, list);
    }
    for (const Panel& choice : layout.choices) {
        draw_words(list, choice, measure, kIconRoom, 0.0F, theme::kInk);
    }
    draw_why(layout.why, measure, list);
    if (layout.banner.box.width > 0.0F) {
        draw_banner(view, layout.banner, measure, list);
    }
}

}  // namespace fulcrum::runtime
