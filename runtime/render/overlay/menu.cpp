#include "runtime/render/overlay/menu.h"

#include "runtime/render/overlay/icons.h"
#include "runtime/render/overlay/paper.h"
#include "runtime/render/theme.h"
#include "runtime/scene/lesson_limits.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {

namespace {

// At 720.
constexpr float kMenuMargin = 48.0F;
constexpr float kCardGap = 20.0F;
constexpr float kHeadlineRoom = 74.0F;
constexpr float kTallestCard = 430.0F;
constexpr float kLeastCardHeight = 200.0F;
constexpr float kWidestCard = 360.0F;
constexpr float kLeastCardWidth = 250.0F;
constexpr float kPad = 18.0F;
constexpr float kChosenFrame = 8.0F;
constexpr float kCardRadius = 22.0F;
constexpr float kTick = 24.0F;
constexpr float kCardStar = 12.0F;   // radius
constexpr float kSign = 20.0F;       // radius of the sign that there are more rows
constexpr float kSignArrow = 11.0F;  // of the arrow on it

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

/// A card's size and how many there are.
struct Grid {
    int count = 0;
    float gap = 0.0F;
    float width = 0.0F;   // of a card
    float height = 0.0F;  // of a card
    float top = 0.0F;     // of the first row in sight
};

/// As few rows as the width allows, and no more than the height allows.
Grid lay_out_grid(int count, const Measure& m, MenuLayout& layout) {
    Grid grid;
    grid.count = count;
    grid.gap = m.px(kCardGap);
    const float width_room = m.width_px - 2.0F * m.px(kMenuMargin);
    const float height_room = std::max(layout.bottom_px - layout.top_px, m.px(kLeastCardHeight));
    const int most_columns = fitting(width_room, m.px(kLeastCardWidth), grid.gap);
    layout.all_rows = (count + most_columns - 1) / most_columns;
    layout.columns = (count + layout.all_rows - 1) / layout.all_rows;
    layout.rows = std::min(layout.all_rows, fitting(height_room, m.px(kLeastCardHeight), grid.gap));
    const auto room_each = [&](float room, int n) {
        return (room - grid.gap * static_cast<float>(n - 1)) / static_cast<float>(n);
    };
    grid.width = std::min(room_each(width_room, layout.columns), m.px(kWidestCard));
    grid.height = std::min(room_each(height_room, layout.rows), m.px(kTallestCard));
    const auto rows = static_cast<float>(layout.rows);
    grid.top = layout.top_px + 0.5F * (height_room - grid.height * rows - grid.gap * (rows - 1.0F));
    return grid;
}

MenuCard lay_out_card(int index, bool chosen, const Grid& grid, const Measure& m,
                      const MenuLayout& layout) {
    const int row = index / layout.columns;
    const int in_row = std::min(layout.columns, grid.count - row * layout.columns);
    const float row_width = (grid.width + grid.gap) * static_cast<float>(in_row) - grid.gap;
    const int column = index % layout.columns;
    MenuCard card;
    card.index = static_cast<std::size_t>(index);
    card.chosen = chosen;
    card.box = {
        0.5F * (m.width_px - row_width) + static_cast<float>(column) * (grid.width + grid.gap),
        grid.top + static_cast<float>(row - layout.first_row) * (grid.height + grid.gap),
        grid.width, grid.height};
    card.paper = chosen ? card.box.grown(m.px(kChosenFrame)) : card.box;
    card.icon = {card.box.x + m.px(kPad), card.box.y + m.px(kPad), grid.width - 2.0F * m.px(kPad),
                 std::max(grid.height - words_height(m) - 2.0F * m.px(kPad), 1.0F)};
    return card;
}

/// The signs that there are more rows, in the margin right of the cards, where there are.
void lay_out_signs(const Grid& grid, const Measure& m, MenuLayout& layout) {
    const float side = 2.0F * m.px(kSign);
    const float x = m.width_px - 0.5F * m.px(kMenuMargin) - 0.5F * side;
    if (layout.first_row > 0) {
        layout.earlier = {x, grid.top, side, side};
    }
    if (layout.first_row + layout.rows < layout.all_rows) {
        const auto rows = static_cast<float>(layout.rows);
        const float bottom = grid.top + rows * (grid.height + grid.gap) - grid.gap;
        layout.later = {x, bottom - side, side, side};
    }
}

}  // namespace

