#include "runtime/render/overlay/menu.h"

#include "runtime/render/overlay/icons.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/theme.h"

#include <algorithm>

namespace fulcrum::runtime {

namespace {

// At 720.
constexpr float kMargin = 48.0F;
constexpr float kGap = 28.0F;
constexpr float kHeadlineRoom = 108.0F;
constexpr float kTallestCard = 430.0F;
constexpr float kLeastCardHeight = 215.0F;
constexpr float kWidestCard = 360.0F;
constexpr float kLeastCardWidth = 250.0F;
constexpr float kPad = 18.0F;
constexpr float kChosenFrame = 8.0F;
constexpr float kRadius = 22.0F;
constexpr float kTick = 24.0F;

int fitting(float room, float least, float gap) {
    return std::max(static_cast<int>((room + gap) / (least + gap)), 1);
}

/// The height that a card's words take: two lines of title, one of subtitle.
float words_height(const Measure& m) {
    return m.px(1.3F * (2.0F * kBodyText + kSmallText));
}

Paragraph card_words(DrawList& list, const Measure& m, const std::string& text, float size,
                     Face face, float width, int lines) {
    ParagraphSettings settings;
    settings.size_px = m.text_px(size);
    settings.face = face;
    settings.width_px = width;
    settings.most_lines = lines;
    return set_text(list.font(), plain_text(text), settings);
}

}  // namespace

MenuLayout lay_out_menu(const View& view, const Measure& m, float top_px, float bottom_px) {
    MenuLayout layout;
    layout.top_px = top_px;
    layout.bottom_px = bottom_px;
    if (view.menu.empty()) {
        return layout;
    }
    // As few rows as the width allows, and no more than the height allows.
    const int count = static_cast<int>(view.menu.size());
    const float gap = m.px(kGap);
    const float width_room = m.width_px - 2.0F * m.px(kMargin);
    const float height_room = std::max(bottom_px - top_px, m.px(kLeastCardHeight));
    const int most_columns = fitting(width_room, m.px(kLeastCardWidth), gap);
    const int all_rows = (count + most_columns - 1) / most_columns;
    const int columns = (count + all_rows - 1) / all_rows;
    const int rows = std::min(all_rows, fitting(height_room, m.px(kLeastCardHeight), gap));
    const auto room_each = [&](float room, int n) {
        return (room - gap * static_cast<float>(n - 1)) / static_cast<float>(n);
    };
    const float width = std::min(room_each(width_room, columns), m.px(kWidestCard));
    const float height = std::min(room_each(height_room, rows), m.px(kTallestCard));

    const int chosen = std::clamp(view.menu_selected, 0, count - 1);
    const int first_row = std::clamp(chosen / columns - rows / 2, 0, all_rows - rows);
    layout.more_above = first_row > 0;
    layout.more_below = first_row + rows < all_rows;
    const float used_height =
        height * static_cast<float>(rows) + gap * static_cast<float>(rows - 1);
    const float top = top_px + 0.5F * (height_room - used_height);
    for (int i = first_row * columns; i < std::min(count, (first_row + rows) * columns); ++i) {
        const int row = i / columns - first_row;
        const int in_row = std::min(columns, count - (i / columns) * columns);
        const float row_width =
            width * static_cast<float>(in_row) + gap * static_cast<float>(in_row - 1);
        MenuCard card;
        card.index = static_cast<std::size_t>(i);
        card.chosen = i == chosen;
        card.box = {
            0.5F * (m.width_px - row_width) + static_cast<float>(i % columns) * (width + gap),
            top + static_cast<float>(row) * (height + gap), width, height};
        const float icon_height = std::max(height - words_height(m) - 2.0F * m.px(kPad), 1.0F);
        card.icon = {card.box.x + m.px(kPad), card.box.y + m.px(kPad), width - 2.0F * m.px(kPad),
                     icon_height};
        layout.cards.push_back(card);
    }
    return layout;
}

MenuLayout lay_out_menu(const View& view, const Measure& m, const std::vector<Box>& panels) {
    // Panels in the upper half push the cards down, those in the lower half push them up.
    float top = m.px(0.4F * kGap);
    float bottom = m.height_px - m.px(kGap);
    for (const Box& panel : panels) {
        if (panel.middle_y() < 0.5F * m.height_px) {
            top = std::max(top, panel.bottom());
        } else {
            bottom = std::min(bottom, panel.y - m.px(kGap));
        }
    }
    if (!view.title.empty()) {
        top += m.px(kHeadlineRoom);
    }
    return lay_out_menu(view, m, top, bottom);
}

void draw_menu_papers(const MenuLayout& layout, const Measure& m, DrawList& list) {
    const auto draw_icon_ground = [&](const MenuCard& card) {
        list.fill_disc({card.icon.middle_x(), card.icon.middle_y()},
                       0.5F * std::min(card.icon.width, card.icon.height), theme::kIconPaper);
    };
    for (const MenuCard& card : layout.cards) {
        if (!card.chosen) {
            draw_paper(list, card.box, m, theme::kPaper);
            draw_icon_ground(card);
            continue;
        }
        // The chosen card is larger, has a thick frame, and a tick later on.
        const Box box = card.box.grown(m.px(kChosenFrame));
        draw_paper(list, box, m, theme::kSelectedPaper);
        list.frame_box(box, m.px(kRadius), m.px(kChosenFrame), theme::kBlue);
        draw_icon_ground(card);
    }
}

void draw_menu_words(const View& view, const MenuLayout& layout, const Measure& m, DrawList& list) {
    if (!view.title.empty()) {
        const Paragraph title =
            card_words(list, m, view.title, kHeadline, Face::bold, 0.9F * m.width_px, 1);
        list.text(title, 0.0F, layout.top_px - m.px(0.5F * kHeadlineRoom) - 0.5F * title.height_px,
                  m.width_px, 0.5F, theme::kInk, theme::kInk);
    }
    for (const MenuCard& card : layout.cards) {
        const ViewMenuItem& item = view.menu[card.index];
        const float width = card.box.width - 2.0F * m.px(kPad);
        const Paragraph title = card_words(list, m, item.title, kBodyText, Face::bold, width, 2);
        const Paragraph subtitle =
            card_words(list, m, item.subtitle, kSmallText, Face::regular, width, 1);
        const float x = card.box.x + m.px(kPad);
        const float top =
            card.icon.bottom() + 0.5F * (words_height(m) - title.height_px - subtitle.height_px);
        list.text(title, x, top, width, 0.5F, theme::kInk, theme::kInk);
        list.text(subtitle, x, top + title.height_px, width, 0.5F, theme::kSoftInk, theme::kInk);
        if (card.chosen) {
            draw_tick_icon(list, {card.box.right() - m.px(2.0F), card.box.y + m.px(2.0F)},
                           m.px(kTick));
        }
    }
    if (layout.more_above) {
        draw_more_icon(list, {0.5F * m.width_px, layout.top_px - m.px(4.0F)}, m.px(16.0F), true);
    }
    if (layout.more_below) {
        draw_more_icon(list, {0.5F * m.width_px, layout.bottom_px + m.px(10.0F)}, m.px(16.0F),
                       false);
    }
}

}  // namespace fulcrum::runtime
