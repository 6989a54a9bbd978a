#include "dialogue/unicode.h"

#include "dialogue/english/letters.h"
#include "dialogue/template/tokens.h"

#include <catch2/catch.hpp>

#include <random>

using namespace fulcrum::dialogue;

namespace {

constexpr char32_t kLastCode = 0x10FFFF;

bool is_surrogate(char32_t code) {
    return code >= 0xD800 && code <= 0xDFFF;
}

std::string of(char32_t code) {
    std::string text;
    append_utf8(text, code);
    return text;
}

}  // namespace

TEST_CASE("unicode: only the shortest, complete forms of real characters are valid") {
    // Unicode, table 3-7: well-formed byte sequences, at the edges of each row.
    for (const std::string& good :
         {std::string(1, '\0'), std::string("\x7f"), std::string("\xC2\x80"),
          std::string("\xDF\xBF"), std::string("\xE0\xA0\x80"), std::string("\xED\x9F\xBF"),
          std::string("\xEE\x80\x80"), std::string("\xEF\xBF\xBF"), std::string("\xF0\x90\x80\x80"),
          std::string("\xF4\x8F\xBF\xBF")}) {
        CAPTURE(good);
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
        CHECK(character_at(bad, 0).code == kReplacement);
    }
    CHECK(character_at("é", 0).code == 0xE9);
    CHECK(character_at("a민", 1).code == 0xBBFC);
    CHECK(character_at("🍉", 0).code == 0x1F349);
}

TEST_CASE("unicode: every code point is written as it is read, and nothing else is written") {
    bool same = true;
    for (char32_t code = 0; code <= kLastCode; ++code) {
        const std::string text = of(code);
        same &= is_surrogate(code) ? text.empty()
                                   : character_at(text, 0).code == code &&
                                         character_at(text, 0).bytes == text.size();
    }
    CHECK(same);
    CHECK(of(kLastCode + 1).empty());
    CHECK(of(0xFFFFFFFF).empty());
}

TEST_CASE("unicode: a text is cut between characters") {
    const std::string text = "aé민🍉";  // 1, 2, 3 and 4 bytes
    for (const auto& [most, kept] : std::vector<std::pair<std::size_t, std::size_t>>{
             {0, 0}, {1, 1}, {2, 1}, {3, 3}, {5, 3}, {6, 6}, {7, 6}, {9, 6}, {10, 10}, {99, 10}}) {
        CAPTURE(most);
        CHECK(whole_characters(text, most) == text.substr(0, kept));
    }
    // A byte that belongs to none is cut nowhere else.
    CHECK(whole_characters("a\x80\x80\x80\x80", 3) == "a\x80\x80");
}

TEST_CASE("unicode: what looks the same is the same in NFC") {
    CHECK(composed("cafe\u0301") == "café");
    CHECK(composed("café") == "café");
    CHECK(composed("\u1106\u1175\u11AB") == "민");
    CHECK(composed("\u212B") == "Å");
    CHECK(composed("a\u0323\u0302") == composed("\u1EAD"));
    CHECK(composed("a\u0302\u0323") == "\u1EAD");
    CHECK(composed("") == "");
    CHECK(composed("plain") == "plain");
    CHECK(composed(std::string("e\u0301\0x", 5)) == std::string("é\0x", 4));
    // What is no UTF-8 is nobody's to compose; forms that only look alike stay apart.
    CHECK(composed("e\u0301\xFF") == "e\u0301\xFF");
    CHECK(composed("\uFB01 ²") == "\uFB01 ²");
    std::mt19937 random(5);
    for (int round = 0; round < 2'000; ++round) {
        std::string text;
        for (int i = 0; i < 8; ++i) {
            append_utf8(text, static_cast<char32_t>(random() % 0x3100));
        }
        const std::string once = composed(text);
        REQUIRE(composed(once) == once);
    }
}

TEST_CASE("unicode: capitals of all alphabets are folded, by no language's own rule") {
    CHECK(folded("ÉCOLE") == "école");
    CHECK(folded("STRASSE") == folded("straße"));
    CHECK(folded("STRA\u1E9EE") == "strasse");
    CHECK(folded("МОСКВА") == "москва");
    CHECK(folded("ΟΔΟΣ") == folded("οδος"));
    CHECK(folded("οδος") == folded("οδοσ"));
    CHECK(folded("I") == "i");                        // also in Turkish
    CHECK(folded("ı") == "ı");                        // no capital of which is "I"
    CHECK(folded("İ") == "i\u0307");                  // a dotted capital keeps its dot
    CHECK(folded("\u0390") == "\u03B9\u0308\u0301");  // the longest: three characters
    CHECK(folded("민아 3 🍉") == "민아 3 🍉");
    CHECK(folded("A\xFF") == "a\uFFFD");
    // The words of an answer.
    CHECK(words_of("L'ÉCOLE, DIE STRASSE") == words_of("l'école, die Straße"));
    bool twice = true;
    for (char32_t code = 0; code <= kLastCode; ++code) {
        twice &= is_surrogate(code) || folded(folded(of(code))) == folded(of(code));
    }
    CHECK(twice);
}

TEST_CASE("letters: a word in small letters has as many bytes as before") {
    CHECK(lower_case("Éclair ΟΔ 민 A\xFFZ") == "éclair οδ 민 a\xFFz");
    CHECK(lower_case("İ\u1E9E\u212A") == "İ\u1E9E\u212A");  // their small letters are shorter
    bool same = true;
    for (char32_t code = 0; code <= kLastCode; ++code) {
        const std::string letter = of(code);
        const std::string small = lower_case(letter);
        same &= small.size() == letter.size() && lower_case(small) == small;
    }
    CHECK(same);
}

TEST_CASE("unicode: Korean and pictures are two columns, accents none") {
    CHECK(columns_of('a') == 1);
    CHECK(columns_of(U'é') == 1);
    CHECK(columns_of(U'민') == 2);
    CHECK(columns_of(U'水') == 2);
    CHECK(columns_of(U'Ａ') == 2);
    CHECK(columns_of(0x1F349) == 2);
    CHECK(columns_of(0x0301) == 0);
    CHECK(columns_of(0x20D7) == 0);
    CHECK(columns_of(kReplacement) == 1);
}
