// Sounds for the tests of hearing: noise, silence, sentences said by flite.
#pragma once

#include "dialogue/speech/word_graph.h"
#include "runtime/audio/resample.h"
#include "runtime/audio/voice/voice_program.h"
#include "runtime/audio/wav.h"
#include "runtime/files/run_program.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

namespace fulcrum::runtime::test {

using Samples = std::vector<std::int16_t>;

inline Samples silence(double time_s) {
    return Samples(static_cast<std::size_t>(time_s * dialogue::kHeardRate_Hz), 0);
}

/// White, of that root mean square of full scale; the same each time.
inline Samples noise(double time_s, double rms, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> value(0.0, 32767.0 * rms);
    Samples samples = silence(time_s);
    std::ranges::generate(samples, [&] {
        return static_cast<std::int16_t>(std::lround(std::clamp(value(random), -32768.0, 32767.0)));
    });
    return samples;
}

/// By a throat so many times smaller than a grown-up's: pitch and formants so much higher, the words as quick.
inline Samples said(std::string_view text, double smaller = 1.0) {
    const std::atomic<bool> never{false};
    const auto wav =
        run_program({make_voice_words({.speed = 1.0 / smaller}, text), 10'000'000, 20.0}, never);
    REQUIRE(wav);
    const auto sound = read_wav(*wav);
    REQUIRE(sound);
    const auto rate_Hz = static_cast<int>(std::lround(smaller * sound->rate_Hz));
    return to_pcm16(resample(sound->samples, rate_Hz, dialogue::kHeardRate_Hz));
}

inline Samples joined(std::initializer_list<Samples> parts) {
    Samples all;
    for (const Samples& part : parts) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

/// Both at once; as long as `a`.
inline Samples added(Samples a, const Samples& b) {
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        a[i] = static_cast<std::int16_t>(std::clamp(a[i] + b[i], -32768, 32767));
    }
    return a;
}

inline double seconds_of(const Samples& samples) {
    return static_cast<double>(samples.size()) / dialogue::kHeardRate_Hz;
}

}  // namespace fulcrum::runtime::test
