#include "runtime/audio/resample.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

std::vector<float> make_tone(double frequency_Hz, int rate_Hz, double duration_s) {
    std::vector<float> x(static_cast<std::size_t>(duration_s * rate_Hz));
    for (std::size_t i = 0; i < x.size(); ++i) {
        x[i] = static_cast<float>(
            std::sin(2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / rate_Hz));
    }
    return x;
}

// What is left of a sound without the tone of its own frequency, over the middle half: root mean square, and the tone's height.
std::pair<double, double> part_tone(const std::vector<float>& x, double frequency_Hz, int rate_Hz) {
    const std::size_t first = x.size() / 4;
    const std::size_t n = x.size() / 2;
    // Least squares over whole and broken waves alike: sine and cosine.
    double ss = 0.0, sc = 0.0, cc = 0.0, xs = 0.0, xc = 0.0;
    const auto angle = [&](std::size_t i) {
        return 2.0 * std::numbers::pi * frequency_Hz * static_cast<double>(i) / rate_Hz;
    };
    for (std::size_t i = first; i < first + n; ++i) {
        const double s = std::sin(angle(i)), c = std::cos(angle(i));
        ss += s * s, sc += s * c, cc += c * c;
        xs += static_cast<double>(x[i]) * s, xc += static_cast<double>(x[i]) * c;
    }
    const double det = ss * cc - sc * sc;
    const double a = (xs * cc - xc * sc) / det, b = (xc * ss - xs * sc) / det;
    double rest = 0.0;
    for (std::size_t i = first; i < first + n; ++i) {
        const double left =
            static_cast<double>(x[i]) - a * std::sin(angle(i)) - b * std::cos(angle(i));
        rest += left * left;
    }
    return {std::sqrt(rest / static_cast<double>(n)), std::hypot(a, b)};
}

}  // namespace

TEST_CASE("resample: a tone stays that tone, as high, and nothing else is heard") {
    for (const auto& [from_Hz, to_Hz] :
         {std::pair(16000, 48000), {22050, 48000}, {48000, 16000}, {44100, 48000}, {8000, 48000}}) {
        const double half_Hz = 0.5 * std::min(from_Hz, to_Hz);
        for (const double share : {0.01, 0.2, 0.5, 0.8}) {
            const double frequency_Hz = share * half_Hz;
            const auto y = resample(make_tone(frequency_Hz, from_Hz, 0.2), from_Hz, to_Hz);
            CAPTURE(from_Hz, to_Hz, frequency_Hz);
            CHECK(y.size() == static_cast<std::size_t>(std::lround(0.2 * to_Hz)));
            const auto [rest, height] = part_tone(y, frequency_Hz, to_Hz);
            CHECK(height == Approx(1.0).margin(1.0e-3));
            CHECK(rest < 3.0e-4);  // 70 dB
        }
    }
}

TEST_CASE("resample: what the lower rate cannot hold is left out, not folded back") {
    const auto y = resample(make_tone(9500.0, 48000, 0.2), 48000, 16000);
    double most = 0.0;
    for (std::size_t i = y.size() / 4; i < 3 * y.size() / 4; ++i) {
        most = std::max(most, std::abs(static_cast<double>(y[i])));
    }
    CHECK(most < 1.0e-3);
}

TEST_CASE("resample: the same rate gives the same samples; nothing gives nothing") {
    const auto x = make_tone(440.0, 16000, 0.01);
    CHECK(resample(x, 16000, 16000) == x);
    CHECK(resample({}, 16000, 48000).empty());
    const std::array<float, 1> one{0.5F};
    CHECK(resample(one, 16000, 48000).size() == 3);
}
