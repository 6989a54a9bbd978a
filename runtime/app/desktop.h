// The window with its picture and its sound: what a person sits in front of.
#pragma once

#include "runtime/app/home_words.h"
#include "runtime/app/installation.h"
#include "runtime/app/options.h"
#include "runtime/app/picture_thread.h"
#include "runtime/app/places.h"
#include "runtime/app/spoken_focus.h"
#include "runtime/audio/sound_player.h"
#include "runtime/audio/voice/spoken_voice.h"
#include "runtime/scene/screen_settings.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

struct Desktop {
    std::unique_ptr<Window> window;
    std::unique_ptr<PictureThread> picture;  ///< has the window's context
    std::unique_ptr<SoundPlayer> sound;      ///< null when the plan has no sound: nothing is opened
    std::unique_ptr<SpokenVoice> voice;      ///< null when nothing is said aloud, or could be heard
    std::unique_ptr<HomeWords> words;        ///< as the settings have their language
    ScreenSettings usual{};                  ///< of who has chosen nothing: the system's language
    ScreenSettings settings{};               ///< of who plays; see `use`
    VoiceSettings voice_settings{};          ///< of the voice, or none
    const Options* options = nullptr;        ///< they go before the settings
    SpokenFocus focus_{};
    double finished_s_ = 0.0;  // when the last frame was, monotonic clock

    /// Opens the window, and the sound card when it is wanted. A missing sound card is a sentence on the terminal.
    /// The options outlive the desktop.
    [[nodiscard]] static Expected<Desktop> open(const Installation& installation,
                                                const Options& options);

    /// Looks and sounds so from now on, but for what the command line says.
    void use(const ScreenSettings& chosen);
    /// The command line leaves it open.
    [[nodiscard]] bool may_set(SettingKind kind) const;

    /// Shows that view and writes the picture; why it could not, or nothing.
    [[nodiscard]] std::string keep_picture(const View& view, const std::string& file) const;

    /// Waits until it is time to look again, twice in a frame of a lesson and whatever the picture does, and lets the sound go on by the time that has passed.
    void finish_frame();
    /// The same for what is heard alone, without waiting.
    void go_on_sounding(double dt_s);
    /// Plays what a frame asked for; a body without a sound of its own makes the common one.
    void play(const std::vector<std::string>& names);
    /// Says texts aloud, one after the other, after what is still to be said.
    void say(const std::vector<std::string>& texts);
    /// Says these at once, whatever was being said.
    void say_again(const std::vector<std::string>& texts);
    /// Reads what is chosen (spoken_focus.h), an English text; called all the while, with nothing where nothing is. What is being said is heard
    /// out first, but for who has chosen by keys, `at_once`.
    void read_aloud(const std::string& text, bool at_once);
    /// The same of a card, where the window speaks English.
    void read_aloud(const ViewMenuItem& card);
    /// The same of an answer: the one that keys have chosen, -1 for none, else the one below the pointer.
    void read_choice(const View& view, int chosen, const Vector2& pointer_px);
    /// Somebody speaks now.
    [[nodiscard]] bool speaks() const { return sound && sound->is_speaking(); }
    /// Nothing more is said.
    void hush();
    /// Nor heard.
    void fall_silent();
};

}  // namespace fulcrum::runtime
