#include "runtime/app/key_hand.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr PictureSize kSize{1000, 500};
constexpr double kFrame_s = 1.0 / 60.0;

WindowEvents at(double x, double y) {
    WindowEvents events;
    events.pointer_x_px = x;
    events.pointer_y_px = y;
    return events;
}

// So many frames after the keys went down, with the pointer where it was left.
WindowEvents frames(KeyHand& hand, WindowEvents events, int n) {
    for (int i = 0; i < n; ++i) {
        hand.take(events, false, kSize, kFrame_s);
        events.pressed.clear();
        events.released_places.clear();
        events.wheel = 0.0;
        events.button_down = {};
    }
    return events;
}

WindowEvents pressed(const std::string& key) {
    WindowEvents events = at(500.0, 250.0);
    events.pressed.push_back({.key = key});
    return events;
}

}  // namespace

TEST_CASE("key hand: each of its keys moves the pointer its way, and no other key does") {
    const auto moved = [](const std::string& key) {
        KeyHand hand;
        const WindowEvents events = frames(hand, pressed(key), 10);
        return fulcrum::Vector2(events.pointer_x_px - 500.0, events.pointer_y_px - 250.0);
    };
    CHECK(moved("a").x() < -5.0);
    CHECK(moved("d").x() > 5.0);
    CHECK(moved("w").y() < -5.0);
    CHECK(moved("s").y() > 5.0);
    CHECK(moved("a").y() == 0.0);
    CHECK(moved("x").isZero());
    CHECK(moved("left").isZero());  // is the lesson's
}

TEST_CASE("key hand: it is the keys' place that counts, not what stands on them") {
    // On a French keyboard the key that is W's neighbour below is Q, and Z stands in the place of W.
    WindowEvents events = at(500.0, 250.0);
    events.pressed.push_back({.key = "z", .place = "w"});
    KeyHand hand;
    events = frames(hand, events, 10);
    CHECK(events.pointer_y_px < 245.0);
    // The key with a W there, at the place of Z, moves nothing, nor does it let go.
    const double reached_px = events.pointer_y_px;
    events.pressed.push_back({.key = "w", .place = "z"});
    events.released = {"w"};
    events.released_places = {"z"};
    events = frames(hand, events, 10);
    CHECK(events.pointer_y_px < reached_px - 5.0);
    events.released_places = {"w"};
    const double let_go_px = frames(hand, events, 1).pointer_y_px;
    CHECK(frames(hand, at(500.0, let_go_px), 10).pointer_y_px == let_go_px);
}

TEST_CASE("key hand: a tap is a fine step, and what is held grows to its greatest speed") {
    KeyHand hand;
    const KeyHandSettings settings;
    WindowEvents events = pressed("d");
    events.released_places = {};
    hand.take(events, false, kSize, kFrame_s);
    CHECK(events.pointer_x_px - 500.0 == Approx(settings.slow * kFrame_s * kSize.height_px));

    // Sum of v_i dt with v_i = min(v_slow + a i dt, v_quick).
    double way = settings.slow;
    double speed = settings.slow;
    constexpr int kFrames = 60;
    for (int i = 1; i < kFrames; ++i) {
        speed = std::min(speed + settings.growth * kFrame_s, settings.quick);
        way += speed;
    }
    KeyHand held;
    CHECK(frames(held, pressed("d"), kFrames).pointer_x_px - 500.0 ==
          Approx(std::min(way * kFrame_s * kSize.height_px, 500.0)));
    CHECK(held.step_px(kSize, kFrame_s) == Approx(settings.quick * kFrame_s * kSize.height_px));
}

TEST_CASE("key hand: the pointer stays in the picture, and rests where the key was let go") {
    KeyHand hand;
    CHECK(frames(hand, pressed("a"), 1000).pointer_x_px == 0.0);
    WindowEvents up = at(0.0, 250.0);
    up.released_places = {"a"};
    CHECK(frames(hand, up, 100).pointer_x_px == 0.0);
}

TEST_CASE("key hand: while letters are typed presses move nothing, and what is gripped stays so") {
    KeyHand hand;
    WindowEvents grip = pressed("shift");
    hand.take(grip, false, kSize, kFrame_s);
    CHECK(grip.button_down[0]);
    WindowEvents letters = pressed("d");
    hand.take(letters, true, kSize, kFrame_s);
    CHECK(letters.pointer_x_px == 500.0);
    CHECK(letters.button_down[0]);
}

TEST_CASE("key hand: page keys turn the wheel, the mouse takes over, a lost window lets go") {
    KeyHand hand;
    WindowEvents wheel = pressed("page_up");
    wheel.pressed.push_back({.key = "page_up", .repeat = true});
    hand.take(wheel, true, kSize, kFrame_s);
    CHECK(wheel.wheel == 2.0);

    (void)frames(hand, pressed("d"), 20);
    WindowEvents mouse = at(10.0, 20.0);
    mouse.pointer_moved = true;
    mouse.released_places = {"d"};
    hand.take(mouse, false, kSize, kFrame_s);
    CHECK(mouse.pointer_x_px == 10.0);

    (void)frames(hand, pressed("d"), 5);
    WindowEvents lost = at(10.0, 20.0);
    lost.lost_focus = true;
    hand.take(lost, false, kSize, kFrame_s);
    const double rests_at = lost.pointer_x_px;
    WindowEvents later = at(10.0, 20.0);
    CHECK(frames(hand, later, 10).pointer_x_px == rests_at);
}

TEST_CASE("key hand: who has the mouse in the left hand has I J K L under the right one") {
    const auto moved = [](bool left_handed, const std::string& key) {
        KeyHand hand;
        hand.hold_by(left_handed);
        const WindowEvents events = frames(hand, pressed(key), 10);
        return fulcrum::Vector2(events.pointer_x_px - 500.0, events.pointer_y_px - 250.0);
    };
    CHECK(moved(true, "i").y() < -5.0);
    CHECK(moved(true, "j").x() < -5.0);
    CHECK(moved(true, "k").y() > 5.0);
    CHECK(moved(true, "l").x() > 5.0);
    // The other hand's keys are a lesson's own.
    for (const char* key : {"w", "a", "s", "d"}) {
        CHECK(moved(true, key).isZero());
    }
    CHECK(moved(false, "l").isZero());
    CHECK(moved(false, "d").x() > 5.0);
}