MenuLayout lay_out_menu(const View& view, const Measure& m, float top_px, float bottom_px) {
    MenuLayout layout;
    layout.top_px = top_px;
    layout.bottom_px = bottom_px;
    if (view.menu.empty()) {
        return layout;
    }
    const int count = static_cast<int>(view.menu.size());
    const Grid grid = lay_out_grid(count, m, layout);

    // Rows stay where they are as long as the chosen card is in sight: nothing moves under a mouse.
    const int chosen = std::clamp(view.menu_selected, 0, count - 1);
    const int chosen_row = chosen / layout.columns;
    layout.first_row =
        std::clamp(std::clamp(view.menu_first_row, chosen_row - layout.rows + 1, chosen_row), 0,
                   layout.all_rows - layout.rows);
    const int first = layout.first_row * layout.columns;
    for (int i = first; i < std::min(count, first + layout.rows * layout.columns); ++i) {
        layout.cards.push_back(lay_out_card(i, i == chosen, grid, m, layout));
    }
    lay_out_signs(grid, m, layout);
    return layout;
}

MenuLayout lay_out_menu(const View& view, const Measure& m, const std::vector<Box>& panels) {
    // Panels in the upper half push the cards down, those in the lower half push them up.
    const float headline = view.title.empty() ? 0.0F : m.px(kHeadlineRoom);
    float top = m.px(0.4F * kCardGap) + headline;
    bool covered = false;
    float bottom = m.height_px - m.px(kCardGap);
    for (const Box& panel : panels) {
        if (panel.middle_y() < 0.5F * m.height_px) {
            top = std::max(top, panel.bottom() + m.px(kChosenFrame));
            covered = true;
        } else {
            bottom = std::min(bottom, panel.y - m.px(kCardGap));
        }
    }
    MenuLayout layout = lay_out_menu(view, m, top, bottom);
    layout.headline = headline > 0.0F && !covered;
    return layout;
}

MenuSpot menu_spot_at(const MenuLayout& layout, double x_px, double y_px) {
    const auto holds = [&](const Box& box) { return box.holds(x_px, y_px); };
    for (const MenuCard& card : layout.cards) {
        if (holds(card.paper)) {
            return {MenuPlace::card, card.index};
        }
    }
    if (holds(layout.earlier)) {
        return {MenuPlace::earlier, 0};
    }
    return {holds(layout.later) ? MenuPlace::later : MenuPlace::nothing, 0};
}

void draw_menu_papers(const MenuLayout& layout, const Measure& m, DrawList& list) {
    const auto draw_icon_ground = [&](const MenuCard& card) {
        list.fill_disc({card.icon.middle_x(), card.icon.middle_y()},
                       0.5F * std::min(card.icon.width, card.icon.height), theme::kIconPaper);
    };
    for (const MenuCard& card : layout.cards) {
        if (!card.chosen) {
            draw_paper(list, card.paper, m, theme::kPaper);
            draw_icon_ground(card);
            continue;
        }
        // The chosen card is larger, has a thick frame, and a tick later on.
        draw_paper(list, card.paper, m, theme::kSelectedPaper);
        list.frame_box(card.paper, m.px(kCardRadius), m.px(kChosenFrame), theme::kBlue);
        draw_icon_ground(card);
    }
}

void draw_menu_words(const View& view, const MenuLayout& layout, const Measure& m, DrawList& list) {
    if (layout.headline) {
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
        for (int i = 0; item.stars >= 0 && i < kMostStars; ++i) {
            draw_star_icon(
                list,
                {card.box.x + m.px(kPad + kCardStar * (1.0F + 2.2F * static_cast<float>(i))),
                 card.box.y + m.px(kPad + kCardStar)},
                m.px(kCardStar), i < item.stars);
        }
        if (card.chosen) {
            draw_tick_icon(list, {card.box.right() - m.px(2.0F), card.box.y + m.px(2.0F)},
                           m.px(kTick));
        }
    }
    for (const auto& [sign, up] : {std::pair{layout.earlier, true}, {layout.later, false}}) {
        if (sign.width > 0.0F) {
            const Point2 middle{sign.middle_x(), sign.middle_y()};
            list.fill_disc(middle, m.px(kSign), theme::kPaper);
            draw_more_icon(list, middle, m.px(kSignArrow), up);
        }
    }
}

}  // namespace fulcrum::runtime
