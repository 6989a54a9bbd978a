#include "runtime/app/menu_screen.h"

#include "runtime/app/interrupt.h"
#include "runtime/lua/lesson_process.h"

#include <algorithm>

#include <cmath>
#include <utility>

namespace fulcrum::runtime {
namespace {

// What the learner will hold, else the first thing there is.
std::string icon_of(const LessonDescription& lesson) {
    const auto movable = std::find_if(lesson.bodies.begin(), lesson.bodies.end(),
                                      [](const BodyDescription& body) { return body.movable; });
    if (movable != lesson.bodies.end()) {
        return movable->model;
    }
    return lesson.bodies.empty() ? "" : lesson.bodies.front().model;
}

// What the keyboard asked of the list since the last frame.
struct MenuKeys {
    int move = 0;  // cards onwards
    bool chosen = false;
    bool leave = false;
};

MenuKeys read_keys(Desktop& desktop) {
    const WindowEvents& events = desktop.window->poll();
    MenuKeys keys;
    keys.leave = events.close || interrupted();
    for (const KeyPress& press : events.pressed) {
        keys.leave |= press.key == "escape";
        keys.chosen |= press.key == "return" || press.key == "space";
        keys.move += press.key == "down" || press.key == "right" ? 1 : 0;
        keys.move -= press.key == "up" || press.key == "left" ? 1 : 0;
        if (press.key == "f11") {
            desktop.window->set_fullscreen(!desktop.window->fullscreen());
        }
    }
    keys.chosen |= events.button_press[0];
    return keys;
}

}  // namespace

std::vector<LessonCard> read_lesson_cards(const Places& places) {
    std::vector<LessonCard> cards;
    for (const std::string& name : list_lesson_names(places)) {
        LessonCard card;
        card.name = name;
        card.folder = places.scenarios / name;
        LessonFiles files;
        files.folder = card.folder;
        files.library = places.scripts_lib;
        if (const auto process = LessonProcess::start(files); process) {
            const LessonDescription& lesson = (*process)->description();
            card.title = lesson.title;
            card.level = lesson.level;
            card.minutes = lesson.minutes;
            card.icon = icon_of(lesson);
        } else {
            card.title = name;
            card.error = to_sentence(process.error());
        }
        cards.push_back(std::move(card));
    }
    return cards;
}

View menu_view(const std::vector<LessonCard>& cards, int selected,
               const dialogue::Catalogue& catalogue) {
    View view;
    view.tool_visible = false;
    view.title = catalogue.say("menu.title");
    view.caption = catalogue.say(cards.empty() ? "menu.no_lessons" : "menu.choose");
    for (const LessonCard& card : cards) {
        ViewMenuItem item;
        item.title = card.title;
        item.icon = card.icon;
        item.subtitle =
            card.error.empty()
                ? card.level + " · " +
                      catalogue.say("menu.minutes",
                                    {{"minutes", std::to_string(std::lround(card.minutes))}})
                : card.error;
        view.menu.push_back(std::move(item));
    }
    view.menu_selected = selected;
    if (selected >= 0 && static_cast<std::size_t>(selected) < cards.size() &&
        !cards[static_cast<std::size_t>(selected)].error.empty()) {
        view.banner = cards[static_cast<std::size_t>(selected)].error;
        view.banner_is_error = true;
    }
    return view;
}

std::optional<LessonCard> choose_lesson(Desktop& desktop, const std::vector<LessonCard>& cards,
                                        const dialogue::Catalogue& catalogue) {
    int selected = 0;
    const int last = std::max(static_cast<int>(cards.size()) - 1, 0);
    while (true) {
        const MenuKeys keys = read_keys(desktop);
        if (keys.leave) {
            return std::nullopt;
        }
        const int before = std::exchange(selected, std::clamp(selected + keys.move, 0, last));
        if (selected != before) {
            desktop.play({"click"});
        }
        if (keys.chosen && !cards.empty()) {
            return cards[static_cast<std::size_t>(selected)];
        }
        desktop.draw(menu_view(cards, selected, catalogue));
        desktop.window->swap();
        if (desktop.sound) {
            desktop.sound->update(1.0 / 60.0);
        }
    }
}

}  // namespace fulcrum::runtime
