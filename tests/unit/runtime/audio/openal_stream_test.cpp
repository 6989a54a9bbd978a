#include "runtime/audio/null/null_player.h"
#include "runtime/audio/openal/openal_player.h"
#include "runtime/audio/waveform.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr std::size_t kFrame = 480;

/// A sine, whole numbers of samples since it began.
class Tone final : public SoundStream {
  public:
    void render(std::span<float> samples) noexcept override {
        for (float& sample : samples) {
            sample = at(made++);
        }
    }
    [[nodiscard]] static float at(std::size_t n) {
        return 0.5F * std::sin(2.0F * std::numbers::pi_v<float> * 440.0F * static_cast<float>(n) /
                               static_cast<float>(kSampleRate_Hz));
    }
    std::size_t made = 0;
};

std::unique_ptr<LoopbackPlayer> open_loopback() {
    auto player = open_openal_loopback({{"click"}, false, 1.0});
    REQUIRE(player.has_value());
    return std::move(*player);
}

std::vector<float> left_of(const std::vector<float>& both) {
    std::vector<float> left;
    for (std::size_t i = 0; i < both.size(); i += 2) {
        left.push_back(both[i]);
    }
    return left;
}

}  // namespace

TEST_CASE("stream: what is made is what is heard, sample by sample, without a gap") {
    auto player = open_loopback();
    Tone tone;
    player->set_stream(&tone);
    CHECK(tone.made == 5 * kFrame);  // the queue
    std::vector<float> heard;
    for (int i = 0; i < 100; ++i) {
        player->update(0.01);
        const auto part = left_of(player->render(kFrame));
        heard.insert(heard.end(), part.begin(), part.end());
    }
    CHECK(tone.made >= heard.size());
    CHECK(tone.made <= heard.size() + 5 * kFrame);
    // The mixer's own gain for a source in the middle, and its ramp at the beginning.
    const float gain = heard[4 * kFrame + 27] / Tone::at(4 * kFrame + 27);
    CHECK(gain > 0.5F);
    float most = 0.0F;
    for (std::size_t i = kFrame; i < heard.size(); ++i) {
        most = std::max(most, std::abs(heard[i] - gain * Tone::at(i)));
    }
    CHECK(most < 2e-4F);  // 16-bit samples, and the sine in floats
    player->set_stream(nullptr);
}

TEST_CASE(
    "stream: a picture that took long is a gap, and then it is heard again; none is silence") {
    auto player = open_loopback();
    Tone tone;
    player->set_stream(&tone);
    (void)player->render(20 * kFrame);  // nobody updates: the queue runs empty
    CHECK(tone.made == 5 * kFrame);
    player->update(0.2);
    CHECK(tone.made == 10 * kFrame);
    float loudest = 0.0F;
    for (const float x : player->render(kFrame)) {
        loudest = std::max(loudest, std::abs(x));
    }
    CHECK(loudest > 0.25F);
    player->set_stream(nullptr);
    player->update(0.01);
    (void)player->render(kFrame);
    for (const float x : player->render(kFrame)) {
        REQUIRE(x == 0.0F);
    }
    CHECK(tone.made == 10 * kFrame);
}

TEST_CASE("stream: the null player knows it and asks for nothing") {
    auto player = NullPlayer::open({{"click"}, false, 1.0});
    REQUIRE(player.has_value());
    Tone tone;
    (*player)->set_stream(&tone);
    (*player)->update(0.01);
    CHECK((*player)->stream() == &tone);
    CHECK(tone.made == 0);
}
