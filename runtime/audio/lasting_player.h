// A player that outlives its sound card: where that is unplugged, or its server ends, the lesson goes on in silence, and with sound again once
// there is a card.
//
//   heard   --the card is gone-->   silent, told once   --a card opens, tried after 2 s, 4 s … 60 s-->   heard, told
//
// Thread: as SoundPlayer. Cost: that of the player; a look at the card twice a second; a try to open one, as long as the sound system takes.
#pragma once

#include "runtime/audio/sound_player.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace fulcrum::runtime {

class LastingPlayer final : public SoundPlayer {
  public:
    using Open = std::function<Expected<std::unique_ptr<SoundPlayer>>()>;

    /// `heard` plays until its card is gone, then `silent`; `open` opens another.
    LastingPlayer(std::unique_ptr<SoundPlayer> heard, std::unique_ptr<SoundPlayer> silent,
                  Open open)
        : heard_(std::move(heard)), silent_(std::move(silent)), open_(std::move(open)) {}

    using SoundPlayer::play;
    Expected<void> play(std::string_view name, double gain, double pitch) override {
        return player().play(name, gain, pitch);
    }
    void set_force_sound(double force_N) override { player().set_force_sound(force_N); }
    void set_volume(double gain) override;
    void set_stream(SoundStream* stream) override;
    void speak(std::span<const float> samples) override { player().speak(samples); }
    void hush() override { player().hush(); }
    [[nodiscard]] bool is_speaking() const override {
        return heard_ != nullptr && heard_->is_speaking();
    }
    void update(double dt_s) override;
    void stop() override { player().stop(); }
    [[nodiscard]] bool audible() const override { return heard_ != nullptr; }
    [[nodiscard]] std::string take_notice() override { return std::exchange(notice_, {}); }

  private:
    [[nodiscard]] SoundPlayer& player() const { return heard_ ? *heard_ : *silent_; }
    void look_for_card();
    void try_again();

    std::unique_ptr<SoundPlayer> heard_;  // null while there is no card
    std::unique_ptr<SoundPlayer> silent_;
    Open open_;
    SoundStream* stream_ = nullptr;
    double volume_ = 1.0;
    std::string notice_;
    double since_s_ = 0.0;  // the last look at the card, or try to open one
    double wait_s_ = 0.0;   // before the next try
};

}  // namespace fulcrum::runtime
