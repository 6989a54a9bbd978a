#include "runtime/render/overlay/find_measure.h"

#include "runtime/render/overlay/icons.h"
#include "runtime/render/overlay/menu.h"
#include "runtime/render/overlay/panels.h"
#include "runtime/render/overlay/paper.h"
#include "tests/unit/runtime/render/overlay/overlay_fixture.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr double kSteps[] = {1.0, 1.2, 1.4};  // of ScreenSettings

// All that can stand on a picture, panel by panel, and what a lesson shows at once.
std::vector<std::pair<const char*, View>> all_pages() {
    std::vector<std::pair<const char*, View>> pages;
    View play = busy();
    play.buttons.push_back(ScreenButton::settings);
    play.microphone.visible = true;
    pages.emplace_back("a busy lesson", play);
    View asked = play;
    asked.banner.clear();
    asked.caption = "Which one is the heaviest?";
    asked.input.clear();
    asked.microphone.words = "Choose with the up and down arrows. Then press Enter.";
    asked.choices = {{"the watermelon is the heaviest", "apple"},
                     {"the apple is the heaviest", {}},
                     {"the banana is the heaviest", {}}};
    pages.emplace_back("choices", asked);
    View why = busy();
    why.feedback.clear();
    why.why = {true,
               "Why do I feel this?",
               {{"the weight", "2.8 N down", 1.0, false}, {"its drag", "0.4 N up", 0.2, true}}};
    pages.emplace_back("why", why);
    View end = play;
    end.banner.clear();
    end.input_visible = false;
    end.feedback.clear();
    end.caption = "You have found the heaviest and the lightest.";
    end.stars = 2;
    end.end_note =
        "Your best so far! You answered 3 of 5 questions at the first try. 2 things to practise: "
        "the heaviest, the lightest.";
    end.choices = {
        {"Play again", {}}, {"Next: What is it made of?", {}}, {"Back to the lessons", {}}};
    pages.emplace_back("the end", end);
    View list;
    list.title = "Fulcrum";
    list.caption = "Who are you? Type your name, then choose a lesson.";
    list.input_visible = true;
    list.buttons = {ScreenButton::settings};
    for (int i = 0; i < 17; ++i) {
        list.menu.push_back({"Which of the fruits is the heaviest?", "A1 · 10 minutes", "apple"});
    }
    pages.emplace_back("the list", list);
    View pupils = list;
    pupils.menu_is_small = true;
    pages.emplace_back("a class", pupils);
    View settings;
    settings.title = "Settings";
    for (const SettingRow& row : kScreenSettings) {
        ViewMenuItem item;
        item.title = "Contrast";
        item.subtitle = "very large";
        item.setting = {row.kind, 0};
        settings.menu.push_back(item);
    }
    settings.menu.push_back({"Back", {}, {}, -1, {}, true});
    pages.emplace_back("the settings", settings);
    return pages;
}

std::vector<OverlayCorner> sign_of(const ViewSetting& setting) {
    Font font = andika();
    DrawList list(font);
    draw_setting_icon(list, {100.0F, 100.0F}, 50.0F, setting);
    return list.corners();
}

}  // namespace

TEST_CASE("text size: whatever is shown lies in the picture, and nothing over anything") {
    Font font = andika();
    for (const auto& [width, height] : {std::pair{1280, 720}, {1920, 1080}, {1024, 768}}) {
        for (const double step : kSteps) {
            for (auto [name, view] : all_pages()) {
                INFO(name << " at " << step);
                view.look.text_scale = step;
                const Measure measure = find_measure(view, font, width, height);
                const PanelLayout panels = lay_out_panels(view, font, measure);
                std::vector<runtime::Box> boxes = panels.shown();
                const MenuLayout menu = lay_out_menu(view, measure, panels.papers());
                for (const runtime::Box& card : boxes_of(menu.cards, &MenuCard::box)) {
                    boxes.push_back(card);
                }
                check_apart(boxes, measure);
                // Never smaller than usual, nor larger than wanted.
                CHECK(measure.scale >= Measure(width, height).scale);
                CHECK(measure.scale <= Approx(Measure(width, height, step).scale));
            }
        }
    }
}

TEST_CASE("text size: what has room is as large as wanted, and only what has none is smaller") {
    Font font = andika();
    const auto scale_of = [&](View view, double step) {
        view.look.text_scale = step;
        return find_measure(view, font, 1280, 720).scale;
    };
    for (const auto& [name, view] : all_pages()) {
        INFO(name);
        CHECK(scale_of(view, 1.0) == 1.0F);
        const bool is_full = std::string(name) == "a busy lesson" ||
                             std::string(name) == "choices" || std::string(name) == "the end";
        CHECK(scale_of(view, 1.4) > 1.0F);
        CHECK((is_full || scale_of(view, 1.4) == Approx(1.4F)));
    }
    View crowded = busy();
    crowded.caption = std::string(30, 'w') + " " + crowded.caption + " " + crowded.caption;
    for (int i = 0; i < 6; ++i) {
        crowded.choices.push_back({"the watermelon is the heaviest of all the fruits", {}});
    }
    CHECK(scale_of(crowded, 1.4) < 1.4F);
}

TEST_CASE("text size: all settings are in sight with words of any size") {
    Font font = andika();
    View view = all_pages().back().second;
    for (const double step : kSteps) {
        view.look.text_scale = step;
        const Measure measure = find_measure(view, font, 1280, 720);
        CHECK(measure.scale == Approx(step));
        const MenuLayout layout =
            lay_out_menu(view, measure, lay_out_panels(view, font, measure).papers());
        CHECK(layout.cards.size() == kScreenSettings.size() + 1);
        for (const MenuCard& card : layout.cards) {
            CHECK(card.icon.height >= 40.0F);
        }
    }
}

TEST_CASE("settings: each step of each has a sign of its own") {
    std::vector<std::vector<OverlayCorner>> signs;
    for (const SettingRow& row : kScreenSettings) {
        for (int step = 0; step < row.n_steps; ++step) {
            signs.push_back(sign_of({row.kind, step}));
        }
    }
    for (std::size_t i = 0; i < signs.size(); ++i) {
        CHECK_FALSE(signs[i].empty());
        for (std::size_t j = 0; j < i; ++j) {
            CHECK_FALSE(std::ranges::equal(signs[i], signs[j], [](const auto& a, const auto& b) {
                return a.x == b.x && a.y == b.y && a.rgba == b.rgba;
            }));
        }
    }
}

TEST_CASE("contrast: a paper has an edge where that is wanted, and no other") {
    Font font = andika();
    const Measure measure(1280, 720);
    const auto n_of_ink = [&](const theme::Palette& palette) {
        DrawList list(font);
        list.colour_by(palette);
        draw_paper(list, {100.0F, 100.0F, 300.0F, 80.0F}, measure, palette.paper);
        return std::ranges::count_if(list.corners(), [](const OverlayCorner& corner) {
            return corner.rgba == std::array<std::uint8_t, 4>{0, 0, 0, 255};
        });
    };
    CHECK(n_of_ink(theme::kUsual) == 0);
    CHECK(n_of_ink(theme::kHighContrast) > 0);
}
