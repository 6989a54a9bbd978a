#include "runtime/audio/sound_player.h"

#include "runtime/audio/null/null_player.h"
#include "runtime/audio/openal/openal_player.h"
#include "runtime/audio/synthesis.h"
#include "runtime/audio/wav.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <numeric>
#include <unistd.h>

using namespace fulcrum;
using namespace fulcrum::runtime;

namespace {

constexpr double kFrame_s = 0.01;
constexpr std::size_t kFrame = 480;

std::unique_ptr<LoopbackPlayer> open_loopback(const SoundSettings& settings = {}) {
    auto player = open_openal_loopback(settings);
    REQUIRE(player.has_value());
    return std::move(*player);
}

/// Renders `n` frames of 10 ms with an update before each.
std::vector<float> run(LoopbackPlayer& player, int n) {
    std::vector<float> all;
    for (int i = 0; i < n; ++i) {
        player.update(kFrame_s);
        const auto part = player.render(kFrame);
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

double rms(const std::vector<float>& x) {
    double sum = 0.0;
    for (const float sample : x) {
        sum += static_cast<double>(sample) * static_cast<double>(sample);
    }
    return x.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(x.size()));
}

float peak(const std::vector<float>& x) {
    return std::accumulate(x.begin(), x.end(), 0.0F,
                           [](float a, float b) { return std::max(a, std::abs(b)); });
}

}  // namespace

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
    CHECK(peak(run(*player, 20)) == 0.0F);
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

TEST_CASE("openal: bad names and numbers are errors and make no sound") {
    auto player = open_loopback({{"click"}, true, 1.0});
    CHECK_FALSE(player->play("moo"));
    CHECK_FALSE(player->play(""));
    CHECK_FALSE(player->play("finish"));  // known, but not asked for at opening
    CHECK_FALSE(player->play("click", -0.1, 1.0));
    CHECK_FALSE(player->play("click", 1.1, 1.0));
    CHECK_FALSE(player->play("click", std::nan(""), 1.0));
    CHECK_FALSE(player->play("click", 1.0, 0.2));
    CHECK_FALSE(player->play("click", 1.0, 4.1));
    CHECK_FALSE(player->play("click", 1.0, std::nan("")));
    player->set_force_sound(std::nan(""));
    player->set_force_sound(-2.0);
    CHECK(peak(run(*player, 20)) == 0.0F);
    CHECK(player->play("click"));
    CHECK(peak(run(*player, 5)) > 0.0F);
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
    CHECK(peak(run(*player, 20)) == 0.0F);
}

TEST_CASE("openal: the force sound comes and goes without a click") {
    auto player = open_loopback({{"click"}, true, 1.0});
    player->set_force_sound(5.0);
    run(*player, 50);
    const auto steady = run(*player, 50);
    const auto largest_step = [](const std::vector<float>& x) {
        float largest = 0.0F;
        for (std::size_t i = 2; i < x.size(); ++i) {
            largest = std::max(largest, std::abs(x[i] - x[i - 2]));
        }
        return largest;
    };
    player->set_force_sound(0.0);
    const auto going = run(*player, 60);
    player->set_force_sound(5.0);
    const auto coming = run(*player, 60);
    // A click would be a step of the sound's own height; the steady sound's slope is the measure.
    CHECK(largest_step(going) <= 1.5F * largest_step(steady));
    CHECK(largest_step(coming) <= 1.5F * largest_step(steady));
}

TEST_CASE("openal: stop fades everything out within 20 ms, and a sound can follow at once") {
    auto player = open_loopback();
    REQUIRE(player->play("finish"));
    player->set_force_sound(4.0);
    CHECK(rms(run(*player, 20)) > 0.01);
    player->stop();
    run(*player, 60);  // the force sound follows in 40 ms, ten times over
    CHECK(peak(run(*player, 20)) == 0.0F);

    REQUIRE(player->play("finish"));
    run(*player, 10);
    player->stop();
    REQUIRE(player->play("click"));
    CHECK(peak(run(*player, 3)) > 0.02F);
}

TEST_CASE("openal: a thirteenth sound takes the place of the oldest") {
    auto player = open_loopback({{"finish", "catch_egg"}, false, 1.0});
    for (std::size_t i = 0; i < kVoices; ++i) {
        REQUIRE(player->play("finish", 0.0, 1.0));
    }
    run(*player, 2);
    REQUIRE(player->play("catch_egg"));
    CHECK(peak(run(*player, 5)) > 0.05F);
}

TEST_CASE("sound player: unknown names at opening are errors for every kind") {
    const SoundSettings settings{{"click", "moo"}, true, 1.0};
    CHECK_FALSE(open_sound_player(settings));
    CHECK_FALSE(open_openal_loopback(settings));
    CHECK_FALSE(NullPlayer::open(settings));
    CHECK_FALSE(NullPlayer::open({{}, true, 1.5}));
    CHECK_FALSE(NullPlayer::open({{}, true, std::nan("")}));
}

TEST_CASE(
    "sound player: without a sound card there is a silent player, a sentence, and a quiet "
    "terminal") {
    // Everything written to standard error while opening goes to a file.
    std::FILE* captured = std::tmpfile();
    REQUIRE(captured != nullptr);
    std::fflush(stderr);
    const int saved = ::dup(2);
    ::dup2(::fileno(captured), 2);
    auto opened = open_sound_player({});
    std::fflush(stderr);
    ::dup2(saved, 2);
    ::close(saved);
    const long written = std::ftell(captured) < 0 ? 0 : ::lseek(::fileno(captured), 0, SEEK_END);
    std::fclose(captured);

    REQUIRE(opened.has_value());
    REQUIRE(opened->player != nullptr);
    CHECK(written == 0);
    CHECK(opened->player->audible() == opened->notice.empty());
    CHECK(opened->player->play("click"));
    CHECK_FALSE(opened->player->play("moo"));
}

TEST_CASE("null player: counts what it was asked for and refuses what a real one would") {
    auto player = NullPlayer::open({{"pop", "click"}, true, 1.0});
    REQUIRE(player.has_value());
    SoundPlayer& face = **player;
    CHECK(face.play("pop"));
    CHECK(face.play("pop", 0.5, 2.0));
    CHECK_FALSE(face.play("pop", 2.0, 1.0));
    CHECK_FALSE(face.play("finish"));
    face.set_force_sound(2.5);
    CHECK((*player)->plays("pop") == 2);
    CHECK((*player)->plays("click") == 0);
    CHECK((*player)->force_N() == 2.5);
    face.stop();
    CHECK((*player)->force_N() == 0.0);
    CHECK_FALSE(face.audible());
}

TEST_CASE("wav: a written file has the header and the samples that were given") {
    const auto path = std::filesystem::temp_directory_path() /
                      ("fulcrum_wav_test_" + std::to_string(::getpid()) + ".wav");
    const std::array<float, 4> samples{0.0F, 0.5F, -1.0F, 3.0F};
    REQUIRE(write_wav(path, samples, 2, 48'000));
    std::ifstream in(path, std::ios::binary);
    const std::string file((std::istreambuf_iterator<char>(in)), {});
    std::filesystem::remove(path);
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(file[i]));
    };
    const auto sample = [&](std::size_t i) {
        return static_cast<std::int16_t>(byte(44 + 2 * i) | byte(45 + 2 * i) << 8);
    };
    REQUIRE(file.size() == 44 + 8);
    CHECK(file.substr(0, 4) == "RIFF");
    CHECK((byte(24) | byte(25) << 8) == 48'000);
    CHECK(byte(22) == 2);
    CHECK(sample(0) == 0);
    CHECK(sample(1) == 16384);
    CHECK(sample(2) == -32767);
    CHECK(sample(3) == 32767);
    CHECK_FALSE(write_wav("/no/such/folder/x.wav", samples, 2, 48'000));
    CHECK_FALSE(write_wav(path, samples, 3, 48'000));
}
