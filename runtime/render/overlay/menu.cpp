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
constexpr float kHeadlineRoom = 74.0F;

/// How large cards are, at 720.
struct CardSizes {
    float gap;
    float tallest;
    float least_height;
    float widest;
    float least_width;
    float narrowest;  // where not all would be in sight otherwise
    float pad;
    float title;  // size of its words
    int title_lines;
    float subtitle;  // likewise; 0: there is none
};
constexpr CardSizes kLessonSizes{.gap = 20.0F,
                                 .tallest = 430.0F,
                                 .least_height = 200.0F,
                                 .widest = 360.0F,
                                 .least_width = 250.0F,
                                 .narrowest = 250.0F,
                                 .pad = 18.0F,
                                 .title = kBodyText,
                                 .title_lines = 2,
                                 .subtitle = kSmallText};
constexpr CardSizes kSmallSizes{.gap = 12.0F,
                                .tallest = 220.0F,
                                .least_height = 104.0F,
                                .widest = 230.0F,
                                .least_width = 140.0F,
                                .narrowest = 128.0F,
                                .pad = 8.0F,
                                .title = kSmallText,
                                .title_lines = 1,
                                .subtitle = 0.0F};

// All of them on one picture, whatever size words have.
constexpr CardSizes kSettingSizes{.gap = 20.0F,
                                  .tallest = 300.0F,
                                  .least_height = 160.0F,
                                  .widest = 290.0F,
                                  .least_width = 180.0F,
                                  .narrowest = 180.0F,
                                  .pad = 14.0F,
                                  .title = kBodyText,
                                  .title_lines = 1,
                                  .subtitle = kSmallText};

const CardSizes& sizes_of(const View& view) {
    return view.menu_is_small                                            ? kSmallSizes
           : !view.menu.empty() && view.menu.front().setting.has_value() ? kSettingSizes
                                                                         : kLessonSizes;
}

constexpr int kLinesAlone = 2;  // of a card's title without a picture
constexpr float kChosenFrame = 8.0F;
constexpr float kCardRadius = 22.0F;
constexpr float kTick = 24.0F;
constexpr float kCardStar = 12.0F;   // radius
constexpr float kSign = 20.0F;       // radius of the sign that there are more rows
constexpr float kSignArrow = 11.0F;  // of the arrow on it

int fitting(float room, float least, float gap) {
    return std::max(static_cast<int>((room + gap) / (least + gap)), 1);
}

/// The height that a card's words take: the lines of its title, one of subtitle.
float words_height(const CardSizes& sizes, const Measure& m) {
    return m.px(1.3F * (static_cast<float>(sizes.title_lines) * sizes.title + sizes.subtitle));
}

Paragraph card_words(const Font& font, const Measure& m, const std::string& text, float size,
                     Face face, float width, int lines) {
    ParagraphSettings settings;
    settings.size_px = m.text_px(size);
    settings.face = face;
    settings.width_px = width;
    settings.most_lines = lines;
    return set_text(font, plain_text(text), settings);
}

/// A card's size and how many there are.
struct Grid {
    const CardSizes& sizes;
    int count = 0;
    float gap = 0.0F;
    float width = 0.0F;   // of a card
    float height = 0.0F;  // of a card
    float top = 0.0F;     // of the first row in sight
};

