// The list of lessons in a window: arrow keys and return, or the mouse.
//
//   The card under the mouse is the chosen one; a click on it starts it, a click beside the cards does nothing. The wheel,
//   and the signs above and below the cards, bring other rows into sight.
#pragma once

#include "dialogue/catalogue.h"
#include "runtime/app/desktop.h"
#include "runtime/app/places.h"
#include "runtime/app/typing.h"
#include "runtime/progress/store.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fulcrum::runtime {

/// A lesson as the list shows it.
struct LessonCard {
    std::filesystem::path folder;
    std::string name;  ///< of the folder
    std::string id;    ///< as progress is kept
    std::string title;
    std::string level;  ///< CEFR
    double minutes = 0.0;
    std::string icon;   ///< a model
    std::string error;  ///< why it cannot be loaded; empty when it can
    int order = 0;      ///< 0: it says nothing of it
};

/// The most stars that a learner has had, by a lesson's id.
using BestStars = std::map<std::string, std::int32_t>;

/// Which card is chosen, and which row of cards is seen first.
struct MenuChoice {
    int selected = 0;
    int first_row = 0;
};

/// What was asked of the list since the last frame; places in pixels from the picture's upper left corner.
struct MenuInput {
    int across = 0;      ///< cards onwards, by keys
    int down = 0;        ///< rows onwards, by keys
    int scroll = 0;      ///< rows onwards, by the wheel
    bool start = false;  ///< by a key
    bool pointed = false;
    double pointer_x_px = 0.0;
    double pointer_y_px = 0.0;
    bool clicked = false;
    double click_x_px = 0.0;
    double click_y_px = 0.0;
    bool typed = false;  ///< the name has changed
    bool leave = false;
};

/// What follows from it.
struct MenuAnswer {
    MenuChoice choice;
    bool start = false;  ///< the lesson of the chosen card
};

/// What the window's events ask of the list. `wheel` keeps what is left of a turn of the wheel until it makes a row;
/// `name` takes what is typed: who is playing.
[[nodiscard]] MenuInput read_menu_input(const WindowEvents& events, double& wheel, TypedLine& name);

/// Changes the choice as asked. `layout` is what was seen when it was asked, of `n_cards` cards.
[[nodiscard]] MenuAnswer answer_menu(const MenuInput& input, const MenuLayout& layout, int n_cards,
                                     const MenuChoice& before);

/// Of whoever is called so; nothing for nobody, and where it cannot be read.
[[nodiscard]] BestStars read_best_stars(ProgressStore& store, const std::string& learner);

/// Loads every lesson once to see how it calls itself; in their order.
[[nodiscard]] std::vector<LessonCard> read_lesson_cards(const Places& places);
/// As they want to stand; those that say nothing of it as they are, behind the others.
void put_in_order(std::vector<LessonCard>& cards);

/// Shows the list until a lesson is chosen; nothing when the learner leaves. `learner` is who plays, as typed here.
[[nodiscard]] std::optional<LessonCard> choose_lesson(Desktop& desktop,
                                                      const std::vector<LessonCard>& cards,
                                                      const dialogue::Catalogue& catalogue,
                                                      ProgressStore& store, std::string& learner);

/// The list as a picture; for tests and screenshots.
[[nodiscard]] View menu_view(const std::vector<LessonCard>& cards, const MenuChoice& choice,
                             const dialogue::Catalogue& catalogue, const std::string& learner = {},
                             const BestStars& stars = {});

}  // namespace fulcrum::runtime
