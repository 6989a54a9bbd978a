#include "runtime/hearing/power_spectrum.h"
#include "runtime/hearing/utterance_gate.h"
#include "runtime/hearing/voice_activity.h"
#include "tests/unit/runtime/hearing/sounds.h"
#include "tests/unit/runtime/rig.h"

#include <numbers>
#include <numeric>
#include <random>

using namespace fulcrum::runtime::test;

namespace {

using Piece = std::array<double, kWindow>;

Piece tone(double lines, double amplitude, double phase_rad = 0.3) {
    Piece x{};
    for (std::size_t n = 0; n < x.size(); ++n) {
        x[n] = amplitude * std::cos(2.0 * std::numbers::pi * lines * static_cast<double>(n) /
                                        static_cast<double>(kTransform) +
                                    phase_rad);
    }
    return x;
}

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

// Plays samples through a gate; `input` says how things stand at a time.
struct Play {
    UtteranceGate gate;
    std::vector<Samples> utterances{};
    std::vector<double> ended_s{};
    double time_s = 0.0;

    explicit Play(const GateSettings& settings) : gate(settings) {}
    void operator()(const Samples& samples, const std::function<GateInput(double)>& input) {
        for (std::size_t at = 0; at + kBlock <= samples.size(); at += kBlock) {
            if (auto heard =
                    gate.step(std::span<const std::int16_t, kBlock>(samples.data() + at, kBlock),
                              input(time_s))) {
                utterances.push_back(std::move(*heard));
                ended_s.push_back(time_s);
            }
            time_s += kBlock_s;
        }
    }
};

GateInput wanted(double /*time_s*/) {
    return {.wanted = true};
}

Samples with_room(const Samples& samples) {
    return added(noise(seconds_of(samples), 5e-4), samples);
}

const Samples& sentence() {
    static const Samples kSentence = said("The watermelon is the heaviest.");
    return kSentence;
}

constexpr GateSettings kAlways{.mode = ListenMode::always};

}  // namespace

TEST_CASE("power spectrum: it is the sum of its definition, line by line") {
    std::mt19937 random(3);
    std::normal_distribution<double> value;
    Piece x{};
    std::ranges::generate(x, [&] { return value(random); });
    const PowerSpectrum power = compute_power(x);
    for (std::size_t k = 0; k < power.size(); k += 17) {
        double real = 0.0;
        double imaginary = 0.0;
        double window_power = 0.0;
        for (std::size_t n = 0; n < kWindow; ++n) {
            const double turn = 2.0 * std::numbers::pi * static_cast<double>(k * n) / kTransform;
            const double w = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi *
                                                  (static_cast<double>(n) + 0.5) / kWindow);
            real += w * x[n] * std::cos(turn);
            imaginary -= w * x[n] * std::sin(turn);
            window_power += w * w;
        }
        CHECK(power[k] ==
              Approx((real * real + imaginary * imaginary) / window_power).epsilon(1e-9));
    }
}

TEST_CASE("power spectrum: a tone is where it is, with the height that the window gives it") {
    // |sum of w a/2|² / sum of w²  =  (a/2 · n/2)² / (3n/8)  =  a² n / 6
    for (const double line : {32.0, 100.0, 200.0}) {
        const PowerSpectrum power = compute_power(tone(line, 0.5));
        const auto top = std::ranges::max_element(power);
        CHECK(top - power.begin() == static_cast<std::ptrdiff_t>(line));
        CHECK(*top == Approx(0.25 * kWindow / 6.0).epsilon(0.01));
        CHECK(power[static_cast<std::size_t>(line) + 20] < 1e-5 * *top);
    }
}

TEST_CASE("power spectrum: the mean over white noise is its variance; nothing has none") {
    std::mt19937 random(1);
    std::normal_distribution<double> value(0.0, 0.2);
    double sum = 0.0;
    constexpr int kPieces = 400;
    for (int i = 0; i < kPieces; ++i) {
        Piece x{};
        std::ranges::generate(x, [&] { return value(random); });
        const PowerSpectrum power = compute_power(x);
        sum += std::accumulate(power.begin(), power.end(), 0.0) / static_cast<double>(power.size());
    }
    CHECK(sum / kPieces == Approx(0.04).epsilon(0.02));
    const PowerSpectrum none = compute_power(Piece{});
    CHECK(std::ranges::all_of(none, [](double p) { return p == 0.0; }));
}

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

TEST_CASE("utterance gate: two sentences are two utterances, whole, each with a little around it") {
    Play play(kAlways);
    const double length_s = seconds_of(sentence());
    play(with_room(joined({silence(2.0), sentence(), silence(2.0), sentence(), silence(2.0)})),
         wanted);
    REQUIRE(play.utterances.size() == 2);
    for (const Samples& utterance : play.utterances) {
        CHECK(seconds_of(utterance) > length_s);
        CHECK(seconds_of(utterance) < length_s + 0.7);
    }
    // It ends when the pause is over, not later.
    CHECK(play.ended_s[0] == Approx(2.0 + length_s + kAlways.pause_s).margin(0.3));
}

