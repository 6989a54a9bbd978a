#include "runtime/app/menu_screen.h"

#include "haptics/base/clock.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/lesson_parts.h"
#include "runtime/app/screen_trouble.h"
#include "runtime/lua/process/lesson_process.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fulcrum::runtime {
namespace {

// What it says, else what the learner will hold, else the first thing there is.
std::string icon_of(const LessonDescription& lesson) {
    if (!lesson.icon.empty()) {
        return lesson.icon;
    }
    const auto movable = std::find_if(lesson.bodies.begin(), lesson.bodies.end(),
                                      [](const BodyDescription& body) { return body.movable; });
    if (movable != lesson.bodies.end()) {
        return movable->model;
    }
    return lesson.bodies.empty() ? "" : lesson.bodies.front().model;
}

constexpr std::size_t kLongestName_bytes = 40;
constexpr double kLongestWait_s = 1.0 / 60.0;  // the sound goes on while nothing else happens

// Brings other rows into sight; the chosen card changes with them and keeps its place on the screen.
void scroll(int rows, const MenuLayout& layout, int last, MenuChoice& choice) {
    const int before = choice.first_row;
    choice.first_row = std::clamp(before + rows, 0, layout.all_rows - layout.rows);
    choice.selected =
        std::clamp(choice.selected + (choice.first_row - before) * layout.columns, 0, last);
}

// Each time the list is shown: a lesson may have shown a model of its own under the same name.
void load_icons(Desktop& desktop, const std::vector<LessonCard>& cards) {
    for (const LessonCard& card : cards) {
        desktop.picture->load_models({card.icon}, card.folder);
    }
}

}  // namespace

MenuInput read_menu_input(const WindowEvents& events, double& wheel, TypedLine& name) {
    MenuInput input;
    input.leave = events.close;
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
        input.leave |= press.key == "escape";
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

std::vector<LessonCard> read_lesson_cards(const Places& places) {
    std::vector<LessonCard> cards;
    for (const std::string& name : list_lesson_names(places)) {
        LessonCard card;
        card.name = name;
        card.folder = find_named_lesson(places, name);
        LessonFiles files;
        files.folder = card.folder;
        files.library = places.scripts_lib;
        LessonProcessOptions process_options;
        process_options.waits_on = patience(kLongestWindowWait_s);
        if (const auto process = LessonProcess::start(files, process_options); process) {
            const LessonDescription& lesson = (*process)->description();
            card.id = lesson.id;
            card.order = lesson.order;
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
    put_in_order(cards);
    return cards;
}

void put_in_order(std::vector<LessonCard>& cards) {
    std::ranges::stable_sort(cards, {}, [](const LessonCard& card) {
        return card.order > 0 ? card.order : std::numeric_limits<int>::max();
    });
}

BestStars read_best_stars(ProgressStore& store, const std::string& learner) {
    BestStars best;
    if (learner.empty()) {
        return best;
    }
    const auto kept = store.read({.nickname = learner, .lesson = {}, .results_only = true});
    if (!kept) {
        return best;
    }
    std::map<RecordId, std::string> lesson_of;
    for (const SessionRecord& session : kept->sessions) {
        lesson_of[session.id] = session.lesson;
    }
    for (const SessionEnd& end : kept->ends) {
        if (end.reason == EndReason::finished) {
            std::int32_t& stars = best[lesson_of[end.session]];
            stars = std::max(stars, end.stars);
        }
    }
    return best;
}

View menu_view(const std::vector<LessonCard>& cards, const MenuChoice& choice,
               const dialogue::Catalogue& catalogue, const std::string& learner,
               const BestStars& stars) {
    View view;
    view.tool_visible = false;
    view.title = catalogue.say("menu.title");
    view.caption = cards.empty()     ? catalogue.say("menu.no_lessons")
                   : learner.empty() ? catalogue.say("menu.who")
                                     : catalogue.say("menu.hello", {{"name", learner}});
    view.input_visible = !cards.empty();
    view.input = learner;
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
        if (const auto best = stars.find(card.id); best != stars.end()) {
            item.stars = best->second;
        }
        view.menu.push_back(std::move(item));
    }
    const int selected = choice.selected;
    view.menu_selected = selected;
    view.menu_first_row = choice.first_row;
    if (selected >= 0 && static_cast<std::size_t>(selected) < cards.size() &&
        !cards[static_cast<std::size_t>(selected)].error.empty()) {
        view.banner = cards[static_cast<std::size_t>(selected)].error;
        view.banner_is_error = true;
    }
    return view;
}

std::optional<LessonCard> choose_lesson(Desktop& desktop, const std::vector<LessonCard>& cards,
                                        const dialogue::Catalogue& catalogue, ProgressStore& store,
                                        std::string& learner) {
    load_icons(desktop, cards);
    BestStars stars = read_best_stars(store, learner);
    MenuChoice choice;
    TypedLine name(kLongestName_bytes, learner);
    double wheel = 0.0;
    double now_s = monotonic_now_s();
    bool stale = true;
    while (true) {
        const View view = menu_view(cards, choice, catalogue, name.text(), stars);
        if (stale) {
            desktop.picture->show(view);
        }
        const WindowEvents& events = desktop.window->wait(kLongestWait_s);
        const MenuInput input = read_menu_input(events, wheel, name);
        if (input.leave || interrupted()) {
            return std::nullopt;
        }
        for (const KeyPress& press : events.pressed) {
            if (press.key == "f11") {
                desktop.window->set_fullscreen(!desktop.window->fullscreen());
            }
        }
        if (input.typed) {
            stars = read_best_stars(store, name.text());
        }
        const MenuAnswer answer = answer_menu(input, desktop.picture->menu_layout(view),
                                              static_cast<int>(cards.size()), choice);
        if (answer.start) {
            desktop.play({"click"});
            learner = name.text();
            return cards[static_cast<std::size_t>(answer.choice.selected)];
        }
        // Nothing moves by itself, so that only a change needs a new picture.
        const bool moved = answer.choice.selected != choice.selected;
        if (moved && (input.across != 0 || input.down != 0)) {
            desktop.play({"click"});
        }
        stale = moved || input.typed || answer.choice.first_row != choice.first_row ||
                events.resized || events.uncovered;
        choice = answer.choice;
        const double before_s = std::exchange(now_s, monotonic_now_s());
        if (desktop.sound) {
            desktop.sound->update(now_s - before_s);
        }
    }
}

}  // namespace fulcrum::runtime
