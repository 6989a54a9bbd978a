#include "runtime/audio/waveform.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace fulcrum::runtime {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kEndRamp_s = 0.015;
/// Time constants after which a sound has fallen by 120 dB: nothing is left of it in 16 bits.
constexpr double kDecays = 13.8;

/// 0 at t <= 0, 1 from `length` on, smooth between.
double raised_cosine(double t, double length) {
    if (t >= length) {
        return 1.0;
    }
    return t <= 0.0 ? 0.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * t / length);
}

/// White noise in -1 to 1. Source: Marsaglia 2003, "Xorshift RNGs".
class WhiteNoise {
  public:
    explicit WhiteNoise(std::uint32_t seed) : state_(seed | 1U) {}
    double next() {
        state_ ^= state_ << 13;
        state_ ^= state_ >> 17;
        state_ ^= state_ << 5;
        return static_cast<double>(state_) / 2147483648.0 - 1.0;
    }

  private:
    std::uint32_t state_;
};

/// Band pass with unit gain at its centre: a state-variable filter, trapezoidal.
class BandPass {
  public:
    BandPass(double frequency_Hz, double quality)
        : g_(std::tan(std::numbers::pi * frequency_Hz / kSampleRate_Hz)), k_(1.0 / quality) {}

    double step(double in) {
        const double band = (state_[0] + g_ * (in - state_[1])) / (1.0 + g_ * (g_ + k_));
        const double low = state_[1] + g_ * band;
        state_[0] = 2.0 * band - state_[0];
        state_[1] = 2.0 * low - state_[1];
        return k_ * band;
    }

  private:
    double g_;
    double k_;
    double state_[2] = {0.0, 0.0};
};

}  // namespace

Waveform::Waveform(double duration_s)
    : samples_(static_cast<std::size_t>(std::lround(duration_s * kSampleRate_Hz)), 0.0) {}

template <class Signal>
void Waveform::mix(double start_s, double attack_s, double duration_s, Signal signal) {
    const auto at = [this](double t) {
        return std::min(samples_.size(), static_cast<std::size_t>(std::lround(t * kSampleRate_Hz)));
    };
    const std::size_t first = at(start_s);
    const std::size_t end = at(start_s + duration_s);
    for (std::size_t i = first; i < end; ++i) {
        const double t = static_cast<double>(i - first) / kSampleRate_Hz;
        samples_[i] += raised_cosine(t, attack_s) * signal(t);
    }
}

Waveform& Waveform::add(const Mode& mode, double start_s, double attack_s) {
    // a e^(-t/tau) e^(i 2 pi f t) turns and shrinks by the same complex factor at each sample.
    const double shrink = std::exp(-1.0 / (mode.decay_s * kSampleRate_Hz));
    const std::complex<double> factor =
        std::polar(shrink, kTwoPi * mode.frequency_Hz / kSampleRate_Hz);
    std::complex<double> state(mode.amplitude, 0.0);
    mix(start_s, attack_s, kDecays * mode.decay_s, [&](double /*t*/) {
        const double now = state.imag();
        state *= factor;
        return now;
    });
    return *this;
}

Waveform& Waveform::add(const Noise& noise, double start_s, double attack_s) {
    WhiteNoise white(noise.seed);
    BandPass band(noise.frequency_Hz, noise.quality);
    mix(start_s, attack_s, kDecays * noise.decay_s, [&](double t) {
        return noise.amplitude * std::exp(-t / noise.decay_s) * band.step(white.next());
    });
    return *this;
}

Waveform& Waveform::add(const Glide& glide, double start_s, double attack_s) {
    const double span_Hz = glide.from_Hz - glide.to_Hz;
    mix(start_s, attack_s, kDecays * glide.decay_s, [&](double t) {
        const double turns =
            glide.to_Hz * t + span_Hz * glide.glide_s * (1.0 - std::exp(-t / glide.glide_s));
        return glide.amplitude * std::exp(-t / glide.decay_s) * std::sin(kTwoPi * turns);
    });
    return *this;
}

Waveform& Waveform::add_note(double frequency_Hz, double decay_s, double amplitude,
                             double start_s) {
    constexpr double kAttack_s = 0.004;
    add(Mode{frequency_Hz, decay_s, amplitude}, start_s, kAttack_s);
    add(Mode{2.0 * frequency_Hz, 0.6 * decay_s, 0.12 * amplitude}, start_s, kAttack_s);
    add(Mode{4.0 * frequency_Hz, 0.25 * decay_s, 0.18 * amplitude}, start_s, kAttack_s);
    add(Mode{10.0 * frequency_Hz, 0.06 * decay_s, 0.05 * amplitude}, start_s, kAttack_s);
    return *this;
}

std::vector<float> Waveform::finish(double peak) const {
    std::vector<double> ramped = samples_;
    double highest = 0.0;
    for (std::size_t i = 0; i < ramped.size(); ++i) {
        const double left_s = static_cast<double>(ramped.size() - 1 - i) / kSampleRate_Hz;
        ramped[i] *= raised_cosine(left_s, kEndRamp_s);
        highest = std::max(highest, std::abs(ramped[i]));
    }
    const double gain = highest > 0.0 ? std::min(peak, kPeak) / highest : 0.0;
    std::vector<float> finished(ramped.size());
    std::transform(ramped.begin(), ramped.end(), finished.begin(),
                   [gain](double x) { return static_cast<float>(gain * x); });
    return finished;
}

}  // namespace fulcrum::runtime
