#include "runtime/app/stop_keys.h"

#include <catch2/catch.hpp>

#include <memory>

namespace fulcrum::runtime {
namespace {

constexpr RunState kPlaying{};
constexpr RunState kFailed{.failed = true};
constexpr RunState kFinished{.finished = true};

struct Run {
    std::unique_ptr<HapticChannels> channels = std::make_unique<HapticChannels>();
    [[nodiscard]] bool is_pressed() const { return channels->emergency_stop.is_pressed(); }
    [[nodiscard]] bool is_rearmed() const { return channels->rearm.load(); }
};

TEST_CASE("stop keys: stops from outside that others heard before are no stops of this lesson") {
    StopKeys keys(2);
    keys.hear(2);
    CHECK_FALSE(keys.stopped());
    keys.hear(3);
    CHECK(keys.stopped());
}

TEST_CASE("stop keys: escape presses, return lifts and rearms, a second escape leaves") {
    Run run;
    StopKeys keys;
    keys.watch(run.channels.get());
    CHECK(keys.take("return", false, kPlaying) == StopKey::nothing);
    CHECK(keys.take("a", false, kPlaying) == StopKey::nothing);
    CHECK_FALSE(run.is_pressed());
    CHECK_FALSE(run.is_rearmed());

    CHECK(keys.take("escape", false, kPlaying) == StopKey::press);
    CHECK(keys.stopped());
    CHECK(run.is_pressed());
    CHECK(keys.take("a", false, kPlaying) == StopKey::nothing);
    CHECK(run.is_pressed());
    CHECK_FALSE(run.is_rearmed());

    CHECK(keys.take("return", false, kPlaying) == StopKey::lift);
    CHECK_FALSE(keys.stopped());
    CHECK_FALSE(run.is_pressed());
    CHECK(run.is_rearmed());
    // It was pressed all the same, however briefly: the loop sees it once.
    CHECK(run.channels->emergency_stop.take());
    CHECK_FALSE(run.channels->emergency_stop.take());

    CHECK(keys.take("escape", false, kPlaying) == StopKey::press);
    CHECK(keys.take("escape", false, kPlaying) == StopKey::leave);
    CHECK(run.is_pressed());
}

TEST_CASE("stop keys: a key that is held down does nothing more") {
    Run run;
    StopKeys keys;
    keys.watch(run.channels.get());
    CHECK(keys.take("escape", true, kPlaying) == StopKey::nothing);
    CHECK_FALSE(run.is_pressed());
    CHECK(keys.take("escape", false, kPlaying) == StopKey::press);
    CHECK(keys.take("escape", true, kPlaying) == StopKey::nothing);
    CHECK(keys.take("return", true, kPlaying) == StopKey::nothing);
    CHECK(run.is_pressed());
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
    CHECK(keys.take("return", false, kPlaying) == StopKey::lift);
    CHECK_FALSE(second.is_pressed());
    CHECK(second.is_rearmed());
    // One that was lifted is not pressed again.
    Run third;
    keys.watch(third.channels.get());
    CHECK_FALSE(third.is_pressed());
}

TEST_CASE("stop keys: an arm whose window lost the keyboard is stopped; a mouse goes on") {
    Run run;
    StopKeys keys;
    keys.lose_focus(true);
    CHECK_FALSE(keys.stopped());
    keys.watch(run.channels.get());
    keys.lose_focus(false);
    CHECK_FALSE(run.is_pressed());
    keys.lose_focus(true);
    CHECK(keys.stopped());
    CHECK(run.is_pressed());
    CHECK(keys.take("return", false, kPlaying) == StopKey::lift);
    CHECK_FALSE(run.is_pressed());
}

}  // namespace
}  // namespace fulcrum::runtime

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("stop keys: a stop from outside is a stop, once for each") {
    HapticChannels channels;
    StopKeys keys;
    keys.watch(&channels);
    keys.hear(0);
    CHECK_FALSE(keys.stopped());
    keys.hear(1);
    CHECK(keys.stopped());
    CHECK(channels.emergency_stop.is_pressed());
    CHECK(keys.take("return", false, RunState{}) == StopKey::lift);
    keys.hear(1);
    CHECK_FALSE(keys.stopped());
    keys.hear(2);
    CHECK(keys.stopped());
}

TEST_CASE(
    "stop keys: a gate that was stopped at the device is shown as stopped, one that was lifted "
    "just now is not") {
    HapticChannels channels;
    StopKeys keys;
    keys.watch(&channels);
    for (int frame = 0; frame < 19; ++frame) {
        keys.watch_gate(true);
        REQUIRE_FALSE(keys.stopped());
    }
    keys.watch_gate(false);
    for (int frame = 0; frame < 19; ++frame) {
        keys.watch_gate(true);
        REQUIRE_FALSE(keys.stopped());
    }
    keys.watch_gate(true);
    CHECK(keys.stopped());
    // Lifted; the picture still shows it for some frames.
    CHECK(keys.take("return", false, RunState{}) == StopKey::lift);
    keys.watch_gate(true);
    keys.watch_gate(true);
    CHECK_FALSE(keys.stopped());
}
