#include "runtime/audio/null/null_player.h"
#include "runtime/audio/openal/openal_player.h"
#include "runtime/audio/openal/openal_stream.h"
#include "runtime/audio/synthesis.h"
#include "runtime/audio/touch_sound.h"
#include "tests/unit/runtime/audio/openal/loopback.h"
#include "tests/unit/runtime/audio/stroked.h"
#include "tests/unit/runtime/rig.h"

#include <atomic>
#include <chrono>
#include <thread>

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

TEST_CASE("openal: a name that is not known at opening is an error") {
    CHECK_FALSE(open_openal_loopback({{"click", "moo"}, true, 1.0}));
}

TEST_CASE("openal: two players asked the same render the same bytes") {
    const auto session = [] {
        auto player = open_loopback();
        REQUIRE(player->play("catch_egg"));
        player->set_force_sound(3.0);
        auto heard = run(*player, 20);
        REQUIRE(player->play("catch_watermelon", 0.8, 1.1));
        player->set_force_sound(0.5);
        const auto rest = run(*player, 60);
        heard.insert(heard.end(), rest.begin(), rest.end());
        return heard;
    };
    const auto first = session();
    CHECK(rms(first) > 0.01);
    CHECK(first == session());
}

TEST_CASE("openal: a sound is heard for as long as it was made, then there is silence") {
    auto player = open_loopback();
    CHECK(rms(run(*player, 5)) == 0.0);
    const double duration_s =
        static_cast<double>(synthesise("catch_apple")->size()) / kSampleRate_Hz;
    REQUIRE(player->play("catch_apple"));
    const auto frames = static_cast<int>(std::lround(duration_s / kFrame_s));
    CHECK(rms(run(*player, frames / 2)) > 0.01);
    run(*player, frames - frames / 2 + 2);
    CHECK(loudest(run(*player, 20)) == 0.0F);
}

TEST_CASE("openal: what comes out follows the gain, and the pitch shortens a sound") {
    const auto level = [](double gain, double master) {
        auto player = open_loopback({{"right"}, false, master});
        REQUIRE(player->play("right", gain, 1.0));
        return rms(run(*player, 50));
    };
    const double full = level(1.0, 1.0);
    // 16-bit samples and the mixer's ramps leave less than 1 %.
    CHECK(level(0.5, 1.0) == Approx(0.5 * full).epsilon(0.01));
    CHECK(level(1.0, 0.25) == Approx(0.25 * full).epsilon(0.01));
    CHECK(level(0.0, 1.0) == 0.0);

    const auto length = [](double pitch) {
        auto player = open_loopback({{"finish"}, false, 1.0});
        REQUIRE(player->play("finish", 1.0, pitch));
        const auto heard = run(*player, 500);
        const auto last =
            std::find_if(heard.rbegin(), heard.rend(), [](float x) { return x != 0.0F; });
        return std::distance(last, heard.rend());
    };
    CHECK(static_cast<double>(length(1.0)) / static_cast<double>(length(2.0)) ==
          Approx(2.0).epsilon(0.02));
}

TEST_CASE("openal: what comes out follows the volume, whatever the master is") {
    const auto heard = [](double master, double volume) {
        auto player = open_loopback({{"right"}, false, master});
        player->set_volume(volume);
        REQUIRE(player->play("right"));
        return rms(run(*player, 50));
    };
    const double loud = heard(1.0, 1.0);
    constexpr double kSixteenBits = 0.01;  // of what is left of a quiet sound
    CHECK(heard(1.0, 0.3) == Approx(0.3 * loud).epsilon(kSixteenBits));
    CHECK(heard(0.5, 0.3) == Approx(0.15 * loud).epsilon(kSixteenBits));
    CHECK(heard(1.0, 0.0) == 0.0);
    CHECK(heard(1.0, 7.0) == Approx(loud));
    CHECK(heard(1.0, -1.0) == 0.0);
    CHECK(heard(1.0, std::nan("")) == Approx(loud));
}

TEST_CASE("openal: bad names and numbers are errors and make no sound") {
    auto player = open_loopback({{"click"}, true, 1.0});
    CHECK_FALSE(player->play("moo"));
    CHECK_FALSE(player->play(""));
    CHECK_FALSE(player->play("finish"));  // known, but not asked for at opening
    for (const auto& [gain, pitch] : {std::pair(-0.1, 1.0),
                                      {1.1, 1.0},
                                      {std::nan(""), 1.0},
                                      {1.0, 0.2},
                                      {1.0, 4.1},
                                      {1.0, std::nan("")}}) {
        CAPTURE(gain, pitch);
        CHECK_FALSE(player->play("click", gain, pitch));
    }
    player->set_force_sound(std::nan(""));
    player->set_force_sound(-2.0);
    CHECK(loudest(run(*player, 20)) == 0.0F);
    CHECK(player->play("click"));
    CHECK(loudest(run(*player, 5)) > 0.0F);
}

