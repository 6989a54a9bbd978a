#include "runtime/hearing/power_spectrum.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace fulcrum::runtime {
namespace {

using Complex = std::complex<double>;
using Signal = std::array<Complex, kTransform>;

struct Tables {
    std::array<double, kWindow> window{};
    double window_power = 0.0;
    std::array<Complex, kTransform / 2> turns;  // exp(-2 pi i k / N)

    Tables() {
        for (std::size_t n = 0; n < kWindow; ++n) {
            const double share = (static_cast<double>(n) + 0.5) / static_cast<double>(kWindow);
            window[n] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * share);
            window_power += window[n] * window[n];
        }
        for (std::size_t k = 0; k < turns.size(); ++k) {
            turns[k] = std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(k) /
                                           static_cast<double>(kTransform));
        }
    }
};

// In the order of bits read backwards.
void reorder(Signal& x) {
    for (std::size_t i = 1, j = 0; i < kTransform; ++i) {
        std::size_t bit = kTransform >> 1U;
        for (; (j & bit) != 0; bit >>= 1U) {
            j ^= bit;
        }
        j ^= bit;
        if (i < j) {
            std::swap(x[i], x[j]);
        }
    }
}

// Two halves become one, twice as long each time.
void transform(Signal& x, const Tables& tables) {
    reorder(x);
    for (std::size_t length = 2; length <= kTransform; length *= 2) {
        const std::size_t half = length / 2;
        const std::size_t stride = kTransform / length;
        for (std::size_t from = 0; from < kTransform; from += length) {
            for (std::size_t k = 0; k < half; ++k) {
                const Complex odd = x[from + k + half] * tables.turns[k * stride];
                x[from + k + half] = x[from + k] - odd;
                x[from + k] += odd;
            }
        }
    }
}

}  // namespace

PowerSpectrum compute_power(std::span<const double, kWindow> x) {
    static const Tables kTables;
    Signal signal{};
    for (std::size_t n = 0; n < kWindow; ++n) {
        signal[n] = kTables.window[n] * x[n];
    }
    transform(signal, kTables);
    PowerSpectrum power{};
    for (std::size_t k = 0; k < power.size(); ++k) {
        power[k] = std::norm(signal[k]) / kTables.window_power;
    }
    return power;
}

}  // namespace fulcrum::runtime