TEST_CASE("utterance gate: a pause to think is no end, a knock is no utterance") {
    Play play(kAlways);
    const Samples first = said("the watermelon");
    const Samples second = said("is the heaviest");
    play(with_room(joined({silence(2.0), noise(0.05, 0.3), silence(2.0)})), wanted);
    CHECK(play.utterances.empty());
    play(with_room(joined({first, silence(0.4), second, silence(2.0)})), wanted);
    REQUIRE(play.utterances.size() == 1);
    CHECK(seconds_of(play.utterances[0]) > seconds_of(first) + 0.4 + seconds_of(second) - 0.1);
}

TEST_CASE("utterance gate: nobody is heard unless somebody listens, nor while the program speaks") {
    const Samples all = with_room(joined({silence(1.0), sentence(), silence(2.0)}));
    Play unasked(kAlways);
    unasked(all, [](double) { return GateInput{}; });
    CHECK(unasked.utterances.empty());
    Play own_voice(kAlways);
    own_voice(all, [&](double time_s) {
        return GateInput{.wanted = true, .speaks = time_s < 1.0 + seconds_of(sentence())};
    });
    CHECK(own_voice.utterances.empty());
    // What is half heard when the question is taken back, or the program begins to speak, is dropped.
    for (const bool taken_back : {true, false}) {
        Play half(kAlways);
        half(all, [&](double time_s) {
            const bool late = time_s > 2.0;
            return GateInput{.wanted = !(taken_back && late), .speaks = !taken_back && late};
        });
        CHECK(half.utterances.empty());
        CHECK_FALSE(half.gate.hears());
    }
}

TEST_CASE("utterance gate: deaf as long as the room rings, and not longer") {
    Play play(kAlways);
    const auto input = [](double time_s) {
        return GateInput{.wanted = true, .speaks = time_s < 1.0};
    };
    play(with_room(silence(1.25)), input);
    CHECK(play.gate.deaf());
    play(with_room(silence(0.1)), input);
    CHECK_FALSE(play.gate.deaf());
    play(with_room(joined({silence(1.0), sentence(), silence(2.0)})), input);
    CHECK(play.utterances.size() == 1);
}

TEST_CASE("utterance gate: with a key what is said while it is held is heard, and the end of it") {
    Play play({});
    const double length_s = seconds_of(sentence());
    const Samples all =
        with_room(joined({silence(2.0), sentence(), silence(1.0), sentence(), silence(2.0)}));
    // Down a little late, up a little early.
    play(all, [&](double time_s) {
        return GateInput{.wanted = true, .held = time_s > 2.1 && time_s < 1.85 + length_s};
    });
    REQUIRE(play.utterances.size() == 1);
    CHECK(seconds_of(play.utterances[0]) > length_s - 0.15);
    CHECK(seconds_of(play.utterances[0]) < length_s + 0.7);
    CHECK(play.ended_s[0] == Approx(1.85 + length_s + GateSettings{}.release_s).margin(0.03));
}

TEST_CASE("utterance gate: silence while the key is held is cut off; all of it where none speaks") {
    Play play({});
    play(with_room(joined({silence(3.0), sentence(), silence(3.0)})), [](double time_s) {
        return GateInput{.wanted = true, .held = time_s > 0.5 && time_s < 6.5};
    });
    REQUIRE(play.utterances.size() == 1);
    CHECK(seconds_of(play.utterances[0]) < seconds_of(sentence()) + 0.7);
    Play nobody({});
    nobody(with_room(silence(4.0)), [](double time_s) {
        return GateInput{.wanted = true, .held = time_s > 1.0 && time_s < 2.0};
    });
    REQUIRE(nobody.utterances.size() == 1);  // for a recogniser to say that it heard nothing
    CHECK(seconds_of(nobody.utterances[0]) == Approx(1.6).margin(0.05));
}

TEST_CASE("utterance gate: a key that was brushed, or was down before, says nothing") {
    Play brushed({});
    brushed(with_room(silence(2.0)), [](double time_s) {
        return GateInput{.wanted = true, .held = time_s > 1.0 && time_s < 1.1};
    });
    CHECK(brushed.utterances.empty());
    Play before({});
    before(with_room(joined({silence(1.0), sentence(), silence(1.0)})),
           [](double time_s) { return GateInput{.wanted = time_s > 0.5, .held = time_s < 2.5}; });
    CHECK(before.utterances.empty());
}

TEST_CASE("utterance gate: what never ends is cut") {
    GateSettings settings = kAlways;
    settings.most_s = 3.0;
    Play play(settings);
    Samples long_one = silence(2.0);
    for (int i = 0; i < 6; ++i) {
        long_one = joined({long_one, sentence()});
    }
    play(with_room(long_one), wanted);
    REQUIRE_FALSE(play.utterances.empty());
    for (const Samples& utterance : play.utterances) {
        CHECK(seconds_of(utterance) < 3.05);
    }
}

TEST_CASE("utterance gate: times out of their range are refused") {
    CHECK(validate(GateSettings{}));
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(validate(GateSettings{.before_s = -0.1}));
    CHECK_FALSE(validate(GateSettings{.pause_s = 0.0}));
    CHECK_FALSE(validate(GateSettings{.release_s = kNaN}));
    CHECK_FALSE(validate(GateSettings{.least_s = 3.0}));
    CHECK_FALSE(validate(GateSettings{.most_s = 1e9}));
    CHECK_FALSE(validate(GateSettings{.ring_s = kNaN}));
    CHECK_FALSE(validate(GateSettings{.voice = {.threshold = 0.0}}));
}
