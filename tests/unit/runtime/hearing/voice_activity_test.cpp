#include "runtime/hearing/voice_activity.h"

#include "tests/unit/runtime/hearing/sounds.h"

#include <limits>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

// Block by block, whether it is speech.
std::vector<bool> listen_to(const Samples& samples) {
    VoiceActivity activity({});
    std::vector<bool> is_speech;
    for (std::size_t at = 0; at + kBlock <= samples.size(); at += kBlock) {
        is_speech.push_back(
            activity.step(std::span<const std::int16_t, kBlock>(samples.data() + at, kBlock)));
    }
    return is_speech;
}

// Of the blocks between two times.
double share(const std::vector<bool>& is_speech, double from_s, double to_s) {
    const auto from = is_speech.begin() + std::lround(from_s / kBlock_s);
    const auto to = is_speech.begin() + std::lround(to_s / kBlock_s);
    return static_cast<double>(std::count(from, to, true)) / static_cast<double>(to - from);
}

}  // namespace

TEST_CASE("voice activity: silence and noise of any loudness are no speech") {
    CHECK(share(listen_to(silence(5.0)), 0.0, 5.0) == 0.0);
    for (const double rms : {1e-4, 1e-3, 0.01, 0.1}) {
        CAPTURE(rms);
        // A thousand blocks: three in a row of them would begin an utterance.
        CHECK(share(listen_to(noise(10.0, rms)), 0.0, 10.0) < 0.01);
    }
}

TEST_CASE("voice activity: a sentence is found in noise, from its first sound to its last") {
    const Samples sentence = said("The watermelon is the heaviest.");
    const double length_s = seconds_of(sentence);
    double rms = 0.0;
    for (const std::int16_t x : sentence) {
        rms += x * x / 32768.0 / 32768.0;
    }
    rms = std::sqrt(rms / static_cast<double>(sentence.size()));
    for (const double snr_dB : {40.0, 20.0, 10.0}) {
        CAPTURE(snr_dB);
        const Samples all = joined({silence(2.0), sentence, silence(2.0)});
        const auto heard =
            listen_to(added(noise(seconds_of(all), rms * std::pow(10.0, -snr_dB / 20.0)), all));
        CHECK(share(heard, 2.0 + 0.15, 2.0 + length_s - 0.3) > 0.8);
        CHECK(share(heard, 0.0, 1.95) < 0.01);
        CHECK(share(heard, 2.0 + length_s + 0.1, 4.0 + length_s) < 0.01);
    }
}

TEST_CASE("voice activity: a fan that begins is noise after a second and a half") {
    const Samples all = joined({noise(3.0, 0.001), noise(5.0, 0.03, 2)});
    const auto heard = listen_to(all);
    CHECK(share(heard, 3.1, 4.0) > 0.9);  // at first it might be somebody
    CHECK(share(heard, 4.7, 8.0) < 0.01);
}

TEST_CASE("voice activity: a threshold out of its range is refused") {
    CHECK(validate(VoiceActivitySettings{}));
    for (const double bad : {0.0, -1.0, 1e3, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK_FALSE(validate(VoiceActivitySettings{.threshold = bad}));
    }
}
