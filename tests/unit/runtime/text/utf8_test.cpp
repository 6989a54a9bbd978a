#include "runtime/text/utf8.h"

#include <catch2/catch.hpp>

#include <random>
#include <string>

using namespace fulcrum::runtime;

TEST_CASE("utf8: well-formed text comes through") {
    CHECK(decode_for_display("apple") == U"apple");
    CHECK(decode_for_display("caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8D\x8E") ==
          U"caf\u00E9 \u20AC \U0001F34E");
    CHECK(decode_for_display("a\nb\tc") == U"a\nb c");
}

TEST_CASE("utf8: ill-formed bytes become one replacement each") {
    CHECK(decode_for_display("a\x80z") == U"a\uFFFDz");
    CHECK(decode_for_display("\xC3") == U"\uFFFD");
    CHECK(decode_for_display("\xC0\x80") == U"\uFFFD\uFFFD");            // overlong
    CHECK(decode_for_display("\xED\xA0\x80") == U"\uFFFD\uFFFD\uFFFD");  // surrogate
    CHECK(decode_for_display("\xF4\x90\x80\x80") == U"\uFFFD\uFFFD\uFFFD\uFFFD");
    CHECK(decode_for_display("\xE2\x82z") == U"\uFFFD\uFFFDz");
}

TEST_CASE("utf8: what draws nothing or turns text around is left out") {
    CHECK(decode_for_display(std::string("a\0b\x07\x1B[31m\x7F", 10)) == U"ab[31m");
    CHECK(decode_for_display("x\xE2\x80\xAEy\xE2\x80\x8Bz\xEF\xBB\xBF") == U"xyz");
}

TEST_CASE("utf8: code points of every length are encoded as they were") {
    const std::string all =
        "a~\xC2\xA1\xDF\xBF\xE0\xA0\x80\xEF\xBF\xBD\xF0\x90\x80\x80\xF3\x9F\xBF\xBF";
    std::string back;
    for (const char32_t c : decode_for_display(all)) {
        append_utf8(back, c);
    }
    CHECK(back == all);
}

TEST_CASE("utf8: any bytes are decoded, and never into more than the limit") {
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
        std::string bytes(random() % 300, '\0');
        for (char& byte : bytes) {
            byte = static_cast<char>(random());
        }
        CHECK(decode_for_display(bytes).size() <= bytes.size());
    }
    CHECK(decode_for_display(std::string(1'000'000, 'w')).size() == kMostCodePoints);
}
