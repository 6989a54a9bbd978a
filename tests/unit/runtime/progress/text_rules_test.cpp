// Nicknames that are taken and refused, and learners' words that are mended.
#include "runtime/progress/text_rules.h"

#include "tests/unit/runtime/rig.h"

#include <random>

using namespace fulcrum::runtime::test;

TEST_CASE("nickname: 1 to 40 characters of any script, without blanks at its ends") {
    CHECK(checked_nickname("Mina") == "Mina");
    CHECK(checked_nickname("  Mina B. ") == "Mina B.");
    CHECK(checked_nickname("\u00A0민아\u3000") == "민아");
    CHECK(checked_nickname("🍉") == "🍉");
    std::string forty;
    for (int i = 0; i < 40; ++i) {
        forty += "é";
    }
    CHECK(checked_nickname(forty) == forty);
    CHECK_FALSE(checked_nickname(forty + "x"));
    for (const char* bad : {"", "   ", "\u3000"}) {
        CHECK_FALSE(checked_nickname(bad));
    }
}

TEST_CASE("nickname: control, hidden and reordering characters are refused") {
    for (const std::string& bad :
         {std::string("a\0b", 3), std::string("a\nb"), std::string("a\x1b[2J"),
          std::string("a\x7f"), std::string("a\u0085"), std::string("a\u200Bb"),
          std::string("a\u202Eb"), std::string("a\u2066b"), std::string("\uFEFFa"),
          std::string("a\u2028b")}) {
        CAPTURE(bad);
        CHECK_FALSE(checked_nickname(bad));
    }
}

TEST_CASE("UTF-8: only its shortest, complete forms of real characters are valid") {
    // Unicode 15.0, table 3-7: well-formed byte sequences, at the edges of each row.
    for (const std::string& good :
         {std::string(1, '\0'), std::string("\x7f"), std::string("\xC2\x80"),
          std::string("\xDF\xBF"), std::string("\xE0\xA0\x80"), std::string("\xED\x9F\xBF"),
          std::string("\xEE\x80\x80"), std::string("\xEF\xBF\xBF"), std::string("\xF0\x90\x80\x80"),
          std::string("\xF4\x8F\xBF\xBF")}) {
        CHECK(character_at(good, 0).valid);
        CHECK(character_at(good, 0).bytes == good.size());
    }
    for (const char* bad :
         {"\x80", "\xBF", "\xC0\x80", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xED\xBF\xBF",
          "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "\xC3", "\xE2\x82",
          "\xF0\x9F\x8D", "\xC3(", "\xE2(\xA1"}) {
        CAPTURE(bad);
        CHECK_FALSE(character_at(bad, 0).valid);
        CHECK(character_at(bad, 0).bytes == 1);
        CHECK_FALSE(checked_nickname(std::string("a") + bad));
    }
    CHECK(character_at("é", 0).code == 0xE9);
    CHECK(character_at("민", 0).code == 0xBBFC);
    CHECK(character_at("🍉", 0).code == 0x1F349);
}

TEST_CASE("kept text: any bytes become clean UTF-8, and mending twice changes nothing") {
    CHECK(kept_text("the heaviest, 민아!") == "the heaviest, 민아!");
    CHECK(kept_text("a\tb\xC3") == "a b\uFFFD");
    std::mt19937 random(3);
    for (int round = 0; round < 2'000; ++round) {
        std::string bytes(random() % 40, ' ');
        for (char& c : bytes) {
            c = static_cast<char>(random());
        }
        const std::string kept = kept_text(bytes);
        REQUIRE(kept_text(kept) == kept);
        for (std::size_t at = 0; at < kept.size();) {
            const Character character = character_at(kept, at);
            REQUIRE(character.valid);
            REQUIRE_FALSE(is_control(character.code));
            at += character.bytes;
        }
    }
}

TEST_CASE("kept text: is cut between two characters") {
    std::string long_text = "x";
    while (long_text.size() < 2 * kMaxKeptTextBytes) {
        long_text += "민";
    }
    const std::string kept = kept_text(long_text);
    CHECK(kept.size() == kMaxKeptTextBytes);  // 1 + 3 · 1333 = 4000
    CHECK(kept_text("y" + long_text).size() == kMaxKeptTextBytes - 2);
}

TEST_CASE("display width: Korean is two columns, accents none") {
    CHECK(display_width("abc") == 3);
    CHECK(display_width("민아") == 4);
    CHECK(display_width("e\u0301") == 1);
    CHECK(display_width("🍉") == 2);
}
