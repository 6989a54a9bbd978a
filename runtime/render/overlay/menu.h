// The list of lessons: large cards with a model, a title and a second line; one is chosen. And a class, `View::menu_is_small`: cards with one
// line and up to two models, 37 of them on a picture of 1280 x 720.
//
//   The layout is what is drawn and what is pointed at: `menu_spot_at` looks into the same boxes.
//
// Thread: one (it asks the font). Cost: setting the words of the cards in sight.
#pragma once

#include "runtime/render/overlay/draw_list.h"
#include "runtime/render/overlay/measure.h"
#include "runtime/scene/view.h"

#include <vector>

namespace fulcrum::runtime {

/// A card in sight.
struct MenuCard {
    Box box;
    Box paper;              ///< what is seen of it: the chosen card is larger than its box
    Box icon;               ///< where the model is drawn; no width where words stand alone
    Box second_icon;        ///< where the second is; no width where there is none
    std::size_t index = 0;  ///< in View::menu
    bool chosen = false;
};

/// Cards in rows. When not all fit, the rows from View::menu_first_row are in sight, or as near to
/// them as the chosen card allows, which always is in sight.
struct MenuLayout {
    std::vector<MenuCard> cards;
    int columns = 0;         ///< cards in a full row; 0 without cards
    int rows = 0;            ///< in sight
    int all_rows = 0;        ///< in sight or not
    int first_row = 0;       ///< the first in sight, 0 to all_rows - rows
    Box earlier;             ///< the sign that there are rows above; no width when there are none
    Box later;               ///< the sign that there are rows below; no width when there are none
    float top_px = 0.0F;     ///< of the room for cards
    float bottom_px = 0.0F;  ///< of the room for cards
    bool headline = false;   ///< the view's title stands above the cards
};

/// What lies at a place of the picture.
enum class MenuPlace { nothing, card, earlier, later };

/// A place of the menu, and which card it is.
struct MenuSpot {
    MenuPlace place = MenuPlace::nothing;
    std::size_t index = 0;  ///< in View::menu, of a card
};

/// Lays the cards between two heights of the picture, pixels from the top.
[[nodiscard]] MenuLayout lay_out_menu(const View& view, const Measure& measure, float top_px,
                                      float bottom_px);

/// Lays the cards between the panels that are shown at these boxes. A banner takes the headline's
/// place, so that cards stay where they are when one appears.
[[nodiscard]] MenuLayout lay_out_menu(const View& view, const Measure& measure,
                                      const std::vector<Box>& panels);

/// What stands on a card.
struct CardWords {
    Paragraph title;
    Paragraph subtitle;  ///< without lines where there is none
};
[[nodiscard]] CardWords set_card_words(const View& view, const MenuCard& card, const Font& font,
                                       const Measure& measure);

/// What is seen at a place, pixels from the top left corner of the picture. A box holds its left
/// and upper edge, not its right and lower one; a place that is not finite holds nothing.
[[nodiscard]] MenuSpot menu_spot_at(const MenuLayout& layout, double x_px, double y_px);

/// The cards' papers, on which the models are drawn.
void draw_menu_papers(const MenuLayout& layout, const Measure& measure, DrawList& list);
/// The words on the cards, the headline, and the sign of the chosen card.
void draw_menu_words(const View& view, const MenuLayout& layout, const Measure& measure,
                     DrawList& list);

}  // namespace fulcrum::runtime
