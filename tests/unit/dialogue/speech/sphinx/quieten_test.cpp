#include "dialogue/speech/sphinx/quieten.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <random>

using namespace fulcrum::dialogue;

namespace {

constexpr double kRate_Hz = 16'000.0;

std::vector<std::int16_t> made_of(std::size_t n, double tone, double noise) {
    std::mt19937 random(1);
    std::normal_distribution<double> room(0.0, 1.0);
    std::vector<std::int16_t> sound;
    for (std::size_t i = 0; i < n; ++i) {
        // A tone in the middle half, the room always.
        const bool speaks = i > n / 4 && i < 3 * n / 4;
        const double t = static_cast<double>(i) / kRate_Hz;
        const double x = (speaks ? tone * std::sin(2.0 * std::numbers::pi * 440.0 * t) : 0.0) +
                         noise * room(random);
        sound.push_back(static_cast<std::int16_t>(std::lround(x)));
    }
    return sound;
}

double power(const std::vector<std::int16_t>& sound, double from, double to) {
    double sum = 0.0;
    const auto n = static_cast<double>(sound.size());
    const auto first = static_cast<std::size_t>(from * n);
    const auto last = static_cast<std::size_t>(to * n);
    for (std::size_t i = first; i < last; ++i) {
        sum += static_cast<double>(sound[i]) * static_cast<double>(sound[i]);
    }
    return sum / static_cast<double>(last - first);
}

}  // namespace

TEST_CASE("quieten: what has no noise comes back, to the rounding") {
    const auto sound = made_of(16'000, 8000.0, 0.0);
    const auto same = quieten(sound);
    REQUIRE(same.size() == sound.size());
    for (std::size_t i = 0; i < sound.size(); ++i) {
        REQUIRE(std::abs(same[i] - sound[i]) <= 1);
    }
}

TEST_CASE("quieten: the room is lowered by 7 dB and more, and the voice is kept") {
    const auto sound = made_of(32'000, 8000.0, 560.0);  // 20 dB below the tone
    const auto quieter = quieten(sound);
    REQUIRE(quieter.size() == sound.size());
    CHECK(10.0 * std::log10(power(sound, 0.02, 0.22) / power(quieter, 0.02, 0.22)) > 7.0);
    // The tone has 32e6, and of the noise in it little is left.
    CHECK(std::abs(10.0 * std::log10(power(quieter, 0.3, 0.7) / 32.0e6)) < 0.2);
    // What is left is nearer to the tone than what was there.
    const auto clean = made_of(32'000, 8000.0, 0.0);
    const auto apart = [&](const std::vector<std::int16_t>& other) {
        double sum = 0.0;
        for (std::size_t i = 0; i < clean.size(); ++i) {
            sum += std::pow(static_cast<double>(other[i]) - static_cast<double>(clean[i]), 2);
        }
        return sum;
    };
    CHECK(apart(quieter) < 0.25 * apart(sound));
}

TEST_CASE("quieten: silence, what is short, the loudest and nothing at all") {
    CHECK(quieten({}).empty());
    for (const std::size_t n : {std::size_t{1}, std::size_t{511}, std::size_t{1279}}) {
        const auto sound = made_of(n, 8000.0, 100.0);
        CHECK(quieten(sound) == sound);
    }
    const std::vector<std::int16_t> silence(4000, 0);
    CHECK(quieten(silence) == silence);
    std::vector<std::int16_t> loudest(8000, std::numeric_limits<std::int16_t>::min());
    for (std::size_t i = 0; i < loudest.size(); i += 3) {
        loudest[i] = std::numeric_limits<std::int16_t>::max();
    }
    CHECK(quieten(loudest).size() == loudest.size());
}
