#include "dialogue/speech/captions/caption_voice.h"

#include "dialogue/speech/null/null_voice.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace fulcrum::dialogue;

TEST_CASE("captions: stand as long as the words take to read") {
    CaptionSettings settings;
    settings.words_per_s = 2.0;
    settings.settle_s = 1.0;
    settings.least_s = 2.0;
    CaptionVoice voice(settings);
    CHECK(voice.reading_time_s("Yes.") == 2.0);
    CHECK(voice.reading_time_s("A watermelon is the heaviest fruit.") == Approx(4.0));
    voice.say("Yes. A watermelon is *the heaviest*.");
    CHECK(voice.caption().text.plain == "Yes. A watermelon is the heaviest.");
    CHECK(voice.caption().text.strong.size() == 1);
    CHECK(voice.caption().said == "Yes. A watermelon is *the heaviest*.");
    CHECK(voice.caption().duration_s == Approx(4.0));
    CHECK(voice.speaking());
    voice.step(3.9);
    CHECK(voice.speaking());
    voice.step(0.2);
    CHECK_FALSE(voice.speaking());
    CHECK_FALSE(voice.caption().text.plain.empty());
}

TEST_CASE("captions: follow one another, each for its own time") {
    CaptionVoice voice;
    const double each_s = voice.reading_time_s("one");
    voice.say("one");
    voice.say("two");
    voice.say("three");
    CHECK(voice.caption().text.plain == "one");
    voice.step(1.5 * each_s);
    CHECK(voice.caption().text.plain == "two");
    CHECK(voice.caption().shown_s == Approx(0.5 * each_s));
    voice.step(100.0);
    CHECK(voice.caption().text.plain == "three");
    CHECK_FALSE(voice.speaking());
}

TEST_CASE("captions: a late one doesn't wait, and stopping clears") {
    CaptionVoice voice;
    voice.say("one");
    voice.step(50.0);
    voice.say("two");
    CHECK(voice.caption().text.plain == "two");
    CHECK(voice.caption().shown_s == 0.0);
    voice.say("three");
    voice.stop();
    CHECK(voice.caption().text.plain.empty());
    CHECK_FALSE(voice.speaking());
    voice.step(10.0);
    CHECK(voice.caption().text.plain.empty());
}

TEST_CASE("captions: bad settings, steps and floods do no harm") {
    CaptionSettings settings;
    settings.words_per_s = std::nan("");
    settings.settle_s = -1.0;
    settings.least_s = 1e9;
    const CaptionVoice odd(settings);
    CHECK(odd.reading_time_s("one") == 60.0);
    CaptionVoice voice;
    voice.say("");
    CHECK_FALSE(voice.speaking());
    voice.say("one");
    voice.step(-5.0);
    voice.step(std::nan(""));
    CHECK(voice.caption().shown_s == 0.0);
    for (int i = 0; i < 1000; ++i) {
        voice.say("more");
    }
    voice.step(1e6);
    CHECK_FALSE(voice.speaking());
}

TEST_CASE("null voice: never speaks") {
    NullVoice voice;
    voice.say("text");
    voice.step(1.0);
    CHECK_FALSE(voice.speaking());
    voice.stop();
}
