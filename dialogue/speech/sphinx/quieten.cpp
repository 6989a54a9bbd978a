#include "dialogue/speech/sphinx/quieten.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <numeric>

namespace fulcrum::dialogue {
namespace {

constexpr std::size_t kLength = 512;  // 32 ms at 16 kHz
constexpr std::size_t kStep = kLength / 2;
constexpr std::size_t kFewestFrames = 4;
constexpr std::size_t kRoomShare = 8;  // one frame in so many holds the room alone
constexpr double kTaken = 3.0;         // times the noise
constexpr double kLeft = 0.1;          // of a frame's power, at least

using Spectrum = std::vector<std::complex<double>>;

/// In place, radix 2 (Cooley and Tukey 1965); `sign` -1 forwards, +1 backwards without its 1/n.
void transform(Spectrum& x, double sign) {
    const std::size_t n = x.size();
    for (std::size_t i = 1, j = 0; i < n; ++i) {
        std::size_t bit = n >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) {
            j ^= bit;
        }
        j ^= bit;
        if (i < j) {
            std::swap(x[i], x[j]);
        }
    }
    for (std::size_t half = 1; half < n; half *= 2) {
        const double angle = sign * std::numbers::pi / static_cast<double>(half);
        for (std::size_t k = 0; k < half; ++k) {
            const auto turn = std::polar(1.0, angle * static_cast<double>(k));
            for (std::size_t i = k; i < n; i += 2 * half) {
                const std::complex<double> odd = turn * x[i + half];
                x[i + half] = x[i] - odd;
                x[i] += odd;
            }
        }
    }
}

/// Its square adds up to 1 over frames that lie half over each other.
double window(std::size_t i) {
    return std::sin(std::numbers::pi * (static_cast<double>(i) + 0.5) /
                    static_cast<double>(kLength));
}

std::vector<Spectrum> spectra_of(std::span<const std::int16_t> sound) {
    std::vector<Spectrum> frames;
    for (std::size_t at = 0; at + kLength <= sound.size(); at += kStep) {
        Spectrum& frame = frames.emplace_back(kLength);
        for (std::size_t i = 0; i < kLength; ++i) {
            frame[i] = window(i) * static_cast<double>(sound[at + i]);
        }
        transform(frame, -1.0);
    }
    return frames;
}

/// The power of the room alone, by frequency.
std::vector<double> noise_of(const std::vector<Spectrum>& frames) {
    std::vector<double> power;
    power.reserve(frames.size());
    for (const Spectrum& frame : frames) {
        power.push_back(std::accumulate(
            frame.begin(), frame.end(), 0.0,
            [](double sum, const std::complex<double>& x) { return sum + std::norm(x); }));
    }
    std::vector<std::size_t> order(frames.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return power[i]; });
    order.resize(std::max(frames.size() / kRoomShare, kFewestFrames));
    std::vector<double> noise(kLength, 0.0);
    for (const std::size_t i : order) {
        for (std::size_t k = 0; k < kLength; ++k) {
            noise[k] += std::norm(frames[i][k]) / static_cast<double>(order.size());
        }
    }
    return noise;
}

}  // namespace

std::vector<std::int16_t> quieten(std::span<const std::int16_t> sound) {
    // A frame of silence before and behind, so that every sample lies under two frames.
    std::vector<std::int16_t> padded(kStep, 0);
    padded.insert(padded.end(), sound.begin(), sound.end());
    padded.resize(padded.size() + kLength, 0);
    const std::vector<Spectrum> inside = spectra_of(sound);
    if (inside.size() < kFewestFrames) {
        return {sound.begin(), sound.end()};
    }
    const std::vector<double> noise = noise_of(inside);
    std::vector<double> sum(padded.size(), 0.0);
    std::size_t at = 0;
    for (Spectrum& frame : spectra_of(padded)) {
        for (std::size_t k = 0; k < kLength; ++k) {
            const double power = std::norm(frame[k]);
            const double share = power > 0.0 ? 1.0 - kTaken * noise[k] / power : kLeft;
            frame[k] *= std::sqrt(std::max(share, kLeft));
        }
        transform(frame, 1.0);
        for (std::size_t i = 0; i < kLength; ++i) {
            sum[at + i] += window(i) * frame[i].real() / static_cast<double>(kLength);
        }
        at += kStep;
    }
    std::vector<std::int16_t> quieter;
    for (std::size_t i = 0; i < sound.size(); ++i) {
        quieter.push_back(
            static_cast<std::int16_t>(std::lround(std::clamp(sum[kStep + i], -32768.0, 32767.0))));
    }
    return quieter;
}

}  // namespace fulcrum::dialogue
