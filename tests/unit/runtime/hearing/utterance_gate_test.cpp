#include "runtime/hearing/utterance_gate.h"

#include "tests/unit/runtime/hearing/sounds.h"

#include <functional>
#include <limits>

using namespace fulcrum;
using namespace fulcrum::runtime;
using namespace fulcrum::runtime::test;

namespace {

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

TEST_CASE(
    "utterance gate: silence while the key is held is cut off, and none is left where nobody "
    "speaks") {
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
