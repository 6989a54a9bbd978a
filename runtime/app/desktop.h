// The window with its picture and its sound: what a person sits in front of.
#pragma once

#include "runtime/app/picture_thread.h"
#include "runtime/app/places.h"
#include "runtime/audio/sound_player.h"
#include "runtime/audio/voice/spoken_voice.h"

#include <memory>
#include <string>

namespace fulcrum::runtime {

struct Desktop {
    std::unique_ptr<Window> window;
    std::unique_ptr<PictureThread> picture;  ///< has the window's context
    std::unique_ptr<SoundPlayer> sound;      ///< null when the plan has no sound: nothing is opened
    std::unique_ptr<SpokenVoice> voice;      ///< null when nothing is said aloud, or could be heard
    double finished_s_ = 0.0;                // when the last frame was, monotonic clock

    /// Opens the window, and the sound card when it is wanted. A missing sound card is a sentence on the terminal.
    [[nodiscard]] static Expected<Desktop> open(const Places& places, bool with_sound,
                                                const VoiceSettings& voice);

    /// Waits until it is time to look again, twice in a frame of a lesson and whatever the picture does, and lets the sound go on by the time that has passed.
    void finish_frame();
    /// Plays what a frame asked for; a body without a sound of its own makes the common one.
    void play(const std::vector<std::string>& names);
    /// Says texts aloud, one after the other, after what is still to be said.
    void say(const std::vector<std::string>& texts);
    /// Says these at once, whatever was being said.
    void say_again(const std::vector<std::string>& texts);
    /// Somebody speaks now.
    [[nodiscard]] bool speaks() const { return sound && sound->is_speaking(); }
    /// Nothing more is said.
    void hush();
    /// Nor heard.
    void fall_silent();
};

}  // namespace fulcrum::runtime
