#include "runtime/audio/openal/openal_stream.h"

#include "runtime/audio/null/null_player.h"
#include "runtime/audio/openal/openal_player.h"
#include "runtime/audio/waveform.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

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

/// The same, counted for another thread to see.
class CountedTone final : public SoundStream {
  public:
    void render(std::span<float> samples) noexcept override {
        std::size_t n = made.load();
        for (float& sample : samples) {
            sample = Tone::at(n++);
        }
        made.store(n);
    }
    std::atomic<std::size_t> made{0};
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

TEST_CASE("stream: with a thread of its own nobody has to update, and its short queue has no gap") {
    auto player = open_loopback();  // makes a context current
    std::vector<float> heard;
    {
        CountedTone tone;
        OpenalStream stream(tone, kThreadedQueue);
        const std::size_t queue = kThreadedQueue.n_buffers * kThreadedQueue.n_samples;
        const std::size_t piece = kThreadedQueue.n_samples;
        for (int i = 0; i < 100; ++i) {
            // As a card would, but only once the queue is full again, however busy the machine is.
            for (int wait = 0; wait < 10'000 && tone.made.load() < heard.size() + queue; ++wait) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            REQUIRE(tone.made.load() >= heard.size() + queue);
            stream.update();  // leaves it to the thread
            const auto part = left_of(player->render(piece));
            heard.insert(heard.end(), part.begin(), part.end());
        }
        CHECK(tone.made.load() <= heard.size() + queue);
    }
    const float gain = heard[4 * kFrame + 27] / Tone::at(4 * kFrame + 27);
    CHECK(gain > 0.5F);
    float most = 0.0F;
    for (std::size_t i = kFrame; i < heard.size(); ++i) {
        most = std::max(most, std::abs(heard[i] - gain * Tone::at(i)));
    }
    CHECK(most < 2e-4F);
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