TEST_CASE("openal: more force is louder, none is silence again") {
    auto player = open_loopback({{"click"}, true, 1.0});
    std::array<double, 4> levels{};
    for (std::size_t i = 0; i < levels.size(); ++i) {
        player->set_force_sound(static_cast<double>(i) * 1.5);
        run(*player, 40);  // ten time constants
        levels[i] = rms(run(*player, 20));
    }
    CHECK(levels[0] == 0.0);
    CHECK(levels[1] > 0.005);
    CHECK(levels[2] > 1.1 * levels[1]);
    CHECK(levels[3] > 1.1 * levels[2]);
    player->set_force_sound(0.0);
    run(*player, 80);
    CHECK(loudest(run(*player, 20)) == 0.0F);
}

TEST_CASE("openal: the force sound comes and goes without a click") {
    auto player = open_loopback({{"click"}, true, 1.0});
    player->set_force_sound(5.0);
    run(*player, 50);
    const auto steady = run(*player, 50);
    player->set_force_sound(0.0);
    const auto going = run(*player, 60);
    player->set_force_sound(5.0);
    const auto coming = run(*player, 60);
    // A click would be a step of the sound's own height; the steady sound's slope is the measure.
    CHECK(largest_step(going, 2) <= 1.5F * largest_step(steady, 2));
    CHECK(largest_step(coming, 2) <= 1.5F * largest_step(steady, 2));
}

TEST_CASE("openal: stop fades everything out within 20 ms, and a sound can follow at once") {
    auto player = open_loopback();
    REQUIRE(player->play("finish"));
    player->set_force_sound(4.0);
    CHECK(rms(run(*player, 20)) > 0.01);
    player->stop();
    run(*player, 60);  // the force sound follows in 40 ms, ten times over
    CHECK(loudest(run(*player, 20)) == 0.0F);

    REQUIRE(player->play("finish"));
    run(*player, 10);
    player->stop();
    REQUIRE(player->play("click"));
    CHECK(loudest(run(*player, 3)) > 0.02F);
}

TEST_CASE("openal: stopping makes no click") {
    auto player = open_loopback({{"finish"}, false, 1.0});
    REQUIRE(player->play("finish"));
    run(*player, 110);  // into the last chord
    const auto sounding = run(*player, 10);
    player->stop();
    const auto going = run(*player, 10);
    CHECK(largest_step(going, 2) <= 1.2F * largest_step(sounding, 2));
    // Half way down after 10 ms, silent after 40.
    CHECK(rms(Sound(going).subspan(480, 480)) < 0.6 * rms(sounding));
    CHECK(loudest(Sound(going).subspan(4 * 960)) == 0.0F);
}

TEST_CASE("openal: a thirteenth sound takes the place of the oldest") {
    auto player = open_loopback({{"finish", "catch_egg"}, false, 1.0});
    REQUIRE(player->play("finish"));  // the oldest, the only one to be heard
    for (std::size_t i = 1; i < kVoices; ++i) {
        REQUIRE(player->play("finish", 0.0, 1.0));
    }
    CHECK(loudest(run(*player, 60)) > 0.05F);
    REQUIRE(player->play("catch_egg"));
    run(*player, 30);  // the egg is over
    CHECK(loudest(run(*player, 20)) == 0.0F);
}

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

TEST_CASE("stream: a picture that took long is a gap, then it is heard again; none is silence") {
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

TEST_CASE("touch sound: through OpenAL the line stays where it is") {
    constexpr double kRound_s = 1e-3;
    const auto player = open_loopback({{"click"}, false, 1.0});
    auto ring = std::make_unique<TouchRing>();
    TouchSound sound(*ring, {TapTone{}}, kRound_s);
    player->set_stream(&sound);
    std::vector<float> heard;
    for (int piece_number = 0; piece_number < 150; ++piece_number) {
        for (int i = 0; i < 10; ++i) {
            (void)ring->push(make_stroked((10 * piece_number + i) * kRound_s));
        }
        const auto part = left_of(run(*player, 1));
        heard.insert(heard.end(), part.begin(), part.end());
    }
    player->set_stream(nullptr);
    const auto steady = piece(heard, 0.4, 1.4);
    CHECK(strongest_Hz(steady, 20.0, 500.0) == Approx(100.0).margin(1.0));
    CHECK(line(steady, 100.0) > 0.03);
    CHECK(line(steady, 150.0) < 0.01 * line(steady, 100.0));
}
