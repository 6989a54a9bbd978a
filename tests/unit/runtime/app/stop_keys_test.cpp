#include "runtime/app/stop_keys.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

namespace {

constexpr RunState kPlaying{};
constexpr RunState kFailed{.failed = true};
constexpr RunState kFinished{.finished = true};

struct Run {
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    [[nodiscard]] bool is_pressed() const { return channels->emergency_stop.is_pressed(); }
    [[nodiscard]] bool is_rearmed() const { return channels->rearm.load(); }
};

// A key that goes down while it plays, or is held; what it does, and how the run is left.
struct Step {
    const char* key;
    bool is_held;
    StopKey does;
    bool is_pressed, is_rearmed;
};

void press_each(StopKeys& keys, const Run& run, std::initializer_list<Step> steps) {
    for (const Step& step : steps) {
        CAPTURE(step.key, step.is_held);
        CHECK(keys.take(step.key, step.is_held, kPlaying) == step.does);
        CHECK(run.is_pressed() == step.is_pressed);
        CHECK(run.is_rearmed() == step.is_rearmed);
        CHECK(keys.stopped() == step.is_pressed);
    }
}

}  // namespace

TEST_CASE("stop keys: escape presses, return lifts and rearms, a second escape leaves") {
    Run run;
    StopKeys keys;
    keys.watch(run.channels.get());
    press_each(keys, run,
               {{"return", false, StopKey::nothing, false, false},
                {"a", false, StopKey::nothing, false, false},
                {"escape", true, StopKey::nothing, false, false},
                {"escape", false, StopKey::press, true, false},
                {"escape", true, StopKey::nothing, true, false},
                {"return", true, StopKey::nothing, true, false},
                {"a", false, StopKey::nothing, true, false},
                {"return", false, StopKey::lift, false, true}});
    // It was pressed all the same, however briefly: the loop sees it once.
    CHECK(run.channels->emergency_stop.take());
    CHECK_FALSE(run.channels->emergency_stop.take());
    press_each(keys, run,
               {{"escape", false, StopKey::press, true, true},
                {"escape", false, StopKey::leave, true, true}});
}

TEST_CASE("stop keys: where nothing is left to stop, escape leaves") {
    for (const RunState& state : {kFailed, kFinished}) {
        Run run;
        StopKeys keys;
        keys.watch(run.channels.get());
        CHECK(keys.take("escape", false, state) == StopKey::leave);
        CHECK_FALSE(run.is_pressed());
    }
}

TEST_CASE("stop keys: a stop outlives the run, and a failed run's return lifts nothing") {
    Run first;
    Run second;
    StopKeys keys;
    keys.watch(first.channels.get());
    CHECK(keys.take("escape", false, kPlaying) == StopKey::press);
    keys.watch(nullptr);
    CHECK(keys.take("return", false, kFailed) == StopKey::nothing);
    CHECK(keys.stopped());
    keys.watch(second.channels.get());
    CHECK(second.is_pressed());
    CHECK_FALSE(second.is_rearmed());
    press_each(keys, second, {{"return", false, StopKey::lift, false, true}});
    // One that was lifted is not pressed again.
    Run third;
    keys.watch(third.channels.get());
    CHECK_FALSE(third.is_pressed());
}

TEST_CASE(
    "stop keys: where nothing pushes, escape and P pause, P and return go on, escape leaves") {
    constexpr RunState kByMouse{.renders_force = false};
    Run run;
    StopKeys keys;
    keys.watch(run.channels.get());
    for (const char* goes_on : {"p", "return"}) {
        CHECK(keys.take("escape", false, kByMouse) == StopKey::press);
        CHECK(keys.paused());
        CHECK(run.is_pressed());
        CHECK(keys.take("a", false, kByMouse) == StopKey::nothing);
        CHECK(keys.take(goes_on, false, kByMouse) == StopKey::lift);
        CHECK_FALSE(keys.stopped());
        CHECK(run.is_rearmed());
    }
    CHECK(keys.take("p", false, kByMouse) == StopKey::nothing);  // a letter, to who types
    keys.switch_pause();
    CHECK(keys.paused());
    CHECK(keys.take("escape", false, kByMouse) == StopKey::leave);
    keys.switch_pause();
    CHECK_FALSE(keys.stopped());
    // A stop is no pause, and P does not lift it.
    CHECK(keys.take("escape", false, kPlaying) == StopKey::press);
    CHECK_FALSE(keys.paused());
    CHECK(keys.take("p", false, kPlaying) == StopKey::nothing);
    keys.switch_pause();
    CHECK(keys.stopped());
}

TEST_CASE(
    "stop keys: who plays by mouse and looks elsewhere has a pause; who has not begun has none") {
    Run run;
    StopKeys keys;
    keys.watch(run.channels.get());
    keys.lose_focus(false, false);
    CHECK_FALSE(keys.stopped());
    for (const bool renders_force : {false, true}) {
        keys.lose_focus(renders_force, true);
        CHECK(keys.paused());
        CHECK(keys.stands_still());
        CHECK(keys.take("p", false, kPlaying) == StopKey::lift);
        CHECK_FALSE(keys.stands_still());
    }
}

TEST_CASE("stop keys: an arm whose window lost the keyboard is stopped where nobody plays yet") {
    Run run;
    StopKeys keys;
    keys.lose_focus(true, true);
    CHECK_FALSE(keys.stopped());
    keys.watch(run.channels.get());
    keys.lose_focus(false, false);
    CHECK_FALSE(run.is_pressed());
    keys.lose_focus(true, false);
    CHECK(keys.stopped());
    CHECK_FALSE(keys.paused());
    CHECK_FALSE(keys.stands_still());
    CHECK(run.is_pressed());
    press_each(keys, run, {{"return", false, StopKey::lift, false, true}});
}

TEST_CASE("stop keys: a stop from outside is a stop, once for each, but for earlier lessons'") {
    for (const unsigned heard : {0U, 2U}) {
        Run run;
        StopKeys keys(heard);
        keys.watch(run.channels.get());
        keys.hear(heard);
        CHECK_FALSE(keys.stopped());
        keys.hear(heard + 1);
        CHECK(keys.stopped());
        CHECK(run.is_pressed());
        press_each(keys, run, {{"return", false, StopKey::lift, false, true}});
        keys.hear(heard + 1);
        CHECK_FALSE(keys.stopped());
        keys.hear(heard + 2);
        CHECK(keys.stopped());
    }
}

TEST_CASE("stop keys: a gate stopped at the device is shown so, one lifted just now is not") {
    Run run;
    StopKeys keys;
    keys.watch(run.channels.get());
    for (const int times : {1, 2}) {
        CAPTURE(times);
        for (int frame = 0; frame < 19; ++frame) {
            keys.watch_gate(true);
            REQUIRE_FALSE(keys.stopped());
        }
        keys.watch_gate(times == 2);
    }
    CHECK(keys.stopped());
    // Lifted; the picture still shows it for some frames.
    CHECK(keys.take("return", false, kPlaying) == StopKey::lift);
    keys.watch_gate(true);
    keys.watch_gate(true);
    CHECK_FALSE(keys.stopped());
}
