// Cards in a window, of which one is picked: arrow keys and return, or the mouse.
//
//   The card under the mouse is the chosen one; a click on it starts it, a click beside the cards does nothing. The wheel,
//   and the signs above and below the cards, bring other rows into sight.
#pragma once

#include "runtime/app/desktop.h"
#include "runtime/app/typing.h"

#include <functional>

namespace fulcrum::runtime {

/// Which card is chosen, and which row of cards is seen first.
struct MenuChoice {
    int selected = 0;
    int first_row = 0;
};

/// What was asked of the cards since the last frame; places in pixels from the picture's upper left corner.
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
    bool back = false;   ///< a step, by a key
    bool close = false;  ///< the window
};

/// What follows from it.
struct MenuAnswer {
    MenuChoice choice;
    bool start = false;  ///< the chosen card
};

/// What the window's events ask of the cards. `wheel` keeps what is left of a turn of the wheel until it makes a row;
/// `name` takes what is typed: who is playing.
[[nodiscard]] MenuInput read_menu_input(const WindowEvents& events, double& wheel, TypedLine& name);

/// Changes the choice as asked. `layout` is what was seen when it was asked, of `n_cards` cards.
[[nodiscard]] MenuAnswer answer_menu(const MenuInput& input, const MenuLayout& layout, int n_cards,
                                     const MenuChoice& before);

/// How a picture with cards was left.
enum class PickEnd : std::uint8_t { picked, back, closed, settings };

/// Shows cards until one is picked, which then is the chosen one, or the picture is left.
class CardPicker {
  public:
    explicit CardPicker(Desktop& desktop) : desktop_(desktop) {}

    /// `view` makes the picture of a choice; `name` takes what is typed, and `typed` is told of it.
    [[nodiscard]] PickEnd pick(const std::function<View(const MenuChoice&)>& view,
                               MenuChoice& choice, TypedLine& name,
                               const std::function<void()>& typed);
    /// The same where nothing is typed.
    [[nodiscard]] PickEnd pick(const std::function<View(const MenuChoice&)>& view,
                               MenuChoice& choice);
    /// Shows a picture for so long, whatever is clicked and typed meanwhile; false when the window was closed.
    [[nodiscard]] bool rest(const View& view, double time_s);

  private:
    void let_sound_go_on();

    Desktop& desktop_;
    double now_s_ = 0.0;
};

}  // namespace fulcrum::runtime
