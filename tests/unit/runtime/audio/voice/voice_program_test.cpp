#include "runtime/audio/voice/voice_program.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("voice program: names are known both ways, others are refused with those that are") {
    for (const VoiceKind kind : {VoiceKind::none, VoiceKind::flite, VoiceKind::espeak_ng}) {
        CHECK(find_voice(name_of(kind)).value() == kind);
    }
    const auto unknown = find_voice("festival");
    REQUIRE_FALSE(unknown);
    CHECK(to_sentence(unknown.error()) ==
          "the voice festival is not known; use none, flite or espeak-ng.");
}

TEST_CASE(
    "voice program: a text is one word of the command, without marks and control characters") {
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
