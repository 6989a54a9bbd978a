#include "dialogue/speech/external/hearing_lines.h"

#include <catch2/catch.hpp>

#include <limits>

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
