// What a stroke and a tap sound like, out of the same signals that made the force.
//
//   stroke   s(t) = G_stroke n(F) dh/dt        h: felt relief under the hand, metres; F: how hard it is pressed
//            dh/dt at the audio rate is the slope of the cubic through the haptic rounds' heights (Catmull-Rom); a relief of
//            wavelength L that is stroked at v sounds at v / L, louder the faster, and a smooth surface not at all
//   tap      s(t) = sum A_i exp(-B_i t) sin(2 pi f_i t)      A = v / v_full, at most 1; f, B: the material's, from its force
//   n(F) = F / (F + F_half);   what is heard is limited to 1 softly, x / sqrt(1 + x^2)
//
// Rounds come through a ring, stamped on the run's clock; sound runs touch_delay_s behind them, so that the height after the
// next is there before it is heard. When nothing comes for longer, the surface is as if left.
//
// Thread: whichever fills the player's queue; one at a time. Cost: some 20 ns a sample, and as much for each tap that still rings. No allocation in `render`.
// Source: K. van den Doel, P. G. Kry, D. K. Pai 2001, FoleyAutomatic: physically-based sound effects for interactive
// simulation and animation, SIGGRAPH 2001 (a contact's force drives the sound; a tap scales with the impact).
#pragma once

#include "haptics/handover/touch_sample.h"
#include "haptics/surface/transient_settings.h"
#include "runtime/audio/sound_player.h"
#include "runtime/audio/waveform.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum::runtime {

/// How far sound runs behind touch when it is made in pieces of so many samples: a piece is made at once, and beyond its end
/// there have to be two rounds and what threads are late.
inline constexpr double kTouchMargin_s = 0.005;
[[nodiscard]] constexpr double touch_delay_s(std::size_t n_samples) noexcept {
    return static_cast<double>(n_samples) / kSampleRate_Hz + kTouchMargin_s;
}
/// Taps that ring at once; the quietest gives way.
inline constexpr std::size_t kRingingTaps = 8;

/// How one solid answers a tap, in the plan's order of solids.
struct TapTone {
    double frequency_Hz = 0.0;  ///< 0: a tap is not heard
    double decay_per_s = 100.0;
};
/// The tone of a force's ringing; a pulse is a knock at the frequency of its length.
[[nodiscard]] TapTone tone_of(const TransientSettings& transient) noexcept;

class TouchSound final : public SoundStream {
  public:
    /// One tone a solid of the plan; `touches` outlives this. `round_s` is the time between two haptic rounds.
    TouchSound(TouchRing& touches, std::vector<TapTone> tones, double round_s);

    /// Takes in what has been felt, and makes the next samples.
    void render(std::span<float> samples) noexcept override;

  private:
    struct Moment {
        double time_s = 0.0;
        double height_m = 0.0;
        double loudness = 0.0;  ///< n(F); 0 where nothing is touched
    };
    struct Tap {
        double begins_s = 0.0;
        double amplitude = 0.0;
        double frequency_Hz = 0.0;
        double decay_per_s = 0.0;
    };

    void take_in(std::size_t n_samples) noexcept;
    void keep(const TouchSample& sample) noexcept;
    void begin_tap(const TouchSample& sample) noexcept;
    [[nodiscard]] const Moment& moment(std::size_t i) const noexcept;
    [[nodiscard]] double stroke_at(double time_s) noexcept;
    [[nodiscard]] double taps_at(double time_s) noexcept;

    TouchRing& touches_;
    std::vector<TapTone> tones_;
    double round_s_;
    // The last rounds, oldest first, from `first_` on; what is heard lies between the second and the third.
    std::array<Moment, 256> moments_{};
    std::size_t first_ = 0;
    std::size_t n_moments_ = 0;
    std::array<Tap, kRingingTaps> taps_{};
    double now_s_ = 0.0;     // what is heard next
    double newest_s_ = 0.0;  // what was felt last
    bool runs_ = false;      // `now_s_` means something
};

}  // namespace fulcrum::runtime
