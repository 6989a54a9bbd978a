// Whether somebody speaks, block after block of 10 ms.
//
//   P_b      power of the last 25 ms in band b, kBands bands of equal width in mel from 100 to 7000 Hz
//   N_b      noise: kBias x the least of P_b, smoothed over 50 ms, in the last 1.5 s; never below kQuietest
//   γ_b = P_b / N_b                               how far above the noise it is
//   ξ_b = a G_b² γ_b' + (1 - a) max(γ_b - 1, 0)   the same as believed, ' of the block before, G_b = ξ_b' / (1 + ξ_b')
//   Λ   = mean over b of γ_b ξ_b / (1 + ξ_b) - ln(1 + ξ_b)      how much likelier speech is than noise, its logarithm a band
// Speech is where Λ is above the threshold. A noise that begins, a fan, is noise after 1.5 s, and sooner when it is broken.
//
// Thread: one. Cost: one transform (power_spectrum.h) a block.
// Source: J. Sohn, N. S. Kim, W. Sung 1999, A statistical model-based voice activity detection, IEEE Signal Processing Letters 6(1),
//   equations 4 to 6; Y. Ephraim, D. Malah 1984, Speech enhancement using a minimum mean-square error short-time spectral amplitude
//   estimator, IEEE Trans. ASSP 32(6), equation 51 (ξ); R. Martin 2001, Noise power spectral density estimation based on optimal
//   smoothing and minimum statistics, IEEE Trans. Speech and Audio Processing 9(5), section II (N).
#pragma once

#include "haptics/base/error.h"
#include "runtime/hearing/power_spectrum.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace fulcrum::runtime {

inline constexpr std::size_t kBlock = 160;  ///< samples: 10 ms at dialogue::kHeardRate_Hz
inline constexpr double kBlock_s = 0.01;

struct VoiceActivitySettings {
    double threshold = 0.3;  ///< of Λ, 0.01 to 100
};

[[nodiscard]] Expected<void> validate(const VoiceActivitySettings& settings);

class VoiceActivity {
  public:
    /// The settings have been validated.
    explicit VoiceActivity(const VoiceActivitySettings& settings) : settings_(settings) {}

    /// Takes in the next block; true where it is speech. Says so of nothing in the first fifth of a second.
    bool step(std::span<const std::int16_t, kBlock> block);
    /// Λ of the last block.
    [[nodiscard]] double likelihood() const { return likelihood_; }

    static constexpr std::size_t kBands = 20;

  private:
    using Bands = std::array<double, kBands>;
    static constexpr std::size_t kSpans = 6;  // of a quarter of a second, whose minima are kept

    void follow_noise(const Bands& power, bool is_first);

    VoiceActivitySettings settings_;
    std::array<double, kWindow> heard_{};  // the last 25 ms, -1 to 1
    Bands smooth_{};
    Bands noise_{};
    Bands believed_{};  // G² γ of the block before
    std::array<Bands, kSpans> least_{};
    std::size_t n_spans_ = 1;  // of `least_`, as far as there are any
    std::size_t span_ = 0;     // the one of now
    int blocks_ = 0;
    double likelihood_ = 0.0;
};

}  // namespace fulcrum::runtime
