// The list of lessons: large cards with a model, a title and a second line; one is chosen.
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
    Box icon;               ///< where the model is drawn
    std::size_t index = 0;  ///< in View::menu
    bool chosen = false;
};

/// Cards in rows; when not all fit, the rows around the chosen card are in sight.
struct MenuLayout {
    std::vector<MenuCard> cards;
    bool more_above = false;
    bool more_below = false;
    float top_px = 0.0F;     ///< of the room for cards
    float bottom_px = 0.0F;  ///< of the room for cards
};

/// Lays the cards between two heights of the picture, pixels from the top.
[[nodiscard]] MenuLayout lay_out_menu(const View& view, const Measure& measure, float top_px,
                                      float bottom_px);

/// The heights between which cards may lie when panels are shown at these boxes.
[[nodiscard]] MenuLayout lay_out_menu(const View& view, const Measure& measure,
                                      const std::vector<Box>& panels);

/// The cards' papers, on which the models are drawn.
void draw_menu_papers(const MenuLayout& layout, const Measure& measure, DrawList& list);
/// The words on the cards, the headline, and the sign of the chosen card.
void draw_menu_words(const View& view, const MenuLayout& layout, const Measure& measure,
                     DrawList& list);

}  // namespace fulcrum::runtime
