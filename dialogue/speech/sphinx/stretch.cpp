#include "dialogue/speech/sphinx/stretch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace fulcrum::dialogue {
namespace {

constexpr int kZeros = 8;

double sinc(double t) {
    const double angle = std::numbers::pi * t;
    return std::abs(angle) < 1.0e-9 ? 1.0 : std::sin(angle) / angle;
}

std::int16_t to_sample(double value) {
    constexpr double kLeast = std::numeric_limits<std::int16_t>::min();
    constexpr double kMost = std::numeric_limits<std::int16_t>::max();
    return static_cast<std::int16_t>(std::lround(std::clamp(value, kLeast, kMost)));
}

}  // namespace

std::vector<std::int16_t> stretch(std::span<const std::int16_t> sound, double factor) {
    const double slower = factor >= 1.0 ? std::min(factor, kMostStretch) : 1.0;
    if (slower == 1.0) {
        return {sound.begin(), sound.end()};
    }
    const auto n_sound = static_cast<std::ptrdiff_t>(sound.size());
    std::vector<std::int16_t> stretched(
        static_cast<std::size_t>(static_cast<double>(sound.size()) * slower));
    for (std::size_t n = 0; n < stretched.size(); ++n) {
        const double at = static_cast<double>(n) / slower;
        const auto middle = static_cast<std::ptrdiff_t>(at);
        double sum = 0.0;
        for (std::ptrdiff_t k = std::max<std::ptrdiff_t>(middle - kZeros + 1, 0);
             k <= std::min<std::ptrdiff_t>(middle + kZeros, n_sound - 1); ++k) {
            const double t = at - static_cast<double>(k);
            sum += sound[static_cast<std::size_t>(k)] * sinc(t) * sinc(t / kZeros);
        }
        stretched[n] = to_sample(sum);
    }
    return stretched;
}

}  // namespace fulcrum::dialogue
