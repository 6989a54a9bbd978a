// What is heard, in numbers: loudness, steps and lines of a sound.
#pragma once

#include "runtime/audio/waveform.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <vector>

namespace fulcrum::runtime::test {

using Sound = std::span<const float>;

inline constexpr double kFrame_s = 0.01;
inline constexpr std::size_t kFrame = 480;  ///< samples

inline Sound piece(Sound sound, double from_s, double to_s) {
    const auto at = [](double s) { return static_cast<std::size_t>(s * kSampleRate_Hz); };
    return sound.subspan(at(from_s), std::min(at(to_s), sound.size()) - at(from_s));
}

/// No number where one of the samples is none.
inline float loudest(Sound sound) {
    float most = 0.0F;
    for (const float x : sound) {
        most = std::isfinite(x) && !std::isnan(most) ? std::max(most, std::abs(x)) : NAN;
    }
    return most;
}

/// The sum of squares.
inline double energy(Sound sound) {
    double sum = 0.0;
    for (const float x : sound) {
        sum += static_cast<double>(x) * static_cast<double>(x);
    }
    return sum;
}

inline double rms(Sound sound) {
    return sound.empty() ? 0.0 : std::sqrt(energy(sound) / static_cast<double>(sound.size()));
}

/// From one sample to the next of the same channel.
inline float largest_step(Sound sound, std::size_t n_channels) {
    float largest = 0.0F;
    for (std::size_t i = n_channels; i < sound.size(); ++i) {
        largest = std::max(largest, std::abs(sound[i] - sound[i - n_channels]));
    }
    return largest;
}

/// Amplitude of the sine of that frequency, Hann window.
inline double line(Sound sound, double frequency_Hz) {
    std::complex<double> sum = 0.0;
    const auto n = static_cast<double>(sound.size());
    for (std::size_t i = 0; i < sound.size(); ++i) {
        const double x = static_cast<double>(i);
        const double window = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * x / n);
        sum += window * static_cast<double>(sound[i]) *
               std::polar(1.0, -2.0 * std::numbers::pi * frequency_Hz * x / kSampleRate_Hz);
    }
    return 4.0 * std::abs(sum) / n;
}

/// The strongest line between two frequencies, to a hertz.
inline double strongest_Hz(Sound sound, double from_Hz, double to_Hz) {
    double best_Hz = from_Hz;
    double most = 0.0;
    for (double f = from_Hz; f <= to_Hz; f += 1.0) {
        const double amplitude = line(sound, f);
        best_Hz = amplitude > most ? f : best_Hz;
        most = std::max(most, amplitude);
    }
    return best_Hz;
}

}  // namespace fulcrum::runtime::test
