#include "dialogue/speech/sphinx/noise_floor.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

constexpr double kRate_Hz = 16'000.0;

// Two seconds of tones with pauses, over white noise so far below their root mean square; `share`: of the time that is tone.
std::vector<std::int16_t> sound(double noise_dB, double share) {
    constexpr double kLoud = 8000.0;
    const double voice_rms = kLoud / std::numbers::sqrt2 * std::sqrt(share);
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0.0, voice_rms * std::pow(10.0, -noise_dB / 20.0));
    std::vector<std::int16_t> samples;
    for (int i = 0; i < 32'000; ++i) {
        const double within = std::fmod(i / kRate_Hz, 0.5) / 0.5;
        const double tone =
            within < share ? kLoud * std::sin(2.0 * std::numbers::pi * 300.0 * i / kRate_Hz) : 0.0;
        samples.push_back(static_cast<std::int16_t>(std::lround(tone + noise(random))));
    }
    return samples;
}

}  // namespace

TEST_CASE("room: noise of a known level is found within two decibels, however long the pauses") {
    for (const double share : {0.3, 0.6, 0.8}) {
        for (const double dB : {10.0, 20.0, 30.0, 40.0}) {
            CAPTURE(share, dB);
            // The quietest of some frames are a little below their mean.
            CHECK(room_below_voice_dB(sound(dB, share)) == Approx(dB).margin(2.0));
        }
    }
}

TEST_CASE(
    "room: silence between words is a silent room; noise alone, and nothing, have no voice above "
    "or no room below") {
    CHECK(room_below_voice_dB(sound(200.0, 0.5)) == kSilentRoom_dB);
    CHECK(room_below_voice_dB({}) == kSilentRoom_dB);
    CHECK(room_below_voice_dB(std::vector<std::int16_t>(100, 3000)) == kSilentRoom_dB);
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 1000.0);
    std::vector<std::int16_t> hiss;
    for (int i = 0; i < 32'000; ++i) {
        hiss.push_back(static_cast<std::int16_t>(std::lround(noise(random))));
    }
    CHECK(room_below_voice_dB(hiss) == 0.0);
    CHECK(room_below_voice_dB(std::vector<std::int16_t>(32'000, 32767)) == 0.0);
}
