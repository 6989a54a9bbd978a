// Sounds, behind one interface: a sound card (openal/), nothing (null/), or a buffer for tests
// (openal/ by loopback). All sounds are made by our own code (synthesis.h); there are no sound
// files.
//
//   play("catch_egg") starts a short sound; set_force_sound(F) moves a continuous hum that lets a
//   mouse user hear the force that an arm would feel: silent at 0 N, louder and higher with every
//   newton.
//
// Thread: one thread, the one that opened the player (the picture's or the audio's), never the
// haptic loop. Cost: update about 10 µs; open synthesises each named sound once (about 2 ms a
// sound).
#pragma once

#include "haptics/base/error.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::runtime {

/// Fixed when the player is opened.
struct SoundSettings {
    std::vector<std::string>
        names;                 ///< sounds that will be played, all of sound_names() when empty
    bool force_sound = true;   ///< make the continuous force sound ready
    double master_gain = 1.0;  ///< 0 to 1, multiplies everything
};

/// A sound that is made while it is heard.
class SoundStream {
  public:
    SoundStream() = default;
    SoundStream(const SoundStream&) = delete;
    SoundStream& operator=(const SoundStream&) = delete;
    virtual ~SoundStream() = default;

    /// The next samples, all of them: mono, kSampleRate_Hz, -1 to 1. Called on the player's thread, or on one
    /// that lives no longer than the stream is set.
    virtual void render(std::span<float> samples) noexcept = 0;
};

/// Something that plays sounds.
class SoundPlayer {
  public:
    virtual ~SoundPlayer() = default;
    SoundPlayer() = default;
    SoundPlayer(const SoundPlayer&) = delete;
    SoundPlayer& operator=(const SoundPlayer&) = delete;

    /// Starts a sound. `gain` 0 to 1 (linear amplitude), `pitch` 0.25 to 4 (1 is as made). An
    /// unknown or unopened name and a number out of range are errors; nothing is played then. When
    /// all voices are busy the oldest gives way.
    virtual Expected<void> play(std::string_view name, double gain, double pitch) = 0;

    /// Starts a sound as it was made.
    Expected<void> play(std::string_view name) { return play(name, 1.0, 1.0); }

    /// The force that should be heard, newtons; 0 is silence. Not finite or negative counts as 0.
    virtual void set_force_sound(double force_N) = 0;

    /// Of all that is heard from now on, 0 to 1, times the master's; another number counts as the nearest of these, none as 1.
    virtual void set_volume(double gain) = 0;

    /// Plays `stream` from now on, until another, or none (null), is given; it outlives that. What a stream needs is made
    /// with it and goes with it.
    virtual void set_stream(SoundStream* stream) = 0;

    /// Says what somebody speaks: mono, kSampleRate_Hz, -1 to 1. What is being said ends at once.
    virtual void speak(std::span<const float> samples) = 0;
    /// What is being said fades out (20 ms of updates).
    virtual void hush() = 0;
    /// Until all of it has been heard.
    [[nodiscard]] virtual bool is_speaking() const = 0;

    /// Advances ramps by `dt_s` seconds; call it 60 to 100 times a second.
    virtual void update(double dt_s) = 0;

    /// Lets everything fade out (20 ms of updates), what is said too, and sets the force sound to silence.
    virtual void stop() = 0;

    /// False when nothing can be heard: the null player, or one whose sound card is gone.
    [[nodiscard]] virtual bool audible() const = 0;

    /// What a person should know of the sound card, a sentence, once; empty when there is nothing new.
    [[nodiscard]] virtual std::string take_notice() { return {}; }
};

}  // namespace fulcrum::runtime
