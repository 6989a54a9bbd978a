// A player that makes no sound and counts what it was asked for: for --mute, for machines without a
// sound card, for tests. It refuses the same calls as a real one.
#pragma once

#include "runtime/audio/sound_player.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace fulcrum::runtime {

class NullPlayer final : public SoundPlayer {
  public:
    /// Knows the names in the settings; an unknown name there is an error.
    [[nodiscard]] static Expected<std::unique_ptr<NullPlayer>> open(const SoundSettings& settings);

    Expected<void> play(std::string_view name, double gain, double pitch) override;
    void set_force_sound(double force_N) override;
    void set_volume(double /*gain*/) override {}
    void set_stream(SoundStream* stream) override { stream_ = stream; }
    /// Says it in no time.
    void speak(std::span<const float> samples) override { n_spoken_ += samples.empty() ? 0U : 1U; }
    void hush() override {}
    [[nodiscard]] bool is_speaking() const override { return false; }
    void update(double dt_s) override;
    void stop() override;
    [[nodiscard]] bool audible() const override { return false; }

    /// How often a sound was played.
    [[nodiscard]] std::size_t plays(std::string_view name) const;
    /// How often something was said.
    [[nodiscard]] std::size_t n_spoken() const { return n_spoken_; }
    /// The force that would be heard now, newtons.
    [[nodiscard]] double force_N() const { return force_N_; }
    /// The stream that would be heard now, or null.
    [[nodiscard]] const SoundStream* stream() const { return stream_; }

  private:
    std::map<std::string, std::size_t, std::less<>> plays_;
    std::size_t n_spoken_ = 0;
    double force_N_ = 0.0;
    SoundStream* stream_ = nullptr;
};

}  // namespace fulcrum::runtime
