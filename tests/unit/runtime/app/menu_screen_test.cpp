#include "runtime/app/menu_screen.h"

#include <catch2/catch.hpp>

using namespace fulcrum::runtime;

namespace {

fulcrum::dialogue::Catalogue words() {
    return fulcrum::dialogue::Catalogue::parse(
               "menu.title = Fulcrum\nmenu.choose = Choose a lesson.\n"
               "menu.no_lessons = There are no lessons yet.\n"
               "menu.minutes = {minutes} minutes\n")
        .value();
}

LessonCard card(const std::string& title, const std::string& error = {}) {
    LessonCard made;
    made.title = title;
    made.level = "A1";
    made.minutes = 10.4;
    made.icon = "apple";
    made.error = error;
    return made;
}

}  // namespace

TEST_CASE("menu: each lesson is a card with title, level and minutes") {
    const View view = menu_view({card("Weights"), card("Textures")}, 1, words());
    REQUIRE(view.menu.size() == 2);
    CHECK(view.menu[0].title == "Weights");
    CHECK(view.menu[0].subtitle == "A1 · 10 minutes");
    CHECK(view.menu[0].icon == "apple");
    CHECK(view.menu_selected == 1);
    CHECK(view.caption == "Choose a lesson.");
    CHECK(view.banner.empty());
}

TEST_CASE("menu: a lesson that cannot be loaded says why when it is chosen") {
    const std::vector<LessonCard> cards{card("Weights"),
                                        card("broken", "lesson.lua:3: unexpected symbol.")};
    CHECK(menu_view(cards, 0, words()).banner.empty());
    CHECK(menu_view(cards, 1, words()).banner == "lesson.lua:3: unexpected symbol.");
    CHECK(menu_view(cards, 1, words()).banner_is_error);
}

TEST_CASE("menu: without lessons it says so") {
    CHECK(menu_view({}, 0, words()).caption == "There are no lessons yet.");
}
