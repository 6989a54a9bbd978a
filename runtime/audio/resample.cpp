#include "runtime/audio/resample.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

namespace fulcrum::runtime {
namespace {

constexpr double kHalfWidth = 24.0;  // zeros of the sinc
constexpr double kBeta = 8.0;        // Kaiser's: 80 dB
constexpr double kCutOff = 0.92;     // of the lower half rate
constexpr int kSteps = 512;          // of the table between two zeros

// By its series: sum of ((x/2)^k / k!)^2.
double bessel_I0(double x) {
    double term = 1.0;
    double sum = 1.0;
    for (int k = 1; term > 1.0e-12 * sum; ++k) {
        term *= 0.25 * x * x / static_cast<double>(k * k);
        sum += term;
    }
    return sum;
}

// The windowed sinc by the number of zeros from its middle, linear in between.
std::vector<double> make_table() {
    const auto n = static_cast<std::size_t>(kHalfWidth) * kSteps;
    std::vector<double> table(n + 2, 0.0);
    for (std::size_t i = 0; i <= n; ++i) {
        const double z = static_cast<double>(i) / kSteps;
        const double share = z / kHalfWidth;
        const double window =
            bessel_I0(kBeta * std::sqrt(std::max(1.0 - share * share, 0.0))) / bessel_I0(kBeta);
        const double angle = std::numbers::pi * z;
        table[i] = window * (i == 0 ? 1.0 : std::sin(angle) / angle);
    }
    return table;
}

}  // namespace

std::vector<float> resample(std::span<const float> x, int from_Hz, int to_Hz) {
    if (from_Hz == to_Hz || x.empty()) {
        return {x.begin(), x.end()};
    }
    static const std::vector<double> kTable = make_table();
    const double ratio = static_cast<double>(from_Hz) / to_Hz;
    // Zeros a sample of x.
    const double zeros = kCutOff * std::min(1.0, 1.0 / ratio);
    const double reach = kHalfWidth / zeros;
    const auto n_out =
        static_cast<std::size_t>(std::llround(static_cast<double>(x.size()) * to_Hz / from_Hz));
    std::vector<float> y(n_out);
    for (std::size_t i = 0; i < n_out; ++i) {
        const double t = static_cast<double>(i) * ratio;
        const auto first = static_cast<std::int64_t>(std::ceil(std::max(t - reach, 0.0)));
        const auto last = static_cast<std::int64_t>(
            std::floor(std::min(t + reach, static_cast<double>(x.size() - 1))));
        double sum = 0.0;
        for (std::int64_t k = first; k <= last; ++k) {
            const double at = std::abs(t - static_cast<double>(k)) * zeros * kSteps;
            const auto cell = static_cast<std::size_t>(at);
            const double share = at - static_cast<double>(cell);
            sum += static_cast<double>(x[static_cast<std::size_t>(k)]) *
                   (kTable[cell] + share * (kTable[cell + 1] - kTable[cell]));
        }
        y[i] = static_cast<float>(zeros * sum);
    }
    return y;
}

}  // namespace fulcrum::runtime