/// As few rows as the width allows, and no more than the height allows.
Grid lay_out_grid(const CardSizes& sizes, int count, const Measure& m, MenuLayout& layout) {
    Grid grid{sizes};
    grid.count = count;
    grid.gap = m.px(sizes.gap);
    const float width_room = m.width_px - 2.0F * m.px(kMenuMargin);
    const float height_room = std::max(layout.bottom_px - layout.top_px, m.px(sizes.least_height));
    const int most_rows = fitting(height_room, m.px(sizes.least_height), grid.gap);
    int most_columns = fitting(width_room, m.px(sizes.least_width), grid.gap);
    if (count > most_columns * most_rows) {
        most_columns = fitting(width_room, m.px(sizes.narrowest), grid.gap);
    }
    layout.all_rows = (count + most_columns - 1) / most_columns;
    layout.columns = (count + layout.all_rows - 1) / layout.all_rows;
    layout.rows = std::min(layout.all_rows, most_rows);
    const auto room_each = [&](float room, int n) {
        return (room - grid.gap * static_cast<float>(n - 1)) / static_cast<float>(n);
    };
    grid.width = std::min(room_each(width_room, layout.columns), m.px(sizes.widest));
    grid.height = std::min(room_each(height_room, layout.rows), m.px(sizes.tallest));
    const auto rows = static_cast<float>(layout.rows);
    grid.top = layout.top_px + 0.5F * (height_room - grid.height * rows - grid.gap * (rows - 1.0F));
    return grid;
}

MenuCard lay_out_card(int index, bool chosen, const ViewMenuItem& item, const Grid& grid,
                      const Measure& m, const MenuLayout& layout) {
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
    // Wider by less than the gap: none lies over its neighbour.
    card.paper = chosen ? card.box.grown(std::min(m.px(kChosenFrame), 0.4F * grid.gap)) : card.box;
    const float pad = m.px(grid.sizes.pad);
    card.icon = {card.box.x + pad, card.box.y + pad, grid.width - 2.0F * pad,
                 std::max(grid.height - words_height(grid.sizes, m) - 2.0F * pad, 1.0F)};
    if (item.icon.empty() && !item.leads_back && !item.setting && !item.title.empty()) {
        card.icon = {card.box.x + pad, card.box.y + pad, 0.0F, 0.0F};  // words alone
    } else if (!item.second_icon.empty()) {
        card.icon.width *= 0.5F;
        card.second_icon = card.icon;
        card.second_icon.x = card.icon.right();
    }
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
    const Grid grid = lay_out_grid(sizes_of(view), count, m, layout);

    // Rows stay where they are as long as the chosen card is in sight: nothing moves under a mouse.
    const int chosen = std::clamp(view.menu_selected, 0, count - 1);
    const int chosen_row = chosen / layout.columns;
    layout.first_row =
        std::clamp(std::clamp(view.menu_first_row, chosen_row - layout.rows + 1, chosen_row), 0,
                   layout.all_rows - layout.rows);
    const int first = layout.first_row * layout.columns;
    for (int i = first; i < std::min(count, first + layout.rows * layout.columns); ++i) {
        const ViewMenuItem& item = view.menu[static_cast<std::size_t>(i)];
        layout.cards.push_back(lay_out_card(i, i == chosen, item, grid, m, layout));
    }
    lay_out_signs(grid, m, layout);
    return layout;
}

