#include "runtime/audio/voice/spoken_voice.h"

namespace fulcrum::runtime {
namespace {

constexpr int kMostWaiting = 3;  // texts: a reply, and what to do next

}  // namespace

void SpokenVoice::say(std::string_view text) {
    if (text.empty()) {
        return;
    }
    if (maker_.n_waiting() >= kMostWaiting) {
        maker_.forget();
    }
    maker_.ask(text);
}

void SpokenVoice::step(double /*dt_s*/) {
    while (!player_.is_speaking()) {
        const auto made = maker_.take();
        if (!made) {
            return;
        }
        if (!made->samples.empty()) {
            player_.speak(made->samples);
            return;
        }
    }
}

void SpokenVoice::stop() {
    maker_.forget();
    player_.hush();
}

}  // namespace fulcrum::runtime
