#include "runtime/app/card_picker.h"

#include "haptics/base/clock.h"
#include "runtime/app/interrupt.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr double kLongestWait_s = 1.0 / 60.0;  // the sound goes on while nothing else happens

// Brings other rows into sight; the chosen card changes with them and keeps its place on the screen.
void scroll(int rows, const MenuLayout& layout, int last, MenuChoice& choice) {
    const int before = choice.first_row;
    choice.first_row = std::clamp(before + rows, 0, layout.all_rows - layout.rows);
    choice.selected =
        std::clamp(choice.selected + (choice.first_row - before) * layout.columns, 0, last);
}

void mind_fullscreen(const WindowEvents& events, Window& window) {
    for (const KeyPress& press : events.pressed) {
        if (press.key == "f11") {
            window.set_fullscreen(!window.fullscreen());
        }
    }
}

// By its button or its key, where the picture has them.
bool wants_settings(const WindowEvents& events, const View& seen, const PictureThread& picture) {
    if (std::ranges::count(seen.buttons, ScreenButton::settings) == 0) {
        return false;
    }
    const auto spot = events.button_press[0] ? picture.spot_at(events.press_x_px, events.press_y_px)
                                             : std::nullopt;
    return (spot && spot->button == ScreenButton::settings) ||
           std::ranges::any_of(events.pressed,
                               [](const KeyPress& press) { return press.key == "f4"; });
}

}  // namespace

MenuInput read_menu_input(const WindowEvents& events, double& wheel, TypedLine& name) {
    MenuInput input;
    input.close = events.close;
    for (const KeyPress& press : events.pressed) {
        // A blank belongs to a name that has begun, and starts the lesson before.
        const bool named = !name.text().empty();
        if (press.key == "backspace" && named) {
            name.backspace();
            input.typed = true;
        } else if (!press.text.empty() && (named || press.text != " ")) {
            name.add(press.text);
            input.typed = true;
        }
        input.back |= press.key == "escape";
        input.start |= press.key == "return" || (press.key == "space" && !named);
        input.across += press.key == "right" ? 1 : press.key == "left" ? -1 : 0;
        input.down += press.key == "down" ? 1 : press.key == "up" ? -1 : 0;
    }
    // Away from the user is up.
    wheel -= events.wheel;
    input.scroll = static_cast<int>(wheel);
    wheel -= input.scroll;
    input.pointed = events.pointer_moved;
    input.pointer_x_px = events.pointer_x_px;
    input.pointer_y_px = events.pointer_y_px;
    input.clicked = events.button_press[0];
    input.click_x_px = events.press_x_px;
    input.click_y_px = events.press_y_px;
    return input;
}

MenuAnswer answer_menu(const MenuInput& input, const MenuLayout& layout, int n_cards,
                       const MenuChoice& before) {
    MenuAnswer answer;
    if (n_cards <= 0 || layout.columns <= 0) {
        return answer;
    }
    const int last = n_cards - 1;
    MenuChoice& choice = answer.choice;
    choice = {std::clamp(before.selected, 0, last), layout.first_row};

    // The mouse, over what was seen.
    if (input.pointed) {
        const MenuSpot spot = menu_spot_at(layout, input.pointer_x_px, input.pointer_y_px);
        if (spot.place == MenuPlace::card) {
            choice.selected = static_cast<int>(spot.index);
        }
    }
    if (input.clicked) {
        const MenuSpot spot = menu_spot_at(layout, input.click_x_px, input.click_y_px);
        if (spot.place == MenuPlace::card) {
            choice.selected = static_cast<int>(spot.index);
            answer.start = true;
            return answer;
        }
        scroll(spot.place == MenuPlace::later     ? 1
               : spot.place == MenuPlace::earlier ? -1
                                                  : 0,
               layout, last, choice);
    }
    scroll(input.scroll, layout, last, choice);

    // The keys: a step down ends on the last card when the row below is shorter, and stays in the last row.
    const int last_row = last / layout.columns;
    const int row = choice.selected / layout.columns;
    const int rows = std::clamp(row + input.down, 0, last_row) - row;
    choice.selected =
        std::clamp(std::min(choice.selected + rows * layout.columns, last) + input.across, 0, last);
    answer.start = input.start;
    return answer;
}

void CardPicker::let_sound_go_on() {
    const double before_s = std::exchange(now_s_, monotonic_now_s());
    desktop_.go_on_sounding(now_s_ - before_s);
}

PickEnd CardPicker::pick(const std::function<View(const MenuChoice&)>& view, MenuChoice& choice,
                         TypedLine& name, const std::function<void()>& typed) {
    double wheel = 0.0;
    now_s_ = monotonic_now_s();
    bool stale = true;
    while (true) {
        const View seen = view(choice);
        if (stale) {
            desktop_.picture->show(seen);
        }
        const WindowEvents& events = desktop_.window->wait(kLongestWait_s);
        const MenuInput input = read_menu_input(events, wheel, name);
        if (input.close || interrupted()) {
            return PickEnd::closed;
        }
        if (input.back) {
            return PickEnd::back;
        }
        if (wants_settings(events, seen, *desktop_.picture)) {
            return PickEnd::settings;
        }
        mind_fullscreen(events, *desktop_.window);
        if (input.typed) {
            typed();
        }
        const MenuAnswer answer = answer_menu(input, desktop_.picture->menu_layout(seen),
                                              static_cast<int>(seen.menu.size()), choice);
        if (answer.start) {
            desktop_.play({"click"});
            choice = answer.choice;
            return PickEnd::picked;
        }
        // Nothing moves by itself, so that only a change needs a new picture.
        const bool moved = answer.choice.selected != choice.selected;
        if (moved && (input.across != 0 || input.down != 0)) {
            desktop_.play({"click"});
        }
        stale = moved || input.typed || answer.choice.first_row != choice.first_row ||
                events.resized || events.uncovered;
        choice = answer.choice;
        desktop_.read_aloud(seen.menu[static_cast<std::size_t>(choice.selected)]);
        let_sound_go_on();
    }
}

PickEnd CardPicker::pick(const std::function<View(const MenuChoice&)>& view, MenuChoice& choice) {
    TypedLine nothing(0);
    return pick(view, choice, nothing, [] {});
}

bool CardPicker::rest(const View& view, double time_s) {
    now_s_ = monotonic_now_s();
    const double until_s = now_s_ + time_s;
    bool stale = true;
    while (now_s_ < until_s) {
        if (stale) {
            desktop_.picture->show(view);
        }
        const WindowEvents& events = desktop_.window->wait(kLongestWait_s);
        if (events.close || interrupted()) {
            return false;
        }
        stale = events.resized || events.uncovered;
        let_sound_go_on();
    }
    return true;
}

}  // namespace fulcrum::runtime
