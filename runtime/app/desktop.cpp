#include "runtime/app/desktop.h"

#include "haptics/base/clock.h"
#include "runtime/app/speech/speech_parts.h"
#include "runtime/audio/open_sound_player.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>
#include <unistd.h>

namespace fulcrum::runtime {

namespace {

constexpr double kDeskFrame_s = 1.0 / 120.0;  // twice a lesson's rate
constexpr double kLongestFrame_s = 0.1;       // as sound is told
constexpr auto kFadeTime =
    std::chrono::milliseconds(250);  // a gate's fade, and the record's last block

// The haptic thread knows of no screen, and lets the force go as after any stop.
void leave_without_screen() noexcept {
    (void)::kill(::getpid(), SIGUSR1);
    std::this_thread::sleep_for(kFadeTime);
    (void)std::fputs(
        "The screen is gone, so the force has been let go and the program ends; what was answered "
        "is kept. Log in "
        "again and start the lesson anew.\n",
        stderr);
}

}  // namespace

Expected<Desktop> Desktop::open(const Places& places, bool with_sound, const VoiceSettings& voice) {
    Desktop desktop;
    auto window = Window::create("Fulcrum", 1280, 720);
    if (!window) {
        return tl::unexpected(window.error());
    }
    desktop.window = std::move(*window);
    Window::on_lost_screen(leave_without_screen);
    auto picture = PictureThread::start(places, *desktop.window);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    desktop.picture = std::move(*picture);
    if (!with_sound) {
        return desktop;
    }
    auto sound = open_sound_player({});
    if (!sound) {
        return tl::unexpected(sound.error());
    }
    if (!sound->notice.empty()) {
        std::fprintf(stderr, "%s\n", sound->notice.c_str());
    }
    desktop.sound = std::move(sound->player);
    if (voice.kind == VoiceKind::none || !desktop.sound->audible()) {
        return desktop;
    }
    if (const auto why = why_no_voice()) {
        std::fprintf(stderr, "%s\n", to_sentence(*why).c_str());
    } else {
        desktop.voice = std::make_unique<SpokenVoice>(voice, *desktop.sound);
    }
    return desktop;
}

void Desktop::finish_frame() {
    const double left_s = finished_s_ + kDeskFrame_s - monotonic_now_s();
    if (left_s > 0.0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
    }
    const double now_s = monotonic_now_s();
    if (sound) {
        sound->update(std::min(now_s - finished_s_, kLongestFrame_s));
        if (const std::string notice = sound->take_notice(); !notice.empty()) {
            std::fprintf(stderr, "%s\n", notice.c_str());
        }
    }
    if (voice) {
        voice->step(now_s - finished_s_);
        if (const std::string trouble = voice->take_trouble(); !trouble.empty()) {
            std::fprintf(stderr, "Nothing is said aloud: %s\n", trouble.c_str());
        }
    }
    finished_s_ = now_s;
}

void Desktop::play(const std::vector<std::string>& names) {
    if (!sound) {
        return;
    }
    for (const std::string& name : names) {
        if (!sound->play(name) && name.rfind("catch_", 0) == 0) {
            (void)sound->play("pop");
        }
    }
}

void Desktop::say(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
        if (voice) {
            voice->say(text);
        }
    }
}

void Desktop::say_again(const std::vector<std::string>& texts) {
    if (!texts.empty()) {
        hush();
        say(texts);
    }
}

void Desktop::hush() {
    if (voice) {
        voice->stop();
    }
}

void Desktop::fall_silent() {
    hush();
    if (sound) {
        sound->stop();
    }
}

}  // namespace fulcrum::runtime
