#include "haptics/math/spectral_radius.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

namespace fulcrum {

double compute_spectral_radius(std::span<const double> A, std::size_t n) {
    assert(A.size() == n * n);
    constexpr int kSquarings = 40;
    std::vector<double> power(A.begin(), A.end());
    std::vector<double> square(n * n);
    double log_radius = 0.0;
    double share = 1.0;
    for (int i = 0; i <= kSquarings; ++i) {
        double length = 0.0;
        for (const double number : power) {
            if (!std::isfinite(number)) {
                return std::numeric_limits<double>::infinity();
            }
            length = std::max(length, std::abs(number));
        }
        if (length == 0.0) {
            return 0.0;
        }
        log_radius += share * std::log(length);
        share *= 0.5;
        for (double& number : power) {
            number /= length;
        }
        std::ranges::fill(square, 0.0);
        for (std::size_t column = 0; column < n; ++column) {
            for (std::size_t k = 0; k < n; ++k) {
                const double by = power[k + column * n];
                for (std::size_t row = 0; row < n; ++row) {
                    square[row + column * n] += power[row + k * n] * by;
                }
            }
        }
        power.swap(square);
    }
    return std::exp(log_radius);
}

}  // namespace fulcrum
