// What sounds are built from: struck modes, noise, glides, notes. Mono, 48 kHz, pure functions of
// their arguments.
//
//   mode    x(t) = a e^(-t/tau) sin(2 pi f t)             one way in which a struck thing rings
//   noise   white noise through a resonator at f with quality q, times e^(-t/tau)
//   glide   x(t) = a e^(-t/tau) sin(2 pi (f1 t + (f0 - f1) T (1 - e^(-t/T))))   from f0 to f1 with
//   time constant T
//
// Source: van den Doel & Pai 1998, "The Sounds of Physical Shapes" (modes of a struck body).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fulcrum::runtime {

/// Samples a second of everything in this folder.
inline constexpr int kSampleRate_Hz = 48'000;
/// Highest magnitude of a finished sound: 3 dB below full scale.
inline constexpr double kPeak = 0.7079;

struct Mode {
    double frequency_Hz;  ///< below half the sample rate
    double decay_s;       ///< time to 1/e
    double amplitude;     ///< before the sound is brought to its peak
};

struct Noise {
    double frequency_Hz;  ///< centre of the band
    double quality;       ///< centre over width; 0.5 is broad
    double decay_s;
    double amplitude;
    std::uint32_t seed;  ///< same seed, same noise
};

struct Glide {
    double from_Hz;
    double to_Hz;
    double glide_s;  ///< time constant of the change
    double decay_s;
    double amplitude;
};

/// A sound while it is being made.
class Waveform {
  public:
    /// Silence of `duration_s`.
    explicit Waveform(double duration_s);

    /// Each adds its sound from `start_s` on, with an attack of `attack_s` (raised cosine).
    Waveform& add(const Mode& mode, double start_s = 0.0, double attack_s = 0.001);
    Waveform& add(const Noise& noise, double start_s = 0.0, double attack_s = 0.001);
    Waveform& add(const Glide& glide, double start_s = 0.0, double attack_s = 0.001);
    /// A note as of a wooden bar: partials at 1, 4 and 10 times its pitch, the high ones short.
    Waveform& add_note(double frequency_Hz, double decay_s, double amplitude, double start_s);

    /// Ramps the last 15 ms to zero and brings the highest magnitude to `peak` (at most kPeak).
    [[nodiscard]] std::vector<float> finish(double peak) const;

  private:
    template <class Signal>
    void mix(double start_s, double attack_s, double duration_s, Signal signal);

    std::vector<double> samples_;
};

}  // namespace fulcrum::runtime
