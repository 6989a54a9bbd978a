#include "runtime/hearing/power_spectrum.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

using namespace fulcrum::runtime;

namespace {

using Piece = std::array<double, kWindow>;

Piece tone(double lines, double amplitude, double phase_rad = 0.3) {
    Piece x{};
    for (std::size_t n = 0; n < x.size(); ++n) {
        x[n] = amplitude * std::cos(2.0 * std::numbers::pi * lines * static_cast<double>(n) /
                                        static_cast<double>(kTransform) +
                                    phase_rad);
    }
    return x;
}

}  // namespace

TEST_CASE("power spectrum: it is the sum of its definition, line by line") {
    std::mt19937 random(3);
    std::normal_distribution<double> value;
    Piece x{};
    std::ranges::generate(x, [&] { return value(random); });
    const PowerSpectrum power = compute_power(x);
    for (std::size_t k = 0; k < power.size(); k += 17) {
        double real = 0.0;
        double imaginary = 0.0;
        double window_power = 0.0;
        for (std::size_t n = 0; n < kWindow; ++n) {
            const double turn = 2.0 * std::numbers::pi * static_cast<double>(k * n) / kTransform;
            const double w = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi *
                                                  (static_cast<double>(n) + 0.5) / kWindow);
            real += w * x[n] * std::cos(turn);
            imaginary -= w * x[n] * std::sin(turn);
            window_power += w * w;
        }
        CHECK(power[k] ==
              Approx((real * real + imaginary * imaginary) / window_power).epsilon(1e-9));
    }
}

TEST_CASE("power spectrum: a tone is where it is, with the height that the window gives it") {
    // |sum of w a/2|² / sum of w²  =  (a/2 · n/2)² / (3n/8)  =  a² n / 6
    for (const double line : {32.0, 100.0, 200.0}) {
        const PowerSpectrum power = compute_power(tone(line, 0.5));
        const auto top = std::ranges::max_element(power);
        CHECK(top - power.begin() == static_cast<std::ptrdiff_t>(line));
        CHECK(*top == Approx(0.25 * kWindow / 6.0).epsilon(0.01));
        CHECK(power[static_cast<std::size_t>(line) + 20] < 1e-5 * *top);
    }
}

TEST_CASE("power spectrum: the mean over white noise is its variance; nothing has none") {
    std::mt19937 random(1);
    std::normal_distribution<double> value(0.0, 0.2);
    double sum = 0.0;
    constexpr int kPieces = 400;
    for (int i = 0; i < kPieces; ++i) {
        Piece x{};
        std::ranges::generate(x, [&] { return value(random); });
        const PowerSpectrum power = compute_power(x);
        sum += std::accumulate(power.begin(), power.end(), 0.0) / static_cast<double>(power.size());
    }
    CHECK(sum / kPieces == Approx(0.04).epsilon(0.02));
    const PowerSpectrum none = compute_power(Piece{});
    CHECK(std::ranges::all_of(none, [](double p) { return p == 0.0; }));
}
