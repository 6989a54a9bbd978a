#include "runtime/app/lesson_cards.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

LessonCard make_card(const std::string& name) {
    LessonCard card;
    card.name = name;
    card.id = name + "-id";
    card.title = "The " + name;
    card.level = "A1";
    return card;
}

}  // namespace

TEST_CASE("lesson cards: a room knows what can be played, in its order, and how well it went") {
    LessonCard room = make_card("room");
    room.is_room = true;
    LessonCard broken = make_card("broken");
    broken.error = "lesson.lua:3: no.";
    LessonCard last = make_card("last");
    LessonCard first = make_card("first");
    first.order = 1;
    std::vector<LessonCard> cards{room, last, broken, first};
    put_in_order(cards);
    // Stars are kept by a lesson's id, whatever its folder is called.
    const auto known = list_known_lessons(cards, {{"last-id", 2}, {"first", 3}});
    REQUIRE(known.size() == 2);
    CHECK(known[0].name == "first");
    CHECK(known[0].title == "The first");
    CHECK(known[0].stars == -1);
    CHECK(known[1].name == "last");
    CHECK(known[1].stars == 2);
}