MenuLayout lay_out_menu(const View& view, const Measure& m, const std::vector<Box>& panels) {
    // Panels in the upper half push the cards down, those in the lower half push them up.
    const float headline = view.title.empty() ? 0.0F : m.px(kHeadlineRoom);
    const float gap = m.px(sizes_of(view).gap);
    float top = 0.4F * gap + headline;
    bool covered = false;
    float bottom = m.height_px - gap;
    for (const Box& panel : panels) {
        if (panel.middle_y() < 0.5F * m.height_px) {
            top = std::max(top, panel.bottom() + m.px(kChosenFrame));
            covered = true;
        } else {
            bottom = std::min(bottom, panel.y - gap);
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
        for (const Box& icon : {card.icon, card.second_icon}) {
            list.fill_disc({icon.middle_x(), icon.middle_y()},
                           0.5F * std::min(icon.width, icon.height), list.colours().icon_paper);
        }
    };
    for (const MenuCard& card : layout.cards) {
        if (!card.chosen) {
            draw_paper(list, card.paper, m, list.colours().paper);
            draw_icon_ground(card);
            continue;
        }
        // The chosen card is larger, has a thick frame, and a tick later on.
        draw_paper(list, card.paper, m, list.colours().selected_paper);
        list.frame_box(card.paper, m.px(kCardRadius), m.px(kChosenFrame), theme::kBlue);
        draw_icon_ground(card);
    }
}

CardWords set_card_words(const View& view, const MenuCard& card, const Font& font,
                         const Measure& m) {
    const CardSizes& sizes = sizes_of(view);
    const ViewMenuItem& item = view.menu[card.index];
    const float width = card.box.width - 2.0F * m.px(sizes.pad);
    CardWords words;
    words.title =
        card.icon.width > 0.0F
            ? card_words(font, m, item.title, sizes.title, Face::bold, width, sizes.title_lines)
            : card_words(font, m, item.title, kBodyText, Face::bold, width, kLinesAlone);
    if (sizes.subtitle > 0.0F) {
        words.subtitle =
            card_words(font, m, item.subtitle, sizes.subtitle, Face::regular, width, 1);
    }
    return words;
}

void draw_menu_words(const View& view, const MenuLayout& layout, const Measure& m, DrawList& list) {
    const CardSizes& sizes = sizes_of(view);
    if (layout.headline) {
        const Paragraph title =
            card_words(list.font(), m, view.title, kHeadline, Face::bold, 0.9F * m.width_px, 1);
        const float top = layout.top_px - m.px(0.5F * kHeadlineRoom) - 0.5F * title.height_px;
        if (list.colours().has_frames) {
            const float width = title.width_px + m.px(2.0F * kCardRadius);
            draw_paper(list, {0.5F * (m.width_px - width), top, width, title.height_px}, m,
                       list.colours().paper);
        }
        list.text(title, 0.0F, top, m.width_px, 0.5F, list.colours().ink, list.colours().ink);
    }
    for (const MenuCard& card : layout.cards) {
        const ViewMenuItem& item = view.menu[card.index];
        const float pad = m.px(sizes.pad);
        const float width = card.box.width - 2.0F * pad;
        const auto [title, subtitle] = set_card_words(view, card, list.font(), m);
        const float x = card.box.x + pad;
        const float room = card.box.bottom() - pad - card.icon.bottom();
        const float top = card.icon.bottom() + 0.5F * (room - title.height_px - subtitle.height_px);
        list.text(title, x, top, width, 0.5F, list.colours().ink, list.colours().ink);
        list.text(subtitle, x, top + title.height_px, width, 0.5F, list.colours().soft_ink,
                  list.colours().ink);
        for (int i = 0; item.stars >= 0 && i < kMostStars; ++i) {
            draw_star_icon(list,
                           {x + m.px(kCardStar * (1.0F + 2.2F * static_cast<float>(i))),
                            card.box.y + pad + m.px(kCardStar)},
                           m.px(kCardStar), i < item.stars);
        }
        if (item.setting) {
            draw_setting_icon(list, {card.icon.middle_x(), card.icon.middle_y()},
                              0.34F * std::min(card.icon.width, card.icon.height), *item.setting);
        }
        if (item.leads_back) {
            draw_arrow_icon(list, {card.icon.middle_x(), card.icon.middle_y()},
                            0.3F * std::min(card.icon.width, card.icon.height), {-1.0F, 0.0F},
                            list.colours().emphasis_ink);
        }
        if (card.chosen) {
            draw_tick_icon(list, {card.box.right() - m.px(2.0F), card.box.y + m.px(2.0F)},
                           m.px(kTick));
        }
    }
    for (const auto& [sign, up] : {std::pair{layout.earlier, true}, {layout.later, false}}) {
        if (sign.width > 0.0F) {
            const Point2 middle{sign.middle_x(), sign.middle_y()};
            list.fill_disc(middle, m.px(kSign), list.colours().paper);
            draw_more_icon(list, middle, m.px(kSignArrow), up);
        }
    }
}

}  // namespace fulcrum::runtime
