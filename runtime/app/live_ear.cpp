#include "runtime/app/live_ear.h"

#include <algorithm>
#include <utility>

namespace fulcrum::runtime {
namespace {

GateSettings gate_of(ListenMode mode) {
    GateSettings settings;
    settings.mode = mode;
    return settings;
}

}  // namespace

LiveEar::LiveEar(ListenMode mode, OpenMicrophone open)
    : mode_(mode), ear_(gate_of(mode), std::move(open)) {}

bool LiveEar::take_keys(const WindowEvents& events) {
    const bool down = std::ranges::any_of(
        events.pressed, [](const KeyPress& press) { return press.key == kKey && !press.repeat; });
    if (down) {
        ear_.hold(true);
    }
    // Both in one frame: it was brushed.
    if (events.lost_focus || std::ranges::find(events.released, kKey) != events.released.end()) {
        ear_.hold(false);
    }
    return down && wanted_ && mode_ == ListenMode::hold;
}

std::optional<std::vector<std::int16_t>> LiveEar::step(bool wanted, bool speaks) {
    wanted_ = wanted;
    ear_.listen(wanted);
    ear_.speak(speaks);
    return wanted ? ear_.take() : std::nullopt;
}

void LiveEar::show(View& view, const dialogue::Catalogue& catalogue) const {
    const EarState state = ear_.state();
    if (!view.input_visible) {
        return;
    }
    if (!state.has_microphone) {
        if (view.banner.empty()) {
            view.banner = catalogue.say("banner.no_microphone");
        }
        return;
    }
    view.microphone.visible = true;
    view.microphone.hears = state.hears;
    view.microphone.level = state.deaf ? 0.0 : state.level;
    if (state.hears) {
        view.microphone.words = catalogue.say("hud.listening");
    } else if (mode_ == ListenMode::hold) {
        view.microphone.words = catalogue.say("hud.hold_to_speak", {{"key", "Control"}});
    } else {
        view.microphone.words = catalogue.say(state.deaf ? "hud.listen_first" : "hud.speak");
    }
}

}  // namespace fulcrum::runtime
