#include "runtime/app/live_ear.h"

#include "haptics/base/clock.h"
#include "runtime/audio/recorded_microphone.h"
#include "tests/support/eventually.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <thread>

using namespace fulcrum::runtime::test;
using namespace fulcrum::test_support;

namespace {

Expected<std::unique_ptr<Microphone>> open_quiet() {
    return std::make_unique<RecordedMicrophone>(std::vector<std::int16_t>{},
                                                RecordedMicrophoneSettings{.speed = 20.0});
}

Expected<std::unique_ptr<Microphone>> open_none() {
    return fail("no microphone was found", {}, "plug one in, or type");
}

WindowEvents key_down(const std::string& key, bool repeat = false) {
    WindowEvents events;
    events.pressed.push_back({.key = key, .repeat = repeat});
    return events;
}

WindowEvents key_up(const std::string& key) {
    WindowEvents events;
    events.released.push_back(key);
    return events;
}

const dialogue::Catalogue& words() {
    static const auto kWords = dialogue::Catalogue::parse(
                                   "hud.listening = LISTENING\n"
                                   "hud.hold_to_speak = HOLD {key}\n"
                                   "hud.speak = SPEAK\n"
                                   "hud.listen_first = FIRST\n"
                                   "banner.no_microphone = NONE\n")
                                   .value();
    return kWords;
}

runtime::View shown(const LiveEar& ear) {
    runtime::View view;
    view.input_visible = true;
    ear.show(view, words());
    return view;
}

}  // namespace

TEST_CASE("live ear: the key that is held takes in what is said, and asks for silence once") {
    LiveEar ear(ListenMode::hold, open_quiet);
    (void)ear.step(true, false);
    CHECK(eventually([&] { return shown(ear).microphone.words == "HOLD Control"; }));
    CHECK_FALSE(ear.take_keys(key_down("a")));
    CHECK(ear.take_keys(key_down("control")));
    CHECK_FALSE(ear.take_keys(key_down("control", true)));
    CHECK(eventually([&] { return shown(ear).microphone.hears; }));
    CHECK(shown(ear).microphone.words == "LISTENING");
    CHECK_FALSE(ear.take_keys(key_up("shift")));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));  // a second of its own
    CHECK(shown(ear).microphone.hears);
    CHECK_FALSE(ear.take_keys(key_up("control")));
    std::optional<std::vector<std::int16_t>> said;
    CHECK(eventually([&] { return (said = ear.step(true, false)).has_value(); }));
    CHECK_FALSE(shown(ear).microphone.hears);
}

TEST_CASE("live ear: a window that is left lets go of the key") {
    LiveEar ear(ListenMode::hold, open_quiet);
    (void)ear.step(true, false);
    CHECK(ear.take_keys(key_down("control")));
    CHECK(eventually([&] { return shown(ear).microphone.hears; }));
    WindowEvents left;
    left.lost_focus = true;
    CHECK_FALSE(ear.take_keys(left));
    CHECK(eventually([&] { return !shown(ear).microphone.hears; }));
}

TEST_CASE("live ear: where nobody listens the key means nothing and nothing is shown") {
    LiveEar ear(ListenMode::hold, open_quiet);
    CHECK_FALSE(ear.take_keys(key_down("control")));
    CHECK_FALSE(ear.step(false, false));
    runtime::View view;
    ear.show(view, words());
    CHECK_FALSE(view.microphone.visible);
    CHECK(view.banner.empty());
}

TEST_CASE("live ear: without a key it says when to speak, and when to listen first") {
    LiveEar ear(ListenMode::always, open_quiet);
    (void)ear.step(true, false);
    CHECK_FALSE(ear.take_keys(key_down("control")));
    CHECK(eventually([&] { return shown(ear).microphone.words == "SPEAK"; }));
    (void)ear.step(true, true);
    CHECK(eventually([&] { return shown(ear).microphone.words == "FIRST"; }));
    CHECK(shown(ear).microphone.level == 0.0);
}

TEST_CASE("live ear: without a microphone a banner says so, and another one stays") {
    LiveEar ear(ListenMode::hold, open_none);
    CHECK(eventually([&] { return shown(ear).banner == "NONE"; }));
    CHECK_FALSE(shown(ear).microphone.visible);
    runtime::View view;
    view.input_visible = true;
    view.banner = "another";
    ear.show(view, words());
    CHECK(view.banner == "another");
    CHECK(ear.take_trouble().find("no microphone was found") == 0);
    CHECK(ear.take_trouble().empty());
}
