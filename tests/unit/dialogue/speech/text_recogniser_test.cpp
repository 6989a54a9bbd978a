#include "dialogue/speech/text/text_recogniser.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

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
