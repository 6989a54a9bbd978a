#include "runtime/render/overlay/panels.h"

#include "runtime/render/overlay/microphone.h"

#include <algorithm>
#include <string>
#include <utility>

namespace fulcrum::runtime {

namespace {

constexpr int kMostFeedbackLines = 4;  // what was said, what is better, and why

/// Room for words between the screen's margins, less `taken`, at most kWidestWords.
float word_width(const Measure& m, float taken_at_720) {
    return std::max(std::min(m.px(kWidestWords), m.width_px - 2.0F * m.px(kMargin + kPadX)) -
                        m.px(taken_at_720),
                    m.px(kSpokenText));
}

/// Lesson's and level's names behind a badge with the level's number, left of `right`.
void lay_out_level(const View& view, const Font& font, const Measure& m, float top, float right,
                   Panel& panel) {
    const float badge = view.level > 0 ? kIconRoom : 0.0F;
    const float words = std::max(
        std::min(0.5F * m.width_px, right - m.px(kMargin + kLevelPad + kPadX)) - m.px(badge),
        m.px(kSmallText));
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
    panel.box = {m.px(kMargin), top, width + m.px(badge) + m.px(kLevelPad) + pad,
                 std::max(height, m.px(2.0F * kIcon)) + 2.0F * m.px(10.0F)};
}

void lay_out_score(const View& view, const Font& font, const Measure& m, float top, Panel& panel) {
    panel.words = set_words(font, m, plain_text(std::to_string(view.score)),
                            {36.0F, m.width_px, 1, Face::bold});
    const float width = panel.words.width_px + m.px(kIconRoom + 16.0F + kPadX);
    panel.box = {m.width_px - m.px(kMargin) - width, top, width,
                 panel.words.height_px + 2.0F * m.px(7.0F)};
}

/// A sign for each body that is offered or lit, and how many are; below the level.
void lay_out_lights(const View& view, const Font& font, const Measure& m, float top, Panel& panel) {
    const auto n_lit = std::ranges::count(view.lights, true);
    panel.words = set_words(
        font, m, plain_text(std::to_string(n_lit) + " / " + std::to_string(view.lights.size())),
        {kSmallText, m.width_px, 1, Face::bold});
    const auto n_signs = static_cast<float>(std::min(view.lights.size(), kMostLightSigns));
    panel.box = {m.px(kMargin), top,
                 panel.words.width_px + m.px(2.0F * kLevelPad + kPadY + n_signs * kLightSign),
                 panel.words.height_px + m.px(kPadY)};
}

/// The line to type in, at the screen's lower edge; the height above which is room.
float lay_out_input(const View& view, const Font& font, const Measure& m, PanelLayout& layout) {
    const float bottom = m.height_px - m.px(kMargin);
    if (!view.input_visible) {
        return bottom;
    }
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
    const std::size_t first =
        view.input.empty() ? 0 : characters_to_drop(layout.input.words.lines.front(), words);
    if (first > 0) {
        text.characters.erase(0, first);
        text.emphasised.assign(text.characters.size(), false);
        layout.input.words = set_words(font, m, text, {kSpokenText, 1e9F, 1});
    }
    const float height = layout.input.words.height_px + 2.0F * m.px(kPadY);
    layout.input.box = {0.5F * (m.width_px - width), bottom - height, width, height};
    return layout.input.box.y - m.px(kGap);
}

/// How much is hidden: a thing counts one, the hand more than all.
std::ptrdiff_t count_hidden(const std::vector<Box>& boxes, const Box& hand,
                            const std::vector<Box>& things) {
    const auto hides = [&](const Box& thing) {
        return std::ranges::any_of(boxes, [&](const Box& box) { return thing.meets(box); });
    };
    return std::ranges::count_if(things, hides) +
           (hides(hand) ? static_cast<std::ptrdiff_t>(things.size()) + 1 : 0);
}

std::vector<Box> lowered(std::vector<Box> boxes, float by_px) {
    for (Box& box : boxes) {
        box.y += by_px;
    }
    return boxes;
}

/// Panels that have been laid out above `bottom` stay there, or go below `top` where they hide less; the room is less by them. Where it is
/// `settled` they are where they were.
void find_height(const std::vector<Box*>& panels, float gap_px, const Box& hand,
                 const std::vector<Box>& things, bool settled, bool& is_high, float& top,
                 float& bottom) {
    if (panels.empty()) {
        is_high = false;
        return;
    }
    std::vector<Box> low;
    low.reserve(panels.size());
    for (const Box* panel : panels) {
        low.push_back(*panel);
    }
    const float first = std::ranges::min_element(low, {}, &Box::y)->y;
    const Box& last =
        *std::ranges::max_element(low, {}, [](const Box& box) { return box.bottom(); });
    const float height = last.bottom() - first;
    const std::vector<Box> high = lowered(low, top - first);
    const bool fits = top + height + gap_px < bottom - height;
    if (!settled) {
        const auto hidden_low = count_hidden(low, hand, things);
        const auto hidden_high = count_hidden(high, hand, things);
        is_high = is_high ? hidden_high <= hidden_low : hidden_high < hidden_low;
    }
    is_high = is_high && fits;
    if (!is_high) {
        bottom = first - gap_px;
        return;
    }
    for (std::size_t i = 0; i < panels.size(); ++i) {
        *panels[i] = high[i];
    }
    top += height + gap_px;
}

/// Caption and choices above the input or, where they would hide something there, below the top row.
void lay_out_asked(const View& view, const Font& font, const Measure& m, const Box& hand,
                   const std::vector<Box>& things, const std::vector<std::string>& choices_before,
                   float& top, float& bottom, PanelLayout& layout) {
    float above = bottom;
    layout.choices = lay_out_choices(view, font, m, above);
    std::vector<Box*> choices;
    for (Panel& choice : layout.choices) {
        choices.push_back(&choice.box);
    }
    for (const ViewChoice& choice : view.choices) {
        layout.moved.choices.push_back(choice.said);
    }
    // What is asked stands above what may be answered.
    Panel& caption = layout.caption;
    std::vector<Box*> words;
    if (!view.caption.empty()) {
        caption.words =
            set_words(font, m, read_emphasis(view.caption), {kSpokenText, word_width(m, 0.0F)});
        const float width = caption.words.width_px + 2.0F * m.px(kPadX);
        caption.box = {0.5F * (m.width_px - width), 0.0F, width,
                       caption.words.height_px + 2.0F * m.px(kPadY)};
        words.push_back(&caption.box);
    }
    find_height(choices, m.px(0.5F * kGap), hand, things, layout.moved.choices == choices_before,
                layout.moved.choices_are_high, top, bottom);
    caption.box.y = bottom - caption.box.height;
    find_height(words, m.px(kGap), hand, things, false, layout.moved.caption_is_high, top, bottom);
}

constexpr float kNoticeWidth = 360.0F;  // at a side
constexpr int kMostNoticeLines = 8;     // there

Panel banner_at(BannerPlace place, const View& view, const Font& font, const Measure& m, float top,
                float bottom) {
    const bool at_side = place == BannerPlace::left || place == BannerPlace::right;
    const float page = m.width_px - 2.0F * m.px(kMargin);
    const float width = at_side ? std::min(m.px(kNoticeWidth), page) : page;
    const float words = width - 2.0F * m.px(kPadX) - m.px(kIconRoom);
    Panel panel;
    panel.words = set_words(font, m, plain_text(view.banner),
                            {kBodyText, words, at_side ? kMostNoticeLines : kMostSpokenLines});
    const float height = panel.words.height_px + 2.0F * m.px(kPadY);
    panel.box = {place == BannerPlace::right ? m.width_px - m.px(kMargin) - width : m.px(kMargin),
                 place == BannerPlace::across_bottom ? bottom - height : top, width, height};
    return panel;
}

/// Across the top; a notice moves where it hides neither the hand nor, where there is room, things. The room between `top` and
/// `bottom` is less by it.
void lay_out_banner(const View& view, const Font& font, const Measure& m, const Box& hand,
                    const std::vector<Box>& things, float& top, float& bottom,
                    PanelLayout& layout) {
    const auto hidden = [&](const Panel& panel) { return count_hidden({panel.box}, hand, things); };
    BannerPlace& place = layout.moved.notice_place;
    const bool moves = !view.banner_is_error && view.menu.empty() && view.stars < 0;
    place = moves ? place : BannerPlace::across_top;
    layout.banner = banner_at(place, view, font, m, top, bottom);
    std::vector<BannerPlace> others;
    if (moves) {
        others = {BannerPlace::across_top, BannerPlace::across_bottom};
        // Nothing else stands beside them.
        if (view.feedback.empty() && !view.why.visible) {
            others.insert(others.end(), {BannerPlace::left, BannerPlace::right});
        } else if (place == BannerPlace::left || place == BannerPlace::right) {
            place = BannerPlace::across_top;
            layout.banner = banner_at(place, view, font, m, top, bottom);
        }
    }
    for (const BannerPlace other : others) {
        Panel there = banner_at(other, view, font, m, top, bottom);
        const bool fits =
            !there.words.shortened && there.box.y >= top && there.box.bottom() <= bottom;
        if (fits && hidden(there) < hidden(layout.banner)) {
            place = other;
            layout.banner = std::move(there);
        }
    }
    if (place == BannerPlace::across_bottom) {
        bottom = layout.banner.box.y - m.px(kGap);
    } else {
        top = layout.banner.box.bottom() + m.px(kGap);
    }
}

/// What was said to the learner: below the top row, or above what is at the bottom when it would hide the hand.
void lay_out_feedback(const View& view, const Font& font, const Measure& m, float top, float bottom,
                      const Box& hand, PanelLayout& layout) {
    Panel& panel = layout.feedback;
    const bool is_long = view.feedback.find('\n') != std::string::npos;
    panel.words = set_words(
        font, m, read_emphasis(view.feedback),
        {is_long ? kBodyText : kSpokenText, word_width(m, kIconRoom), kMostFeedbackLines});
    const float width = panel.words.width_px + 2.0F * m.px(kPadX) + m.px(kIconRoom);
    const float height = panel.words.height_px + 2.0F * m.px(kPadY);
    const Box high{0.5F * (m.width_px - width), top, width, height};
    const Box low{high.x, std::max(bottom - height, top), width, height};
    bool& is_low = layout.moved.feedback_is_low;
    if (hand.meets(is_low ? low : high) && !hand.meets(is_low ? high : low)) {
        is_low = !is_low;
    }
    panel.box = is_low ? low : high;
}

/// Stars, and below them why; as near to the middle as what stands above and below lets them.
void lay_out_stars(const View& view, const Font& font, const Measure& m, float top, float bottom,
                   Panel& panel) {
    float width = m.px(7.4F * kEndStar);
    float height = m.px(kEndStars);
    if (!view.end_note.empty()) {
        panel.words = set_words(font, m, plain_text(view.end_note),
                                {kBodyText, word_width(m, kWidestWords - kEndNote), 3});
        width = std::max(width, panel.words.width_px + 2.0F * m.px(kPadX));
        height += panel.words.height_px + m.px(kPadY);
    }
    const float y = std::min(0.45F * m.height_px - 0.5F * height, bottom - height);
    panel.box = {0.5F * (m.width_px - width), std::max(y, top), width, height};
}

/// Level on the left, score on the right; the height below which is room.
float lay_out_top_row(const View& view, const Font& font, const Measure& m, float top,
                      PanelLayout& layout) {
    lay_out_score(view, font, m, top, layout.score);
    layout.buttons = lay_out_buttons(view, m, layout.score.box.x - m.px(kGap), top);
    float bottom = layout.score.box.bottom();
    if (view.level > 0 || !view.title.empty() || !view.level_title.empty()) {
        const float right = layout.buttons.empty() ? layout.score.box.x : layout.buttons.front().x;
        lay_out_level(view, font, m, top, right - m.px(kGap), layout.level);
        bottom = std::max(bottom, layout.level.box.bottom());
    }
    if (!view.lights.empty()) {
        lay_out_lights(view, font, m, bottom + m.px(kGap), layout.lights);
        bottom = layout.lights.box.bottom();
    }
    return bottom + m.px(kGap);
}

/// Of the room from top to bottom what the feedback, which stands at one end of it, leaves.
void leave_feedback(const PanelLayout& layout, const Measure& m, float& top, float& bottom) {
    if (const Box& said = layout.feedback.box; said.width > 0.0F) {
        (layout.moved.feedback_is_low ? bottom : top) =
            layout.moved.feedback_is_low ? said.y - m.px(kGap) : said.bottom() + m.px(kGap);
    }
}

/// Between what stands above and what stands below; on the left, or on the right when it would hide the hand.
void lay_out_why_beside(const View& view, const Font& font, const Measure& m, float top,
                        float bottom, const Box& hand, PanelLayout& layout) {
    leave_feedback(layout, m, top, bottom);
    const float margin = m.px(kMargin);
    const Box room{margin, top, m.width_px - 2.0F * margin, bottom - top};
    layout.why = lay_out_why(view.why, font, m, room);
    const Box left = layout.why.box;
    const Box right{room.right() - left.width, left.y, left.width, left.height};
    bool& is_right = layout.moved.why_is_right;
    if (hand.meets(is_right ? right : left) && !hand.meets(is_right ? left : right)) {
        is_right = !is_right;
    }
    if (is_right && left.width > 0.0F) {
        layout.why = lay_out_why(view.why, font, m, {right.x, top, right.width, room.height});
    }
}

}  // namespace

std::vector<Box> PanelLayout::shown() const {
    std::vector<Box> boxes = papers();
    boxes.insert(boxes.end(), buttons.begin(), buttons.end());
    return boxes;
}

std::vector<Box> PanelLayout::papers() const {
    std::vector<Box> boxes;
    for (const Panel* panel :
         {&banner, &level, &score, &lights, &feedback, &caption, &input, &stars}) {
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
    return boxes;
}

PanelLayout lay_out_panels(const View& view, Font& font, const Measure& measure, const Box& hand,
                           const MovedPanels& before, const std::vector<Box>& things) {
    PanelLayout layout;
    layout.moved = {view.feedback,
                    before.feedback_is_low && before.said == view.feedback,
                    before.why_is_right && view.why.visible,
                    view.banner,
                    before.notice == view.banner ? before.notice_place : BannerPlace::across_top,
                    view.caption,
                    before.caption_is_high && before.caption == view.caption,
                    {},
                    before.choices_are_high && !view.choices.empty()};
    float top = measure.px(kMargin);
    if (view.menu.empty()) {
        top = lay_out_top_row(view, font, measure, top, layout);
    } else {
        layout.buttons = lay_out_buttons(view, measure, measure.width_px - top, top);
    }
    float bottom = lay_out_input(view, font, measure, layout);
    lay_out_asked(view, font, measure, hand, things, before.choices, top, bottom, layout);
    if (!view.banner.empty()) {
        lay_out_banner(view, font, measure, hand, things, top, bottom, layout);
    }
    if (!view.feedback.empty()) {
        lay_out_feedback(view, font, measure, top, bottom, hand, layout);
    }
    if (view.menu.empty() && view.stars >= 0) {
        leave_feedback(layout, measure, top, bottom);
        lay_out_stars(view, font, measure, top, bottom, layout.stars);
    } else if (view.menu.empty()) {
        lay_out_why_beside(view, font, measure, top, bottom, hand, layout);
    }
    return layout;
}

}  // namespace fulcrum::runtime
