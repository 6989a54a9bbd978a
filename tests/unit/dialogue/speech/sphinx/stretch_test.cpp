#include "dialogue/speech/sphinx/stretch.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace fulcrum::dialogue;

namespace {

constexpr double kRate_Hz = 16000.0;

double tone_at(double n, double frequency_Hz) {
    return 10000.0 * std::sin(2.0 * std::numbers::pi * frequency_Hz * n / kRate_Hz);
}

std::vector<std::int16_t> tone(double frequency_Hz) {
    std::vector<std::int16_t> x(8000);
    for (std::size_t n = 0; n < x.size(); ++n) {
        x[n] =
            static_cast<std::int16_t>(std::lround(tone_at(static_cast<double>(n), frequency_Hz)));
    }
    return x;
}

}  // namespace

TEST_CASE("stretch: a tone comes down by the factor, as loud as it was, and lasts longer by it") {
    for (const double factor : {1.1, 1.25, 1.5, 2.0}) {
        for (const double frequency_Hz : {300.0, 1000.0, 4000.0}) {
            CAPTURE(factor, frequency_Hz);
            const auto y = stretch(tone(frequency_Hz), factor);
            CHECK(y.size() == static_cast<std::size_t>(8000.0 * factor));
            double worst = 0.0;
            for (std::size_t n = 200; n + 200 < y.size(); ++n) {
                worst = std::max(
                    worst, std::abs(y[n] - tone_at(static_cast<double>(n), frequency_Hz / factor)));
            }
            CHECK(worst < 0.01 * 10000.0);  // 40 dB below it
        }
    }
}

TEST_CASE("stretch: by one nothing changes; a factor out of its range is the nearest in it") {
    const auto x = tone(700.0);
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    for (const double none : {1.0, 0.5, -3.0, kNaN}) {
        CHECK(stretch(x, none) == x);
    }
    CHECK(stretch(x, 100.0) == stretch(x, kMostStretch));
    CHECK(stretch({}, 1.5).empty());
}

TEST_CASE("stretch: the loudest sound stays in range, and what stands still stands still") {
    std::vector<std::int16_t> edge(400, std::numeric_limits<std::int16_t>::min());
    std::fill(edge.begin() + 200, edge.end(), std::numeric_limits<std::int16_t>::max());
    const auto y = stretch(edge, 1.3);
    CHECK(y[100] < -32000);
    CHECK(y[420] > 32000);
    CHECK(*std::ranges::max_element(y) == std::numeric_limits<std::int16_t>::max());
}
