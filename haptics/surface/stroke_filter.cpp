#include "haptics/surface/stroke_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace fulcrum {
namespace {

constexpr double kCutoff = 0.5 * (kStrokePass + kStrokeStop);
// Kaiser's rule for 48 dB: 0.5842 (48 - 21)^0.4 + 0.07886 (48 - 21).
constexpr double kShape = 4.31;
constexpr int kSeriesTerms = 20;  // of I0 up to 5: the last is below 1e-16
constexpr std::size_t kMostWeights = 2 * kStrokeReach * kMostPerRound + 1;

double bessel_i0(double x) {
    double term = 1.0;
    double sum = 1.0;
    for (int k = 1; k <= kSeriesTerms; ++k) {
        term *= 0.25 * x * x / (k * k);
        sum += term;
    }
    return sum;
}

struct Table {
    std::array<std::array<double, kMostWeights>, kMostPerRound> weights{};

    Table() {
        for (int m = 1; m <= kMostPerRound; ++m) {
            fill(m, weights[static_cast<std::size_t>(m - 1)]);
        }
    }
    static void fill(int m, std::array<double, kMostWeights>& out) {
        double sum = 0.0;
        std::size_t at = 0;
        for (int j = -kStrokeReach * m; j <= kStrokeReach * m; ++j) {
            const double s = static_cast<double>(j) / m;  // rounds
            const double x = 2.0 * std::numbers::pi * kCutoff * s;
            const double ideal = j == 0 ? 1.0 : std::sin(x) / x;
            const double side = s / kStrokeReach;
            const double window = bessel_i0(kShape * std::sqrt(1.0 - side * side));
            out[at] = ideal * window;
            sum += out[at++];
        }
        for (double& weight : out) {
            weight /= sum;
        }
    }
};

const Table kTable;

}  // namespace

std::span<const double> stroke_weights(int per_round) noexcept {
    const int m = std::clamp(per_round, 1, kMostPerRound);
    return {kTable.weights[static_cast<std::size_t>(m - 1)].data(),
            std::size_t{2} * kStrokeReach * static_cast<std::size_t>(m) + 1};
}

int choose_samples_per_round(double waves) noexcept {
    if (!(waves > kStrokePass)) {
        return 0;
    }
    return static_cast<int>(
        std::min(std::ceil(waves + kStrokeStop), static_cast<double>(kMostPerRound)));
}

}  // namespace fulcrum
