#include "runtime/audio/lasting_player.h"
#include "runtime/audio/null/null_player.h"
#include "runtime/audio/open_sound_player.h"
#include "runtime/audio/recorded_microphone.h"
#include "tests/unit/runtime/rig.h"

#include <numeric>

using namespace fulcrum::runtime::test;

namespace {

// A sound card that can be unplugged.
struct Card final : SoundPlayer {
    Expected<void> play(std::string_view /*name*/, double /*gain*/, double /*pitch*/) override {
        ++n_plays;
        return {};
    }
    void set_force_sound(double /*force_N*/) override {}
    void set_volume(double gain) override { volume = gain; }
    void set_stream(SoundStream* given) override { stream = given; }
    void speak(std::span<const float> /*samples*/) override {}
    void hush() override {}
    [[nodiscard]] bool is_speaking() const override { return false; }
    void update(double /*dt_s*/) override {}
    void stop() override {}
    [[nodiscard]] bool audible() const override { return is_there; }

    bool is_there = true;
    int n_plays = 0;
    double volume = 1.0;
    SoundStream* stream = nullptr;
};

struct Recording {
    double now_s = 5.0;
    std::vector<std::int16_t> samples = std::vector<std::int16_t>(1600);
    RecordedMicrophone microphone;
    std::array<std::int16_t, 4000> read{};

    explicit Recording(RecordedMicrophoneSettings settings = {})
        : microphone(counted(), with_clock(std::move(settings))) {}
    std::size_t at(double time_s) {
        now_s = 5.0 + time_s;
        return microphone.read(read).value();
    }

  private:
    std::vector<std::int16_t> counted() {
        std::iota(samples.begin(), samples.end(), std::int16_t{1});
        return samples;
    }
    RecordedMicrophoneSettings with_clock(RecordedMicrophoneSettings settings) {
        settings.now_s = [this] { return now_s; };
        return settings;
    }
};

}  // namespace

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

TEST_CASE("sound player: unknown names at opening are errors for every kind") {
    const SoundSettings settings{{"click", "moo"}, true, 1.0};
    CHECK_FALSE(open_sound_player(settings));
    CHECK_FALSE(NullPlayer::open(settings));
    CHECK_FALSE(NullPlayer::open({{}, true, 1.5}));
    CHECK_FALSE(NullPlayer::open({{}, true, std::nan("")}));
}

TEST_CASE("sound player: without a sound card there is a silent player and a sentence") {
    auto opened = open_sound_player({});
    REQUIRE(opened.has_value());
    REQUIRE(opened->player != nullptr);
    CHECK(opened->player->audible() == opened->notice.empty());
    CHECK(opened->notice.find('\n') == std::string::npos);
    CHECK(opened->player->play("click"));
    CHECK_FALSE(opened->player->play("moo"));
    opened->player->set_force_sound(2.0);
    opened->player->update(0.01);
    opened->player->stop();
}

TEST_CASE("lasting player: a card that goes is told once, and one that comes is heard") {
    struct Silence final : SoundStream {
        void render(std::span<float> samples) noexcept override {
            std::ranges::fill(samples, 0.0F);
        }
    };
    Silence stream;
    auto first = std::make_unique<Card>();
    Card* const card = first.get();
    auto silent = NullPlayer::open({}).value();
    const NullPlayer* const silence = silent.get();
    const Card* opened = nullptr;
    int n_tries = 0;
    LastingPlayer player(std::move(first), std::move(silent),
                         [&]() -> Expected<std::unique_ptr<SoundPlayer>> {
                             if (++n_tries < 3) {
                                 return tl::unexpected(Error{"no card", {}, {}});
                             }
                             auto made = std::make_unique<Card>();
                             opened = made.get();
                             return made;
                         });
    const auto goes_on = [&](int seconds) {
        for (int i = 0; i < 10 * seconds; ++i) {
            player.update(0.1);
        }
    };
    player.set_stream(&stream);
    player.set_volume(0.3);
    CHECK(card->volume == 0.3);
    goes_on(3);
    CHECK(player.audible());
    CHECK(player.take_notice().empty());
    CHECK(card->stream == &stream);

    card->is_there = false;
    goes_on(1);
    CHECK_FALSE(player.audible());
    CHECK(player.play("click"));
    CHECK(silence->plays("click") == 1);
    CHECK(silence->stream() == &stream);
    CHECK(player.take_notice().starts_with("The sound card is gone"));
    CHECK(player.take_notice().empty());
    goes_on(3);
    CHECK(n_tries == 1);
    goes_on(4);
    CHECK(n_tries == 2);
    CHECK_FALSE(player.audible());
    goes_on(8);
    CHECK(n_tries == 3);
    CHECK(player.audible());
    CHECK(player.take_notice() == "There is a sound card again.");
    REQUIRE(opened != nullptr);
    CHECK(opened->stream == &stream);
    CHECK(opened->volume == 0.3);
    CHECK(silence->stream() == nullptr);
    CHECK(player.play("click"));
    CHECK(opened->n_plays == 1);
}

TEST_CASE("recorded microphone: gives what is due since the last time, silence behind its end") {
    Recording recording;
    CHECK(recording.at(0.0) == 0);
    CHECK(recording.at(0.01) == 160);
    CHECK(recording.read[0] == 1);
    CHECK(recording.read[159] == 160);
    CHECK(recording.at(0.01) == 0);
    CHECK(recording.at(0.03) == 320);
    CHECK(recording.read[0] == 161);
    CHECK(recording.at(0.11) == 1280);
    CHECK(recording.read[1119] == 1600);
    CHECK(recording.read[1120] == 0);
}

TEST_CASE("recorded microphone: what does not fit comes next; quicker than time when asked") {
    Recording recording({.speed = 10.0});
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 4000);
    CHECK(recording.at(0.1) == 0);
}

TEST_CASE("recorded microphone: unplugged at its time, and for good") {
    Recording recording({.unplugged_at_s = 0.5});
    CHECK(recording.at(0.25) == 4000);
    recording.now_s = 5.5;
    CHECK_FALSE(recording.microphone.read(recording.read));
    recording.now_s = 6.0;
    const auto gone = recording.microphone.read(recording.read);
    REQUIRE_FALSE(gone);
    CHECK(to_sentence(gone.error()).find("unplugged") != std::string::npos);
}
