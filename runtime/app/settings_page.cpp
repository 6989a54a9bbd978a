#include "runtime/app/settings_page.h"

#include "haptics/base/clock.h"
#include "runtime/app/interrupt.h"
#include "runtime/lesson/learner_settings.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace fulcrum::runtime {

View settings_view(const Desktop& desktop, const MenuChoice& choice,
                   const dialogue::Catalogue& catalogue) {
    View view;
    view.tool_visible = false;
    view.title = catalogue.say("settings.title");
    for (const SettingRow& row : kScreenSettings) {
        if (!desktop.may_set(row.kind)) {
            continue;
        }
        const int step = desktop.settings.step(row.kind);
        const std::string key = "settings." + std::string(row.name);
        ViewMenuItem item;
        item.title = catalogue.say(key);
        item.subtitle =
            catalogue.say(key + "." + std::string(row.steps.at(static_cast<std::size_t>(step))));
        item.setting = {row.kind, step};
        view.menu.push_back(std::move(item));
    }
    ViewMenuItem& back = view.menu.emplace_back();
    back.title = catalogue.say("menu.back");
    back.leads_back = true;
    view.menu_selected = choice.selected;
    view.menu_first_row = choice.first_row;
    return view;
}

SettingsPage::SettingsPage(Desktop& desktop, ProgressStore& store,
                           const dialogue::Catalogue& catalogue, std::string learner)
    : desktop_(desktop),
      store_(store),
      catalogue_(catalogue),
      learner_(std::move(learner)),
      before_(desktop.settings) {}

bool SettingsPage::take(const WindowEvents& events) {
    TypedLine nothing(0);
    const MenuInput input = read_menu_input(events, wheel_, nothing);
    const bool leaves =
        input.back || std::ranges::any_of(events.pressed, [](const KeyPress& press) {
            return press.key == "f4" && !press.repeat;
        });
    const View seen = view();
    const MenuAnswer answer = answer_menu(input, desktop_.picture->menu_layout(seen),
                                          static_cast<int>(seen.menu.size()), choice_);
    choice_ = answer.choice;
    const auto setting = seen.menu[static_cast<std::size_t>(choice_.selected)].setting;
    if (answer.start && setting) {
        ScreenSettings chosen = desktop_.settings;
        chosen.go_on(setting->kind);
        desktop_.use(chosen);
        desktop_.play({"click"});
        if (setting->kind == SettingKind::voice) {
            desktop_.say_again({desktop_.words->english().say("settings.voice")});
        }
    }
    if (leaves || (answer.start && !setting)) {
        keep();
        return false;
    }
    desktop_.read_aloud(seen.menu[static_cast<std::size_t>(choice_.selected)]);
    return true;
}

bool SettingsPage::show() {
    constexpr double kLongestWait_s = 1.0 / 60.0;  // the sound goes on while nothing else happens
    double now_s = monotonic_now_s();
    while (true) {
        desktop_.picture->show(view());
        const WindowEvents& events = desktop_.window->wait(kLongestWait_s);
        if (events.close || interrupted()) {
            keep();
            return false;
        }
        if (!take(events)) {
            return true;
        }
        const double before_s = std::exchange(now_s, monotonic_now_s());
        desktop_.go_on_sounding(now_s - before_s);
    }
}

void SettingsPage::keep() {
    if (auto kept = keep_settings(store_, learner_, before_, desktop_.settings); !kept) {
        std::fprintf(stderr, "What was chosen in the settings was not kept: %s\n",
                     to_sentence(kept.error()).c_str());
    }
    before_ = desktop_.settings;
}

}  // namespace fulcrum::runtime
