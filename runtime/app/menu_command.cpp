// fulcrum room and fulcrum menu: one lesson after the other, from the science room or from the list.
//
//   [who are you?] -> room -> a lesson -> room
//                       door -> list -> a lesson -> room
// Where there is no room, or the list was asked for, that takes its place.
#include "runtime/app/commands.h"
#include "runtime/app/desktop.h"
#include "runtime/app/interrupt.h"
#include "runtime/app/lesson_screen.h"
#include "runtime/app/menu_screen.h"
#include "runtime/app/open_store.h"
#include "runtime/app/run_request.h"
#include "runtime/app/stop_signal.h"
#include "runtime/app/who_screen.h"
#include "runtime/lesson/learner_settings.h"
#include "runtime/progress/guest_name.h"

#include <algorithm>
#include <cstdio>

namespace fulcrum::runtime {
namespace {

constexpr int kOtherPlayer = -1;

class Sitting {
  public:
    Sitting(const Installation& installation, const Options& options, Desktop& desktop,
            ProgressStore& store)
        : installation_(installation),
          options_(options),
          desktop_(desktop),
          store_(store),
          lessons_(read_lesson_cards(installation.places)) {
        const auto room = std::ranges::find_if(lessons_, &LessonCard::is_room);
        if (room != lessons_.end() && options.command != Command::menu) {
            room_ = room->name;
        }
        std::erase_if(lessons_, &LessonCard::is_room);
    }

    /// Until the window is closed, or somebody else wants to play.
    int play(MenuPlayer player) {
        player_ = std::move(player);
        while (true) {
            Played next = find_next();
            // Where none was picked, back into the room.
            while (!next.code && next.entered && !next.entered->empty()) {
                next = play_lesson(*next.entered);
            }
            if (next.code) {
                return *next.code;
            }
        }
    }

  private:
    struct Played {
        std::optional<int> code{};             // the program ends with it
        std::optional<std::string> entered{};  // LessonScreen::entered
    };
    // From the room or, through its door or without one, from the list.
    Played find_next() {
        if (room_.empty()) {
            return choose();
        }
        const Played room = play_lesson(room_);
        if (!room.code && !room.entered) {
            return {player_.is_found ? kOtherPlayer : interrupt_exit_code()};
        }
        return room.code || !room.entered->empty() ? room : choose();
    }
    Played choose() {
        const LessonPick pick =
            choose_lesson(desktop_, lessons_, desktop_.words->shown(), store_, player_);
        if (pick.end == PickEnd::closed) {
            return {interrupt_exit_code()};
        }
        if (pick.end == PickEnd::back && room_.empty()) {
            return {kOtherPlayer};
        }
        return {{}, pick.card.name};
    }
    Played play_lesson(const std::string& name) {
        Options chosen = options_;
        chosen.lesson = name;
        chosen.learner = player_.learner;
        if (desktop_.may_set(SettingKind::hand) && desktop_.settings.left_handed()) {
            chosen.fit.left_handed = true;
        }
        auto request = make_request(installation_.places, chosen, true);
        if (!request) {
            return {complain(request.error(), 2)};
        }
        request->guest = player_.guest;
        request->lessons = list_known_lessons(lessons_, read_best_stars(store_, request->player()));
        LessonScreen screen(installation_.places, desktop_, store_, std::move(*request), chosen);
        if (screen.play() == Left::closed) {
            return {interrupt_exit_code()};
        }
        return {{}, screen.entered()};
    }

    const Installation& installation_;
    const Options& options_;
    Desktop& desktop_;
    ProgressStore& store_;
    std::vector<LessonCard> lessons_;  // without rooms
    std::string room_;                 // empty: none, or not wanted
    MenuPlayer player_;
};

}  // namespace

int menu_command(const Installation& installation, const Options& options) {
    watch_for_stop_signal();
    if (!display_available()) {
        std::fprintf(stderr,
                     "There is no display; here are the lessons, play one with: fulcrum run LESSON "
                     "--headless\n");
        return list_command(installation);
    }
    auto desktop = Desktop::open(installation, options);
    if (!desktop) {
        return complain(desktop.error(), 2);
    }
    const auto store = open_store_beside_window(options.database);
    WhoScreen who(*desktop, desktop->words->shown(), *store, options.class_name);
    if (auto read = who.read(); !read) {
        const int code = complain(read.error(), 2);
        if (!options.class_name.empty()) {
            return code;
        }
    }
    Sitting sitting(installation, options, *desktop, *store);
    const bool asks = who.has_class() && options.learner.empty();
    do {
        MenuPlayer player{options.learner, new_guest_name(),
                          who.has_class() || !options.learner.empty()};
        if (asks) {
            desktop->use(desktop->usual);
            const auto found = who.ask();
            if (!found) {
                break;
            }
            player.learner = *found;
        }
        desktop->use(
            read_settings(*store, player.learner, desktop->usual).value_or(desktop->usual));
        if (const int code = sitting.play(std::move(player)); code != kOtherPlayer) {
            return code;
        }
        (void)who.read();  // what cannot be read any more stays as it was
    } while (asks);
    return interrupt_exit_code();
}

}  // namespace fulcrum::runtime
