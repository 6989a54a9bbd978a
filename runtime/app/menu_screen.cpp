#include "runtime/app/menu_screen.h"

#include "runtime/app/settings_page.h"
#include "runtime/app/who_screen.h"
#include "runtime/lesson/learner_settings.h"
#include "runtime/progress/guest_name.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kLongestName_bytes = 40;

// Each time the list is shown: a lesson may have shown a model of its own under the same name.
void load_icons(Desktop& desktop, const std::vector<LessonCard>& cards) {
    for (const LessonCard& card : cards) {
        desktop.picture->load_models({card.icon}, card.folder);
    }
    desktop.picture->load_models({kGuestPicture}, {});
}

}  // namespace

View menu_view(const std::vector<LessonCard>& cards, const MenuChoice& choice,
               const dialogue::Catalogue& catalogue, const MenuPlayer& player,
               const BestStars& stars, Language language) {
    const std::string& learner = player.learner;
    View view;
    view.tool_visible = false;
    view.buttons = {ScreenButton::settings};
    view.title = catalogue.say("menu.title");
    view.caption = cards.empty()      ? catalogue.say("menu.no_lessons")
                   : !learner.empty() ? catalogue.say("menu.hello", {{"name", learner}})
                   : player.is_found  ? catalogue.say("menu.choose")
                                      : catalogue.say("menu.who");
    view.input_visible = !cards.empty() && !player.is_found;
    view.input = player.is_found ? std::string() : learner;
    for (const LessonCard& card : cards) {
        ViewMenuItem item;
        const auto home_title = card.home_titles.find(language);
        item.title = home_title == card.home_titles.end() ? card.title : home_title->second;
        item.icon = card.icon;
        const long minutes = std::lround(card.minutes);
        item.subtitle = card.error.empty()
                            ? card.level + " · " +
                                  catalogue.say_counted("menu.minutes", minutes,
                                                        {{"minutes", std::to_string(minutes)}})
                            : card.error;
        item.stars = best_in(stars, card.id);
        view.menu.push_back(std::move(item));
    }
    if (!cards.empty()) {
        ViewMenuItem other;
        other.title = catalogue.say(player.is_found ? "menu.back" : "menu.guest");
        other.icon = player.is_found ? "" : kGuestPicture;
        other.leads_back = player.is_found;
        view.menu.push_back(std::move(other));
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

LessonPick choose_lesson(Desktop& desktop, const std::vector<LessonCard>& cards,
                         const dialogue::Catalogue& catalogue, ProgressStore& store,
                         MenuPlayer& player) {
    load_icons(desktop, cards);
    const auto stars_now = [&] {
        return read_best_stars(store, player.learner.empty() ? player.guest : player.learner);
    };
    BestStars stars = stars_now();
    MenuChoice choice;
    TypedLine name(player.is_found ? 0 : kLongestName_bytes, player.learner);
    CardPicker picker(desktop);
    while (true) {
        const PickEnd end = picker.pick(
            [&](const MenuChoice& chosen) {
                return menu_view(cards, chosen, catalogue, player, stars,
                                 desktop.words->language());
            },
            choice, name,
            [&] {
                if (!player.is_found) {
                    player.learner = name.text();
                    stars = stars_now();
                    desktop.use(read_settings(store, player.learner, desktop.usual)
                                    .value_or(desktop.settings));
                }
            });
        const auto picked = static_cast<std::size_t>(choice.selected);
        if (end == PickEnd::settings) {
            if (SettingsPage(desktop, store, catalogue, player.learner).show()) {
                continue;
            }
            return {PickEnd::closed, {}};
        }
        if (end != PickEnd::picked) {
            return {end, {}};
        }
        if (picked < cards.size()) {
            return {end, cards[picked]};
        }
        if (player.is_found) {
            return {PickEnd::back, {}};
        }
        name.clear();
        player = {{}, new_guest_name(), false};
        desktop.use(desktop.usual);
        stars = {};
        choice = {};
    }
}

}  // namespace fulcrum::runtime
