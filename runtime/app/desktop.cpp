#include "runtime/app/desktop.h"

#include "haptics/base/clock.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace fulcrum::runtime {

namespace {

// A window that is hidden or minimised is not held back by the screen; it must not take a processor for itself.
constexpr double kShortestFrame_s = 1.0 / 120.0;
constexpr double kLongestFrame_s = 0.1;  // as sound is told

}  // namespace

Expected<Desktop> Desktop::open(const Places& places, bool with_sound, const VoiceSettings& voice) {
    Desktop desktop;
    auto window = Window::create("Fulcrum", 1280, 720);
    if (!window) {
        return tl::unexpected(window.error());
    }
    desktop.window = std::move(*window);
    auto picture = Picture::create(places);
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
    if (voice.kind != VoiceKind::none && desktop.sound->audible()) {
        desktop.voice = std::make_unique<SpokenVoice>(voice, *desktop.sound);
    }
    return desktop;
}

void Desktop::draw(const View& view) {
    picture->draw(view, window->width_px(), window->height_px());
}

MenuLayout Desktop::menu_layout(const View& view) const {
    return picture->menu_layout(view, window->width_px(), window->height_px());
}

void Desktop::finish_frame() {
    window->swap();
    const double left_s = shown_s_ + kShortestFrame_s - monotonic_now_s();
    if (left_s > 0.0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
    }
    const double now_s = monotonic_now_s();
    if (sound) {
        sound->update(std::min(now_s - shown_s_, kLongestFrame_s));
    }
    if (voice) {
        voice->step(now_s - shown_s_);
        if (const std::string trouble = voice->take_trouble(); !trouble.empty()) {
            std::fprintf(stderr, "Nothing is said aloud: %s\n", trouble.c_str());
        }
    }
    shown_s_ = now_s;
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
