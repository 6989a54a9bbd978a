#include "runtime/audio/openal/openal_stream.h"

#include "runtime/audio/null/null_player.h"
#include "tests/unit/runtime/audio/heard.h"

#include <atomic>
#include <chrono>
#include <thread>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

/// A sine, whole numbers of samples since it began, which another thread may count.
class Tone final : public SoundStream {
  public:
    void render(std::span<float> samples) noexcept override {
        std::size_t n = made.load();
        for (float& sample : samples) {
            sample = at(n++);
        }
        made.store(n);
    }
    [[nodiscard]] static float at(std::size_t n) {
        return 0.5F * std::sin(2.0F * std::numbers::pi_v<float> * 440.0F * static_cast<float>(n) /
                               static_cast<float>(kSampleRate_Hz));
    }
    std::atomic<std::size_t> made{0};
};

std::unique_ptr<LoopbackPlayer> open_clicking() {
    return open_loopback({{"click"}, false, 1.0});
}

/// Is it the tone from its first sample on, but for the mixer's own gain for a source in the middle, and its ramp at the beginning?
void check_is_tone(const std::vector<float>& heard) {
    const float gain = heard[4 * kFrame + 27] / Tone::at(4 * kFrame + 27);
    CHECK(gain > 0.5F);
    float most = 0.0F;
    for (std::size_t i = kFrame; i < heard.size(); ++i) {
        most = std::max(most, std::abs(heard[i] - gain * Tone::at(i)));
    }
    CHECK(most < 2e-4F);  // 16-bit samples, and the sine in floats
}

}  // namespace

TEST_CASE("stream: what is made is what is heard, sample by sample, without a gap") {
    auto player = open_clicking();
    Tone tone;
    player->set_stream(&tone);
    CHECK(tone.made == 5 * kFrame);  // the queue
    const std::vector<float> heard = left_of(run(*player, 100));
    CHECK(tone.made >= heard.size());
    CHECK(tone.made <= heard.size() + 5 * kFrame);
    check_is_tone(heard);
    player->set_stream(nullptr);
}

TEST_CASE(
    "stream: a picture that took long is a gap, and then it is heard again; none is silence") {
    auto player = open_clicking();
    Tone tone;
    player->set_stream(&tone);
    (void)player->render(20 * kFrame);  // nobody updates: the queue runs empty
    CHECK(tone.made == 5 * kFrame);
    player->update(0.2);
    CHECK(tone.made == 10 * kFrame);
    CHECK(loudest(player->render(kFrame)) > 0.25F);
    player->set_stream(nullptr);
    player->update(0.01);
    (void)player->render(kFrame);
    CHECK(loudest(player->render(kFrame)) == 0.0F);
    CHECK(tone.made == 10 * kFrame);
}

TEST_CASE("stream: with a thread of its own nobody has to update, and its short queue has no gap") {
    auto player = open_clicking();  // makes a context current
    std::vector<float> heard;
    {
        Tone tone;
        OpenalStream stream(tone, kThreadedQueue);
        const std::size_t queue = kThreadedQueue.n_buffers * kThreadedQueue.n_samples;
        const std::size_t piece = kThreadedQueue.n_samples;
        for (int i = 0; i < 100; ++i) {
            // As a card would, but only once the queue is full again, however busy the machine is.
            for (int wait = 0; wait < 10'000 && tone.made < heard.size() + queue; ++wait) {
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            REQUIRE(tone.made >= heard.size() + queue);
            stream.update();  // leaves it to the thread
            const auto part = left_of(player->render(piece));
            heard.insert(heard.end(), part.begin(), part.end());
        }
        CHECK(tone.made <= heard.size() + queue);
    }
    check_is_tone(heard);
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
