#include "runtime/app/card_picker.h"
#include "runtime/app/menu_screen.h"
#include "runtime/app/typing.h"
#include "tests/unit/runtime/progress/test_store.h"
#include "tests/unit/runtime/rig.h"

#include <stdexcept>

using namespace fulcrum::runtime::test;

namespace {

fulcrum::dialogue::Catalogue words() {
    return fulcrum::dialogue::Catalogue::parse(
               "menu.title = Fulcrum\nmenu.hello = Hello, {name}!\nmenu.who = Who are you?\n"
               "menu.no_lessons = There are no lessons yet.\nmenu.choose = Choose a lesson.\n"
               "menu.guest = Guest\nmenu.back = Back\n"
               "menu.minutes.other = {minutes} minutes\n")
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

// The list as it is seen in a window of 1280 x 720.
MenuLayout seen(int n_cards, const MenuChoice& choice) {
    const auto count = static_cast<std::size_t>(n_cards);
    View view = menu_view(std::vector<LessonCard>(count, card("Weights")), choice, words());
    view.menu.resize(count);
    return lay_out_menu(view, Measure(1280, 720), std::vector<runtime::Box>{});
}

const MenuCard& card_in(const MenuLayout& layout, int index) {
    for (const MenuCard& card : layout.cards) {
        if (static_cast<int>(card.index) == index) {
            return card;
        }
    }
    throw std::out_of_range("this card is not in sight");
}

MenuInput pointing(const runtime::Box& box) {
    MenuInput input;
    input.pointed = true;
    input.pointer_x_px = static_cast<double>(box.middle_x());
    input.pointer_y_px = static_cast<double>(box.middle_y());
    return input;
}

MenuInput clicking(const runtime::Box& box) {
    MenuInput input = pointing(box);
    input.clicked = true;
    input.click_x_px = input.pointer_x_px;
    input.click_y_px = input.pointer_y_px;
    return input;
}

MenuInput keys(int across, int down) {
    MenuInput input;
    input.across = across;
    input.down = down;
    return input;
}

int selected_after(const MenuInput& input, int n_cards, const MenuChoice& before) {
    return answer_menu(input, seen(n_cards, before), n_cards, before).choice.selected;
}

}  // namespace

TEST_CASE("menu: each lesson is a card with title, level and minutes, and the next guest is one") {
    const View view = menu_view({card("Weights"), card("Textures")}, {1, 0}, words());
    REQUIRE(view.menu.size() == 3);
    CHECK(view.menu[0].title == "Weights");
    CHECK(view.menu[0].subtitle == "A1 · 10 minutes");
    CHECK(view.menu[0].icon == "apple");
    CHECK(view.menu[2].title == "Guest");
    CHECK_FALSE(view.menu[2].leads_back);
    CHECK(view.menu_selected == 1);
    CHECK(view.caption == "Who are you?");
    CHECK(view.banner.empty());
}

TEST_CASE("menu: a lesson that cannot be loaded says why when it is chosen") {
    const std::vector<LessonCard> cards{card("Weights"),
                                        card("broken", "lesson.lua:3: unexpected symbol.")};
    CHECK(menu_view(cards, {}, words()).banner.empty());
    CHECK(menu_view(cards, {1, 0}, words()).banner == "lesson.lua:3: unexpected symbol.");
    CHECK(menu_view(cards, {1, 0}, words()).banner_is_error);
}

TEST_CASE("menu: a card shows the most stars with which the learner came to its end, else none") {
    TestStore store;
    const auto play = [&](const char* lesson, EndReason reason, std::int32_t stars) {
        SessionRecord session;
        session.id = random_record_id();
        session.lesson = lesson;
        REQUIRE(store.begin_session(session));
        SessionEnd end;
        end.session = session.id;
        end.reason = reason;
        end.stars = stars;
        REQUIRE(store.end_session(end));
    };
    play("weights", EndReason::finished, 1);
    play("weights", EndReason::finished, 2);
    play("weights", EndReason::finished, 0);
    play("kite", EndReason::left, 3);
    CHECK(read_best_stars(store, "").empty());
    const BestStars stars = read_best_stars(store, "Mina");
    LessonCard weights = card("Weights");
    weights.id = "weights";
    LessonCard kite = card("Kite");
    kite.id = "kite";
    const View view = menu_view({weights, kite}, {}, words(), {.learner = "Mina"}, stars);
    CHECK(view.menu[0].stars == 2);
    CHECK(view.menu[1].stars == -1);
    CHECK(menu_view({weights}, {}, words()).menu[0].stars == -1);
}

TEST_CASE("menu: lessons that say where they stand come first, in that order") {
    std::vector<LessonCard> cards{card("a"), card("b"), card("c"), card("d")};
    cards[1].order = 7;
    cards[3].order = 2;
    put_in_order(cards);
    CHECK(cards[0].title == "d");
    CHECK(cards[1].title == "b");
    CHECK(cards[2].title == "a");
    CHECK(cards[3].title == "c");
}

TEST_CASE("menu: without lessons it says so") {
    CHECK(menu_view({}, {}, words()).caption == "There are no lessons yet.");
}

TEST_CASE("menu: the card under the mouse is chosen, and starts only with a click on it") {
    for (const int n_cards : {1, 4, 7}) {
        for (int i = 0; i < n_cards; ++i) {
            const MenuLayout layout = seen(n_cards, {});
            const MenuAnswer hovered =
                answer_menu(pointing(card_in(layout, i).box), layout, n_cards, {});
            CHECK(hovered.choice.selected == i);
            CHECK_FALSE(hovered.start);
            const MenuAnswer clicked =
                answer_menu(clicking(card_in(layout, i).box), layout, n_cards, {});
            CHECK(clicked.choice.selected == i);
            CHECK(clicked.start);
        }
    }
}

TEST_CASE("menu: a click beside the cards does nothing") {
    const MenuLayout layout = seen(4, {2, 0});
    for (const runtime::Box& beside :
         {runtime::Box{2, 360, 1, 1}, runtime::Box{640, 715, 1, 1}, runtime::Box{-50, -50, 1, 1},
          runtime::Box{card_in(layout, 0).paper.right() + 8.0F, 360, 1, 1}}) {
        const MenuAnswer answer = answer_menu(clicking(beside), layout, 4, {2, 0});
        CHECK_FALSE(answer.start);
        CHECK(answer.choice.selected == 2);
        CHECK(answer.choice.first_row == 0);
    }
}

TEST_CASE("menu: a click counts where it was made, not where the mouse went afterwards") {
    const MenuLayout layout = seen(4, {});
    MenuInput input = clicking(card_in(layout, 1).box);
    input.pointer_x_px = static_cast<double>(card_in(layout, 3).box.middle_x());
    const MenuAnswer answer = answer_menu(input, layout, 4, {});
    CHECK(answer.start);
    CHECK(answer.choice.selected == 1);
}

TEST_CASE("menu: a mouse that rests changes nothing while keys choose") {
    const MenuLayout layout = seen(4, {});
    MenuInput input = pointing(card_in(layout, 3).box);
    input.pointed = false;
    input.across = 1;
    CHECK(answer_menu(input, layout, 4, {}).choice.selected == 1);
}

TEST_CASE("menu: keys move by a card or by a row, and stop at the ends") {
    // Seven cards stand in rows of four and three.
    CHECK(selected_after(keys(1, 0), 7, {3, 0}) == 4);
    CHECK(selected_after(keys(-1, 0), 7, {0, 0}) == 0);
    CHECK(selected_after(keys(1, 0), 7, {6, 0}) == 6);
    CHECK(selected_after(keys(0, 1), 7, {1, 0}) == 5);
    CHECK(selected_after(keys(0, 1), 7, {3, 0}) == 6);
    CHECK(selected_after(keys(0, 1), 7, {5, 0}) == 5);
    CHECK(selected_after(keys(0, -1), 7, {5, 0}) == 1);
    CHECK(selected_after(keys(0, -1), 7, {1, 0}) == 1);
    MenuInput start;
    start.start = true;
    CHECK(answer_menu(start, seen(7, {5, 0}), 7, {5, 0}).start);
    CHECK(answer_menu(start, seen(7, {5, 0}), 7, {5, 0}).choice.selected == 5);
}

TEST_CASE("menu: the wheel and the signs bring other rows into sight") {
    const MenuLayout layout = seen(12, {1, 0});
    REQUIRE(layout.all_rows == layout.rows + 1);
    MenuInput wheel;
    wheel.scroll = 1;
    for (const MenuInput& input : {wheel, clicking(layout.later)}) {
        const MenuAnswer answer = answer_menu(input, layout, 12, {1, 0});
        CHECK_FALSE(answer.start);
        CHECK(answer.choice.first_row == 1);
        const MenuLayout after = seen(12, answer.choice);
        CHECK(after.first_row == 1);
        // The same place on the screen, another card in it.
        CHECK(card_in(after, answer.choice.selected).box.x == card_in(layout, 1).box.x);
        CHECK(card_in(after, answer.choice.selected).box.y == card_in(layout, 1).box.y);
        const MenuAnswer back = answer_menu(clicking(after.earlier), after, 12, answer.choice);
        CHECK(back.choice.first_row == 0);
        CHECK(back.choice.selected == 1);
    }
    wheel.scroll = -5;
    CHECK(answer_menu(wheel, layout, 12, {1, 0}).choice.selected == 1);
    wheel.scroll = 5;
    CHECK(answer_menu(wheel, layout, 12, {1, 0}).choice.first_row == 1);
}

TEST_CASE("menu: without lessons nothing starts") {
    MenuInput input = clicking({640, 360, 1, 1});
    input.start = true;
    input.down = 3;
    CHECK_FALSE(answer_menu(input, seen(0, {}), 0, {}).start);
}

TEST_CASE("menu: the window's events are read as they are meant") {
    WindowEvents events;
    events.pressed = {{"down"}, {"down"}, {"left"}, {"a"}};
    events.wheel = -0.6;  // towards the user: later rows
    events.pointer_moved = true;
    events.pointer_x_px = 3.0;
    events.pointer_y_px = 4.0;
    events.button_press = {false, true, false};
    double wheel = 0.0;
    TypedLine name;
    const MenuInput first = read_menu_input(events, wheel, name);
    CHECK(first.down == 2);
    CHECK(first.across == -1);
    CHECK_FALSE(first.start);
    CHECK_FALSE(first.back);
    CHECK_FALSE(first.close);
    CHECK(first.scroll == 0);
    CHECK(first.pointed);
    CHECK(first.pointer_x_px == 3.0);
    CHECK(first.pointer_y_px == 4.0);
    CHECK_FALSE(first.clicked);  // only the left button starts

    events.pressed = {{"space"}};
    events.pointer_moved = false;
    events.button_press = {true, false, false};
    events.press_x_px = 7.0;
    events.press_y_px = 9.0;
    const MenuInput second = read_menu_input(events, wheel, name);
    CHECK(second.scroll == 1);
    CHECK_FALSE(second.pointed);
    CHECK(wheel == Approx(0.2));
    CHECK(second.start);
    CHECK(second.clicked);
    CHECK(second.click_x_px == 7.0);
    CHECK(second.click_y_px == 9.0);
    events.pressed = {{"escape"}};
    const MenuInput escaped = read_menu_input(events, wheel, name);
    CHECK(escaped.back);
    CHECK_FALSE(escaped.close);
    events.pressed.clear();
    events.close = true;
    CHECK(read_menu_input(events, wheel, name).close);
    CHECK_FALSE(read_menu_input(events, wheel, name).back);
}

TEST_CASE("menu: what is typed is who plays; a blank within a name starts nothing") {
    const auto type = [](const char* text) {
        KeyPress press;
        press.text = text;
        return press;
    };
    WindowEvents events;
    events.pressed = {type(" "), {"z"}, type("Z"), type("oë"), {"space"}, type(" "), type("B")};
    double wheel = 0.0;
    TypedLine name;
    const MenuInput typed = read_menu_input(events, wheel, name);
    CHECK(name.text() == "Zoë B");
    CHECK(typed.typed);
    CHECK_FALSE(typed.start);
    events.pressed = {{"backspace"}, {"backspace"}, {"backspace"}};
    CHECK(read_menu_input(events, wheel, name).typed);
    CHECK(name.text() == "Zo");
    events.pressed = {{"return"}};
    CHECK(read_menu_input(events, wheel, name).start);
    CHECK(name.text() == "Zo");

    const View asked = menu_view({card("Weights")}, {}, words());
    CHECK(asked.input_visible);
    CHECK(asked.caption == "Who are you?");
    const View greeted = menu_view({card("Weights")}, {}, words(), {.learner = "Zo"});
    CHECK(greeted.caption == "Hello, Zo!");
    CHECK(greeted.input == "Zo");
    CHECK_FALSE(menu_view({}, {}, words()).input_visible);
}

TEST_CASE("typing: letters come in, return takes the line") {
    TypedLine line;
    line.add("an ");
    line.add("apple");
    CHECK(line.text() == "an apple");
    CHECK(line.take() == "an apple");
    CHECK(line.text().empty());
    CHECK_FALSE(line.take());
}

TEST_CASE("typing: backspace takes whole characters, also those of several bytes") {
    TypedLine line;
    line.add("aé사");
    line.backspace();
    CHECK(line.text() == "aé");
    line.backspace();
    CHECK(line.text() == "a");
    line.backspace();
    line.backspace();
    CHECK(line.text().empty());
}

TEST_CASE("typing: control characters and overlong lines are left out, no part of a character") {
    TypedLine line;
    line.add("a\nb\tc\x7f");
    CHECK(line.text() == "abc");
    line.clear();
    for (int i = 0; i < 100; ++i) {
        line.add("é");
    }
    CHECK(line.text().size() == 160);
    line.add("é");
    CHECK(line.text().size() == 160);
}

TEST_CASE("typing: blanks alone are no answer") {
    CHECK(TypedLine().is_blank());
    CHECK(TypedLine(9, "  ").is_blank());
    CHECK_FALSE(TypedLine(9, " a").is_blank());
    TypedLine line;
    line.add("   ");
    CHECK_FALSE(line.take());
    CHECK(line.text().empty());
}
