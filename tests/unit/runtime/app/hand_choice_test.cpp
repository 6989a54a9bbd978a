#include "runtime/app/hand_choice.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

LessonDescription lesson_of(std::size_t n_hands, bool needed = false) {
    LessonDescription lesson;
    for (std::size_t i = 1; i < n_hands; ++i) {
        lesson.more_hands.emplace_back();
        lesson.more_hands.back().needed = needed;
        lesson.more_hands.back().line = 6;
    }
    return lesson;
}

HandChoice moved_by(HandKind kind) {
    HandChoice choice;
    choice.hand = kind;
    return choice;
}

// What moves the second hand; none where it is not there.
HandKind settle_second(const LessonDescription& lesson, const HandsOrder& order,
                       std::vector<HandChoice> asked = {}) {
    const auto told = value_of(settle_hands(lesson, order, asked));
    CHECK(told.empty());
    return asked.empty() ? HandKind::none : asked.front().hand;
}

}  // namespace

TEST_CASE("hand choice: a word says what moves a hand, and is said back") {
    for (const char* word : {"mouse", "keys", "none", "udp:desk:4701", "left.lua"}) {
        const auto choice = value_of(read_hand(word, true, "k"));
        CHECK(name_of(choice) == word);
    }
    CHECK(read_hand("udp:desk:4701", false, "k")->key_file == "k");
    CHECK(read_hand("keys", true, "")->hand == HandKind::keys);
    CHECK(
        to_sentence(read_hand("mouse", false, "").error()) ==
        "there is no mouse without a window; leave --hand out, give it a hand's file, or add --by "
        "mouse.");
    CHECK(to_sentence(read_hand("keys", false, "").error())
              .starts_with("there are no keys without a window"));
    CHECK(
        to_sentence(read_hand("foot", true, "").error()).starts_with("there is no hand \"foot\""));
    CHECK(to_sentence(read_hand("replay:none.rec", true, "").error())
              .starts_with("none.rec: there is no such record"));
}

TEST_CASE("hand choice: the first hand is always there, and a mouse moves one") {
    CHECK(check_shared(moved_by(HandKind::mouse), {moved_by(HandKind::keys)}));
    CHECK(check_shared(moved_by(HandKind::link), {moved_by(HandKind::link)}));
    CHECK_FALSE(check_shared(moved_by(HandKind::none), {}));
    CHECK_FALSE(check_shared(moved_by(HandKind::mouse), {moved_by(HandKind::mouse)}));
    CHECK_FALSE(check_shared(moved_by(HandKind::keys), {moved_by(HandKind::keys)}));
}

TEST_CASE("hand choice: at a desk the mouse moves the first hand without a device, keys the next") {
    const LessonDescription two = lesson_of(2);
    CHECK(settle_second(two, {moved_by(HandKind::mouse), HandsThere::desk}) == HandKind::keys);
    CHECK(settle_second(two, {moved_by(HandKind::hid), HandsThere::desk}) == HandKind::mouse);
    CHECK(settle_second(two, {moved_by(HandKind::mouse), HandsThere::desk},
                        {moved_by(HandKind::none)}) == HandKind::none);
    CHECK(settle_second(two, {moved_by(HandKind::mouse), HandsThere::desk},
                        {moved_by(HandKind::link)}) == HandKind::link);
    CHECK(settle_second(lesson_of(1), {moved_by(HandKind::mouse), HandsThere::desk}) ==
          HandKind::none);
}

TEST_CASE("hand choice: without a window a second hand is there where the test names one") {
    LessonDescription two = lesson_of(2);
    const HandChoice first = moved_by(HandKind::scripted);
    CHECK(settle_second(two, {first, HandsThere::simulated}) == HandKind::none);
    CHECK(settle_second(two, {first, HandsThere::all}) == HandKind::scripted);
    CHECK(settle_second(two, {first, HandsThere::nobody}) == HandKind::none);
    two.tests.emplace_back();
    two.tests[0].second_hand = "left.lua";
    CHECK(settle_second(two, {first, HandsThere::simulated}) == HandKind::scripted);
    CHECK(settle_second(two, {first, HandsThere::simulated, PlayedBy::mouse}) == HandKind::keys);
    CHECK(settle_second(two, {first, HandsThere::simulated, PlayedBy::keyboard}) == HandKind::none);
    CHECK(settle_second(two, {first, HandsThere::nobody}) == HandKind::none);
}

TEST_CASE("hand choice: what a lesson cannot use is left alone, what it needs is asked for") {
    std::vector<HandChoice> more{moved_by(HandKind::mouse), moved_by(HandKind::none)};
    const HandsOrder order{moved_by(HandKind::link), HandsThere::desk};
    const auto told = value_of(settle_hands(lesson_of(1), order, more));
    CHECK(more.empty());
    CHECK(told == std::vector<std::string>{
                      "This lesson uses one hand: mouse is left alone, without force."});
    more = {moved_by(HandKind::mouse), moved_by(HandKind::keys)};
    const auto third = value_of(settle_hands(lesson_of(2), order, more));
    CHECK(more.size() == 1);
    CHECK(third.at(0) == "This lesson uses two hands: keys is left alone, without force.");
    more = {moved_by(HandKind::none)};
    CHECK(refusal_of(settle_hands(lesson_of(2, true), order, more)) ==
          "lesson.lua:6: this lesson needs two hands at once, and one is there; give --hand twice, "
          "such as --hand hid --hand mouse, or two files of simulated hands.");
}
