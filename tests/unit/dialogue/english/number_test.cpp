#include "dialogue/english/number.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::dialogue;

namespace {
std::string in_words(long number) {
    std::string text;
    for (const std::string& word : number_words(number)) {
        text += (text.empty() ? "" : " ") + word;
    }
    return text;
}
}  // namespace

TEST_CASE("number: in words") {
    CHECK(in_words(0) == "zero");
    CHECK(in_words(8) == "eight");
    CHECK(in_words(13) == "thirteen");
    CHECK(in_words(20) == "twenty");
    CHECK(in_words(21) == "twenty one");
    CHECK(in_words(100) == "one hundred");
    CHECK(in_words(105) == "one hundred and five");
    CHECK(in_words(342) == "three hundred and forty two");
    CHECK(in_words(1000) == "one thousand");
    CHECK(in_words(1005) == "one thousand and five");
    CHECK(in_words(1050) == "one thousand and fifty");
    CHECK(in_words(1100) == "one thousand one hundred");
    CHECK(in_words(2340) == "two thousand three hundred and forty");
    CHECK(in_words(999'999) ==
          "nine hundred and ninety nine thousand nine hundred and ninety nine");
}

TEST_CASE("number: outside the range there are no words") {
    CHECK(number_words(-1).empty());
    CHECK(number_words(1'000'000).empty());
}

TEST_CASE("number: all numbers below a thousand differ in words") {
    std::string last;
    for (long number = 0; number < 1000; ++number) {
        const std::string words = in_words(number);
        CHECK(words != last);
        last = words;
    }
}

TEST_CASE("number: its words are known, others are not") {
    for (const char* word : {"zero", "one", "nineteen", "ninety", "hundred", "thousand"}) {
        CHECK(is_number_word(word));
    }
    for (const char* word : {"", "and", "onion", "a"}) {
        CHECK_FALSE(is_number_word(word));
    }
}
