#include "dialogue/speech/captions/caption_voice.h"
#include "dialogue/speech/external/hearing_lines.h"
#include "dialogue/speech/null/null_voice.h"
#include "dialogue/speech/text/text_recogniser.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"

using namespace fulcrum::dialogue;

namespace {

template <class Line>
Line again(const Line& line) {
    const auto order = read_order(write_line(HearingOrder(line)));
    REQUIRE(order);
    REQUIRE(std::holds_alternative<Line>(*order));
    return std::get<Line>(*order);
}

template <class Line>
Line told_again(const Line& line) {
    const auto answer = read_answer(write_line(HearingAnswer(line)));
    REQUIRE(answer);
    REQUIRE(std::holds_alternative<Line>(*answer));
    return std::get<Line>(*answer);
}

}  // namespace

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

TEST_CASE("text recogniser: a typed answer is heard once, and only while listening") {
    TextRecogniser typed;
    const auto templates = heaviest().templates;
    typed.type("early");
    CHECK(typed.poll().empty());
    REQUIRE(typed.listen(templates));
    CHECK(typed.listening());
    const auto heard = typed.poll();
    REQUIRE(heard.size() == 1);
    CHECK(heard[0].text == "early");
    CHECK(heard[0].confidence == 1.0);
    CHECK_FALSE(typed.listening());
    typed.type("   ");
    REQUIRE(typed.listen(templates));
    CHECK(typed.poll().empty());
}

TEST_CASE("text recogniser: a script answers each listening with its next line") {
    TextRecogniser script(script_lines("# first\n watermelon is most heavy \n\n\r\nthe apple\r\n"));
    const auto templates = heaviest().templates;
    CHECK(script.script_left() == 2);
    REQUIRE(script.listen(templates));
    CHECK(script.poll()[0].text == "watermelon is most heavy");
    CHECK(script.poll().empty());
    REQUIRE(script.listen(templates));
    CHECK(script.poll()[0].text == "the apple");
    REQUIRE(script.listen(templates));
    CHECK(script.poll().empty());
    CHECK(script.listening());
}

TEST_CASE(
    "text recogniser: stopping forgets, a full queue counts, nothing to listen for is an error") {
    TextRecogniser typed;
    REQUIRE(typed.listen(heaviest().templates));
    typed.type("a");
    typed.stop();
    CHECK_FALSE(typed.listening());
    REQUIRE(typed.listen(heaviest().templates));
    CHECK(typed.poll().empty());
    for (std::size_t i = 0; i < kMostTypedAnswers + 3; ++i) {
        typed.type("x");
    }
    CHECK(typed.dropped() == 3);
    CHECK_FALSE(typed.listen(nullptr));
}

TEST_CASE("hearing lines: every order is read as it was written, on one line") {
    const WordGraph graph{{"the", "l'école \"x\"\n"}, {{0, 1, 0, 1.0}, {1, 2, kNone, 0.25}}, 3};
    const std::string line = write_line(HearingOrder(ListenLine{7, graph}));
    CHECK(line.find('\n') == std::string::npos);
    const ListenLine listen = again(ListenLine{7, graph});
    CHECK(listen.question == 7);
    CHECK(listen.graph.words == graph.words);
    CHECK(listen.graph.nodes == 3);
    REQUIRE(listen.graph.arcs.size() == 2);
    CHECK(listen.graph.arcs[1].word == kNone);
    CHECK(listen.graph.arcs[1].weight == 0.25);
    for (std::size_t n = 0; n < 6; ++n) {
        std::vector<std::int16_t> samples{0, -1, 32767, -32768, 256, 77};
        samples.resize(n);
        CHECK(again(AudioLine{8, samples}).samples == samples);
    }
    CHECK(again(EndLine{9}).question == 9);
    CHECK(again(StopLine{10}).question == 10);
    // As the page says it.
    CHECK(write_line(HearingOrder(AudioLine{3, {1, -2}})) == R"({"audio":3,"pcm":"AQD+/w=="})");
}

TEST_CASE("hearing lines: every answer is read as it was written") {
    CHECK(told_again(ReadyLine{"ear"}).name == "ear");
    CHECK(told_again(ReadyLine{"ear"}).form);
    CHECK_FALSE(told_again(ReadyLine{"ear", false}).form);
    CHECK(std::get<ReadyLine>(read_answer(R"({"ready":1,"name":"ear"})").value()).form);
    CHECK(std::get<ReadyLine>(read_answer(R"({"ready":1,"form":"no"})").value()).form);
    CHECK(told_again(ListeningLine{3, {"zyx"}}).unknown == std::vector<std::string>{"zyx"});
    CHECK(told_again(HeardLine{4, "the egg", 0.75}).throat == 0.0);
    CHECK(told_again(HeardLine{4, "the egg", 0.75, 1.2}).throat == 1.2);
    for (const char* odd : {"0.5", "2.5", "-1", "\"1.2\"", "null", "[1.2]"}) {
        const std::string line =
            std::string(R"({"heard":4,"text":"egg","confidence":1,"throat":)") + odd + "}";
        CHECK(std::get<HeardLine>(read_answer(line).value()).throat == 0.0);
    }
    const HeardLine heard = told_again(HeardLine{4, "the egg", 0.75});
    CHECK(heard.question == 4);
    CHECK(heard.text == "the egg");
    CHECK(heard.confidence == 0.75);
    CHECK(told_again(TroubleLine{"no ear"}).sentence == "no ear");
    // What is out of its range is brought into it.
    CHECK(
        std::get<HeardLine>(*read_answer(R"({"heard":1,"text":"a","confidence":7})")).confidence ==
        1.0);
}

TEST_CASE("hearing lines: what is no such line is refused") {
    for (const char* line : {"",
                             "null",
                             "[]",
                             "{",
                             "3",
                             R"({"listen":1})",
                             R"({"listen":1,"words":[1],"nodes":2,"arcs":[]})",
                             R"({"listen":1,"words":[],"nodes":2,"arcs":[[0,1,0]]})",
                             R"({"listen":1,"words":[],"nodes":2,"arcs":[[0,1,0,"x"]]})",
                             R"({"listen":1,"words":[],"nodes":2,"arcs":[[0,99999999999,0,1]]})",
                             R"({"listen":1,"words":[],"nodes":1e9,"arcs":[]})",
                             R"({"listen":99999999999})",
                             R"({"audio":1})",
                             R"({"audio":1,"pcm":"A"})",
                             R"({"audio":1,"pcm":"A==="})",
                             R"({"audio":1,"pcm":"AAA="} x)",
                             R"({"audio":1,"pcm":"AA=="})",
                             R"({"audio":1,"pcm":"A*BC"})",
                             R"({"end":"1"})",
                             R"({"a":[[[[[[]]]]]]})"}) {
        CAPTURE(line);
        CHECK_FALSE(read_order(line));
    }
    for (const char* line :
         {"", "{}", R"({"ready":2})", R"({"heard":1,"text":"a"})", R"({"heard":1,"confidence":1})",
          R"({"heard":1,"text":3,"confidence":1})"}) {
        CAPTURE(line);
        CHECK_FALSE(read_answer(line));
    }
    CHECK_FALSE(read_order("{\"end\":1," + std::string(kLongestLine_bytes, ' ') + "\"x\":1}"));
    CHECK(read_order(std::string(R"({"end":1,"x":)") + std::string(5, '[') + std::string(5, ']') +
                     "}")
              .has_value() == false);
}
