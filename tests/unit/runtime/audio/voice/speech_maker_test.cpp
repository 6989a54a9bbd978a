#include "runtime/audio/voice/speech_maker.h"

#include "haptics/base/clock.h"
#include "runtime/audio/wav.h"
#include "tests/support/scratch_folder.h"

#include <catch2/catch.hpp>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

using namespace fulcrum;
using namespace fulcrum::runtime;
namespace fs = std::filesystem;

namespace {

constexpr double kPatience_s = 20.0;

// A program called flite that comes first on the search path, while this lives.
class OwnProgram {
  public:
    explicit OwnProgram(const std::string& script) {
        const fs::path file = folder_.path() / "flite";
        std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
        fs::permissions(file, fs::perms::owner_all);
        setenv("PATH", (folder_.path().string() + ":" + before_).c_str(), 1);
    }
    OwnProgram(const OwnProgram&) = delete;
    OwnProgram& operator=(const OwnProgram&) = delete;
    ~OwnProgram() { setenv("PATH", before_.c_str(), 1); }
    [[nodiscard]] const fs::path& folder() const { return folder_.path(); }

  private:
    ScratchFolder folder_;
    std::string before_ = std::getenv("PATH");
};

std::optional<MadeSpeech> wait_for(SpeechMaker& maker) {
    const double end_s = monotonic_now_s() + kPatience_s;
    auto made = maker.take();
    while (!made && monotonic_now_s() < end_s) {
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        made = maker.take();
    }
    return made;
}

/// Asks for it, and waits until it is made.
MadeSpeech make(SpeechMaker& maker, const std::string& text) {
    maker.ask(text);
    const auto made = wait_for(maker);
    REQUIRE(made);
    return *made;
}

}  // namespace

TEST_CASE("speech maker: texts are made in order, at the player's rate, and once each") {
    OwnProgram program("echo . >>\"${0%/*}/calls\"; cat \"${0%/*}/sound.wav\"");
    const std::array<float, 4> sound{0.0F, 0.5F, 0.5F, 0.0F};
    REQUIRE(write_wav(program.folder() / "sound.wav", sound, 1, 16'000));
    SpeechMaker maker(VoiceSettings{});
    maker.ask("one");
    maker.ask("two");
    for (const char* text : {"one", "two"}) {
        const auto made = wait_for(maker);
        REQUIRE(made);
        CHECK(made->text == text);
        CHECK(made->samples.size() == 12);  // 16 to 48 kHz
    }
    CHECK(make(maker, "one").samples.size() == 12);
    CHECK(fs::file_size(program.folder() / "calls") == 4);  // two lines
    CHECK(maker.n_waiting() == 0);
    CHECK(maker.take_trouble().empty());
}

TEST_CASE(
    "speech maker: a program that fails says so once, and what follows is made all the same") {
    OwnProgram program("for last; do :; done; [ \"$last\" = good ] && cat \"${0%/*}/sound.wav\"");
    REQUIRE(write_wav(program.folder() / "sound.wav", std::array<float, 1>{0.5F}, 1, 48'000));
    SpeechMaker maker(VoiceSettings{});
    for (const char* text : {"bad", "worse", "good"}) {
        CHECK(make(maker, text).samples.empty() == (std::string_view(text) != "good"));
    }
    CHECK(maker.take_trouble().find("the program flite failed") == 0);
    CHECK(maker.take_trouble().empty());
}

TEST_CASE("speech maker: forgets what nobody wants, and ends in the midst of it") {
    OwnProgram program("sleep 100");
    const double begun_s = monotonic_now_s();
    {
        SpeechMaker maker(VoiceSettings{});
        maker.ask("one");
        maker.ask("two");
        CHECK(maker.n_waiting() == 2);
        maker.forget();
        maker.ask("three");
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        CHECK_FALSE(maker.take());
    }
    CHECK(monotonic_now_s() - begun_s < kPatience_s);
}

TEST_CASE(
    "speech maker: a voice that is killed in the midst of a sentence is one sentence, and the next "
    "is said") {
    // Kills itself behind half of its file, the first time.
    OwnProgram program(
        "d=${0%/*}; if [ -e $d/once ]; then cat $d/sound.wav; else : >$d/once; head -c 60 "
        "$d/sound.wav; kill -9 $$; fi");
    REQUIRE(write_wav(program.folder() / "sound.wav", std::array<float, 64>{0.5F}, 1, 48'000));
    SpeechMaker maker(VoiceSettings{});
    CHECK(make(maker, "one").samples.empty());
    CHECK(maker.take_trouble().find("the program flite failed") == 0);
    CHECK(make(maker, "two").samples.size() == 64);
    CHECK(maker.take_trouble().empty());
}

TEST_CASE(
    "speech maker: while a voice hangs nobody waits, and what is wanted instead is made at once") {
    OwnProgram program(
        "for last; do :; done; [ \"$last\" = hang ] && sleep 100; cat \"${0%/*}/sound.wav\"");
    REQUIRE(write_wav(program.folder() / "sound.wav", std::array<float, 4>{0.5F}, 1, 48'000));
    SpeechMaker maker(VoiceSettings{});
    maker.ask("hang");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    // What the picture's loop calls in each frame comes back although the voice hangs.
    const double begun_s = monotonic_now_s();
    for (int i = 0; i < 1000; ++i) {
        CHECK_FALSE(maker.take());
        CHECK(maker.n_waiting() == 1);
    }
    maker.forget();
    const MadeSpeech made = make(maker, "well");
    CHECK(made.text == "well");
    CHECK(made.samples.size() == 4);
    // Long before the hanging one would have been given up.
    CHECK(monotonic_now_s() - begun_s < 9.0);
    CHECK(maker.take_trouble().empty());
}

TEST_CASE(
    "speech maker: a voice that is not installed, or says what is no sound, is one sentence each") {
    {
        const ScratchFolder empty;
        const std::string before = std::getenv("PATH");
        setenv("PATH", empty.path().c_str(), 1);
        SpeechMaker maker(VoiceSettings{});
        const MadeSpeech made = make(maker, "one");
        setenv("PATH", before.c_str(), 1);
        CHECK(made.samples.empty());
        const std::string trouble = maker.take_trouble();
        CHECK(trouble.find("the program flite") == 0);
        CHECK(trouble.find('\n') == std::string::npos);
    }
    OwnProgram program("echo this is no sound at all");
    SpeechMaker maker(VoiceSettings{});
    CHECK(make(maker, "one").samples.empty());
    CHECK(maker.take_trouble().find("it is no WAV file") == 0);
}
