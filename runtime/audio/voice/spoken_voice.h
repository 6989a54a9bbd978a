// A voice that is heard: what is said is made by a program (speech_maker.h) and played one after the other.
//
// The captions stay what a lesson waits for (dialogue/speech/captions): sound comes when it is made, 50 to 200 ms later, and a lesson
// runs alike with it or without. When more waits than is worth hearing, the oldest is left out: only the newest replies count.
//
// Thread: one, that of the player. Cost: `step` a lock; when a text is ready, its copy to the sound card, about 1 ms.
#pragma once

#include "dialogue/speech/voice.h"
#include "runtime/audio/sound_player.h"
#include "runtime/audio/voice/speech_maker.h"

#include <string_view>

namespace fulcrum::runtime {

class SpokenVoice final : public dialogue::Voice {
  public:
    /// The player outlives this.
    SpokenVoice(const VoiceSettings& settings, SoundPlayer& player)
        : settings_(settings), maker_(settings), player_(player) {}

    void say(std::string_view text) override;
    void step(double dt_s) override;
    void stop() override;
    [[nodiscard]] bool speaking() const override {
        return maker_.n_waiting() > 0 || player_.is_speaking();
    }
    [[nodiscard]] std::string_view name() const override { return name_of(settings_.kind); }

    /// Why nothing is heard, once; empty otherwise.
    [[nodiscard]] std::string take_trouble() { return maker_.take_trouble(); }

  private:
    VoiceSettings settings_;
    SpeechMaker maker_;
    SoundPlayer& player_;
};

}  // namespace fulcrum::runtime
