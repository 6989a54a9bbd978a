#include "haptics/base/clock.h"
#include "runtime/audio/voice/speech_maker.h"
#include "runtime/audio/voice/voice_program.h"
#include "runtime/audio/wav.h"
#include "tests/support/eventually.h"
#include "tests/support/scratch_folder.h"
#include "tests/unit/runtime/rig.h"

#include <chrono>
#include <thread>

using namespace fulcrum::runtime::test;
using namespace fulcrum::test_support;
namespace fs = std::filesystem;

namespace {

std::optional<MadeSpeech> wait_for(SpeechMaker& maker) {
    std::optional<MadeSpeech> made;
    (void)eventually([&] { return (made = maker.take()).has_value(); });
    return made;
}

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

TEST_CASE("speech maker: a program that fails says so once, and what follows is made") {
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

TEST_CASE("speech maker: a voice killed in a sentence is told once, and the next one is said") {
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

TEST_CASE("speech maker: while one hangs nobody waits; what is wanted instead is made at once") {
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

TEST_CASE("speech maker: a voice not installed, or that says no sound, is one sentence each") {
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

TEST_CASE("voice program: names are known both ways, others are refused with those that are") {
    for (const VoiceKind kind : {VoiceKind::none, VoiceKind::flite, VoiceKind::espeak_ng}) {
        CHECK(find_voice(name_of(kind)).value() == kind);
    }
    const auto unknown = find_voice("festival");
    REQUIRE_FALSE(unknown);
    CHECK(to_sentence(unknown.error()) ==
          "the voice festival is not known; use none, flite or espeak-ng.");
}

TEST_CASE("voice program: a text is one word, without marks and control characters") {
    for (const VoiceKind kind : {VoiceKind::flite, VoiceKind::espeak_ng}) {
        const auto words =
            make_voice_words({.kind = kind, .speed = 1.0}, "-o *heavier*\n; rm \"x\"\x7f\x1b");
        CHECK(words.front() == name_of(kind));
        CHECK(words.back() == "-o heavier ; rm \"x\"  ");
    }
    const auto espeak = make_voice_words({.kind = VoiceKind::espeak_ng}, "-o file");
    CHECK(espeak[espeak.size() - 2] == "--");
    const auto flite = make_voice_words({.kind = VoiceKind::flite}, "-o file");
    CHECK(flite[flite.size() - 2] == "-t");
}

TEST_CASE("voice program: a huge text is cut at a letter, and a word without an end at forty") {
    const auto said = [](const std::string& text) { return make_voice_words({}, text).back(); };
    std::string words;
    while (words.size() < 5000) {
        words += "word ";
    }
    CHECK(said(words).size() == 2000);
    // Three bytes a letter: 1998 of 2000 are whole letters.
    std::string letters;
    for (int i = 0; i < 2000; ++i) {
        letters += i % 10 == 9 ? "\xEB\xAF\xBC " : "\xEB\xAF\xBC";
    }
    const std::string cut = said(letters);
    CHECK(cut.size() > 1990);
    CHECK(cut.size() <= 2000);
    CHECK(letters.compare(0, cut.size(), cut) == 0);
    CHECK((static_cast<unsigned char>(letters[cut.size()]) & 0xC0U) != 0x80U);

    const std::string nines = said(std::string(1000, '9'));
    CHECK(nines.find(std::string(41, '9')) == std::string::npos);
    CHECK(std::count(nines.begin(), nines.end(), '9') == 1000);
    CHECK(said(std::string(40, 'a')) == std::string(40, 'a'));
}

TEST_CASE("voice program: half the speed takes twice the time, and no speed is out of range") {
    const auto has = [](double speed, VoiceKind kind, const std::string& word) {
        const auto words = make_voice_words({.kind = kind, .speed = speed}, "x");
        return std::find(words.begin(), words.end(), word) != words.end();
    };
    CHECK(has(0.5, VoiceKind::flite, "duration_stretch=2.00"));
    CHECK(has(1.0, VoiceKind::flite, "duration_stretch=1.00"));
    CHECK(has(0.5, VoiceKind::espeak_ng, "75"));
    CHECK(has(2.0, VoiceKind::espeak_ng, "300"));
    CHECK(has(50.0, VoiceKind::espeak_ng, "300"));
    CHECK(has(0.0, VoiceKind::flite, "duration_stretch=2.00"));
}
