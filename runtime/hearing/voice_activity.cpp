#include "runtime/hearing/voice_activity.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {
namespace {

constexpr double kLowest_Hz = 100.0;
constexpr double kHighest_Hz = 7000.0;
constexpr double kRate_Hz = static_cast<double>(kBlock) / kBlock_s;
constexpr double kSmooth = 0.8;     // of 10 ms: 50 ms
constexpr double kBias = 2.0;       // the mean of a noise over the least of 1.5 s, so smoothed
constexpr double kQuietest = 1e-7;  // variance, of full scale: 70 dB below it nobody speaks
constexpr double kBelief = 0.98;    // a: as Ephraim and Malah
constexpr int kSpan_blocks = 25;
constexpr int kWarmUp_blocks = 20;

double to_mel(double frequency_Hz) {
    return 2595.0 * std::log10(1.0 + frequency_Hz / 700.0);
}

// In which band each line of the spectrum lies; kBands: in none.
std::array<std::size_t, kTransform / 2 + 1> make_band_of_line() {
    std::array<std::size_t, kTransform / 2 + 1> band_of{};
    for (std::size_t k = 0; k < band_of.size(); ++k) {
        const double frequency_Hz = static_cast<double>(k) * kRate_Hz / kTransform;
        const double share = (to_mel(frequency_Hz) - to_mel(kLowest_Hz)) /
                             (to_mel(kHighest_Hz) - to_mel(kLowest_Hz));
        band_of[k] = share >= 0.0 && share < 1.0
                         ? static_cast<std::size_t>(share * VoiceActivity::kBands)
                         : VoiceActivity::kBands;
    }
    return band_of;
}

std::array<double, VoiceActivity::kBands> sum_up(const PowerSpectrum& power) {
    static const auto kBandOf = make_band_of_line();
    std::array<double, VoiceActivity::kBands> sum{};
    std::array<double, VoiceActivity::kBands> n{};
    for (std::size_t k = 0; k < power.size(); ++k) {
        if (kBandOf[k] < sum.size()) {
            sum[kBandOf[k]] += power[k];
            n[kBandOf[k]] += 1.0;
        }
    }
    for (std::size_t b = 0; b < sum.size(); ++b) {
        sum[b] /= std::max(n[b], 1.0);
    }
    return sum;
}

}  // namespace

Expected<void> validate(const VoiceActivitySettings& settings) {
    if (!(settings.threshold >= 0.01 && settings.threshold <= 100.0)) {
        return fail("the threshold above which something is speech is not from 0.01 to 100", {},
                    "give 0.3");
    }
    return {};
}

bool VoiceActivity::step(std::span<const std::int16_t, kBlock> block) {
    std::copy(heard_.begin() + kBlock, heard_.end(), heard_.begin());
    std::ranges::transform(block, heard_.end() - kBlock,
                           [](std::int16_t x) { return x / 32768.0; });
    constexpr int kWholeWindow_blocks = 3;
    if (++blocks_ < kWholeWindow_blocks) {
        return false;  // as quiet as nothing ever is
    }
    const Bands power = sum_up(compute_power(heard_));
    follow_noise(power, blocks_ == kWholeWindow_blocks);

    // How much likelier speech is, band by band.
    double sum = 0.0;
    for (std::size_t b = 0; b < kBands; ++b) {
        const double above = power[b] / noise_[b];
        const double ratio = kBelief * believed_[b] + (1.0 - kBelief) * std::max(above - 1.0, 0.0);
        const double gain = ratio / (1.0 + ratio);
        sum += above * gain - std::log1p(ratio);
        believed_[b] = gain * gain * above;
    }
    likelihood_ = sum / static_cast<double>(kBands);
    return blocks_ > kWarmUp_blocks && likelihood_ > settings_.threshold;
}

// The least of what was heard lately, as nobody speaks in all bands all the time.
void VoiceActivity::follow_noise(const Bands& power, bool is_first) {
    for (std::size_t b = 0; b < kBands; ++b) {
        smooth_[b] = is_first ? power[b] : kSmooth * smooth_[b] + (1.0 - kSmooth) * power[b];
    }
    if (is_first) {
        least_[span_] = smooth_;
    } else if (blocks_ % kSpan_blocks == 0) {
        span_ = (span_ + 1) % kSpans;
        n_spans_ = std::min(n_spans_ + 1, kSpans);
        least_[span_] = smooth_;
    }
    for (std::size_t b = 0; b < kBands; ++b) {
        least_[span_][b] = std::min(least_[span_][b], smooth_[b]);
        double least = least_[0][b];
        for (std::size_t i = 1; i < n_spans_; ++i) {
            least = std::min(least, least_[i][b]);
        }
        noise_[b] = std::max(kBias * least, kQuietest);
    }
}

}  // namespace fulcrum::runtime
