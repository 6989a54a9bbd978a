#include "runtime/app/desktop.h"

#include "haptics/base/clock.h"
#include "runtime/app/installation.h"
#include "runtime/app/speech/speech_parts.h"
#include "runtime/audio/open_sound_player.h"

#include <algorithm>
#include <cctype>
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

Expected<Desktop> Desktop::open(const Installation& installation, const Options& options) {
    Desktop desktop;
    desktop.options = &options;
    desktop.words = std::make_unique<HomeWords>(installation.places.words, installation.catalogue);
    desktop.usual.set(SettingKind::language, static_cast<int>(find_system_language()));
    auto window = Window::create("Fulcrum", 1280, 720);
    if (!window) {
        return tl::unexpected(window.error());
    }
    desktop.window = std::move(*window);
    Window::on_lost_screen(leave_without_screen);
    auto picture = PictureThread::start(installation.places, *desktop.window);
    if (!picture) {
        return tl::unexpected(picture.error());
    }
    desktop.picture = std::move(*picture);
    desktop.picture->set_level(options.picture);
    desktop.voice_settings.kind = VoiceKind::none;
    if (options.mute) {
        desktop.use(desktop.usual);
        return desktop;
    }
    auto sound = open_sound_player({});
    if (!sound) {
        return tl::unexpected(sound.error());
    }
    if (!sound->notice.empty()) {
        runtime::say(sound->notice);
    }
    desktop.sound = std::move(sound->player);
    desktop.use(desktop.usual);
    return desktop;
}

bool Desktop::may_set(SettingKind kind) const {
    switch (kind) {
        case SettingKind::sound:
            return !options->mute;
        case SettingKind::voice:
            return !options->mute && !options->voice && !options->voice_speed;
        case SettingKind::hand:
            return !options->fit.left_handed;
        case SettingKind::language:
            return !options->language;
        case SettingKind::text_size:
        case SettingKind::contrast:
        case SettingKind::motion:
            break;
    }
    return true;
}

void Desktop::use(const ScreenSettings& chosen) {
    settings = chosen;
    picture->set_look({chosen.text_scale(), chosen.high_contrast()});
    if (auto used = words->use(options->language.value_or(chosen.language())); !used) {
        runtime::say(to_sentence(used.error()));
        settings.set(SettingKind::language, static_cast<int>(words->language()));
    }
    if (!sound) {
        return;
    }
    sound->set_volume(chosen.volume());
    VoiceSettings wanted;
    if (may_set(SettingKind::voice)) {
        wanted = chosen.speaks() ? VoiceSettings{wanted.kind, chosen.voice_speed()}
                                 : VoiceSettings{VoiceKind::none};
    } else {
        wanted = {options->voice.value_or(wanted.kind),
                  options->voice_speed.value_or(wanted.speed)};
    }
    if (wanted == voice_settings) {
        return;
    }
    hush();
    voice.reset();
    voice_settings = wanted;
    if (wanted.kind == VoiceKind::none || !sound->audible()) {
        return;
    }
    if (const auto why = why_no_voice()) {
        runtime::say(to_sentence(*why));
    } else {
        voice = std::make_unique<SpokenVoice>(wanted, *sound);
    }
}

std::string Desktop::keep_picture(const View& view, const std::string& file) const {
    const auto kept = save_png(file, picture->show_and_read(view));
    return kept ? std::string() : to_sentence(kept.error());
}

void Desktop::finish_frame() {
    const double left_s = finished_s_ + kDeskFrame_s - monotonic_now_s();
    if (left_s > 0.0) {
        std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
    }
    const double now_s = monotonic_now_s();
    go_on_sounding(now_s - finished_s_);
    finished_s_ = now_s;
}

void Desktop::go_on_sounding(double dt_s) {
    if (sound) {
        sound->update(std::min(dt_s, kLongestFrame_s));
        if (const std::string notice = sound->take_notice(); !notice.empty()) {
            runtime::say(notice);
        }
    }
    if (voice) {
        voice->step(dt_s);
        if (const std::string trouble = voice->take_trouble(); !trouble.empty()) {
            std::fprintf(stderr, "Nothing is said aloud: %s\n", trouble.c_str());
        }
    }
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

void Desktop::read_aloud(const std::string& text, bool at_once) {
    if (!text.empty() && !at_once && speaks()) {
        return;
    }
    if (const auto said = focus_.look(text, monotonic_now_s())) {
        say_again({*said});
    }
}

void Desktop::read_aloud(const ViewMenuItem& card) {
    const bool ends =
        card.title.empty() || std::ispunct(static_cast<unsigned char>(card.title.back())) != 0;
    const std::string text = card.title + (ends ? " " : ". ") + card.subtitle;
    read_aloud(words->language() == Language::english ? text : std::string(), true);
}

void Desktop::read_choice(const View& view, int chosen, const Vector2& pointer_px) {
    const bool by_keys = chosen >= 0;
    if (view.choices.empty()) {
        return read_aloud({}, false);
    }
    if (const auto spot = picture->spot_at(pointer_px.x(), pointer_px.y()); spot && !by_keys) {
        chosen = spot->choice;
    }
    const bool is_one = chosen >= 0 && chosen < static_cast<int>(view.choices.size());
    read_aloud(is_one ? view.choices[static_cast<std::size_t>(chosen)].said : std::string(),
               by_keys);
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
