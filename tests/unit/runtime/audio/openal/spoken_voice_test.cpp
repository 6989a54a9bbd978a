#include "runtime/audio/voice/spoken_voice.h"

#include "tests/support/eventually.h"
#include "tests/unit/runtime/audio/openal/loopback.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;
using namespace fulcrum::test_support;

namespace {

// A player whose sound is taken out by hand, and how long somebody speaks.
struct Listener {
    std::unique_ptr<LoopbackPlayer> player = open_loopback();

    double hear_s(SpokenVoice& voice, std::vector<float>* heard = nullptr) const {
        double spoken_s = 0.0;
        while (player->is_speaking() && spoken_s < kPatience_s) {
            voice.step(kFrame_s);
            const auto part = run(*player, 1);
            if (heard != nullptr) {
                heard->insert(heard->end(), part.begin(), part.end());
            }
            spoken_s += kFrame_s;
        }
        return spoken_s;
    }
    bool begins(SpokenVoice& voice) const {
        return eventually([&] {
            voice.step(kFrame_s);
            return player->is_speaking();
        });
    }
};

}  // namespace

TEST_CASE("spoken voice: both programs are heard, as long as a sentence takes, slower when asked") {
    constexpr std::string_view kSentence = "The watermelon is the *heaviest*.";
    for (const VoiceKind kind : {VoiceKind::flite, VoiceKind::espeak_ng}) {
        CAPTURE(name_of(kind));
        double at_speed_s[2] = {0.0, 0.0};
        for (const double speed : {1.0, 0.5}) {
            const Listener listener;
            SpokenVoice voice({.kind = kind, .speed = speed}, *listener.player);
            voice.say(kSentence);
            CHECK(voice.speaking());
            REQUIRE(listener.begins(voice));
            std::vector<float> heard;
            at_speed_s[speed == 1.0 ? 0 : 1] = listener.hear_s(voice, &heard);
            CHECK(voice.take_trouble().empty());
            CHECK_FALSE(voice.speaking());
            CHECK(rms(heard) > 0.01);
        }
        CHECK(at_speed_s[0] > 0.8);
        CHECK(at_speed_s[0] < 4.0);
        CHECK(at_speed_s[1] > 1.6 * at_speed_s[0]);
        CHECK(at_speed_s[1] < 2.4 * at_speed_s[0]);
    }
}

TEST_CASE("spoken voice: one text after the other; it falls silent within two frames of stop") {
    const Listener listener;
    SpokenVoice voice({}, *listener.player);
    voice.say("One.");
    voice.say("Two.");
    REQUIRE(listener.begins(voice));
    const double first_s = listener.hear_s(voice);
    REQUIRE(listener.begins(voice));
    const double second_s = listener.hear_s(voice);
    CHECK(first_s > 0.2);
    CHECK(second_s > 0.2);
    voice.say("A sentence that takes a good while until it is at its end, and some more.");
    REQUIRE(listener.begins(voice));
    (void)listener.player->render(4 * kFrame);
    voice.stop();
    (void)run(*listener.player, 4);
    CHECK_FALSE(voice.speaking());
    CHECK(rms(listener.player->render(4 * kFrame)) < 1.0e-4);
}

TEST_CASE("spoken voice: when too much waits the newest is said") {
    const Listener listener;
    SpokenVoice voice({}, *listener.player);
    for (int i = 0; i < 50; ++i) {
        voice.say("This is text number " + std::to_string(i) + ".");
    }
    int n_said = 0;
    while (voice.speaking() && n_said < 50) {
        REQUIRE(listener.begins(voice));
        (void)listener.hear_s(voice);
        ++n_said;
    }
    CHECK(n_said >= 1);
    CHECK(n_said <= 3);
    voice.say("");
    CHECK_FALSE(voice.speaking());
}
