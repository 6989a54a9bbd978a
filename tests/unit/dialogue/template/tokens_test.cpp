#include "dialogue/template/tokens.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

namespace {
std::string joined(std::string_view text) {
    std::string result;
    for (const std::string& word : words_of(text)) {
        result += (result.empty() ? "" : " ") + word;
    }
    return result;
}
}  // namespace

TEST_CASE("tokens: case, punctuation, spaces and apostrophes don't matter") {
    const std::pair<const char*, const char*> rows[] = {
        {"The WATERMELON, is  heavy!", "the watermelon is heavy"},
        {"", ""},
        {" \t\r\n.,;!?", ""},
        {"It's", "it is"},
        {"It’s", "it is"},
        {"it`s", "it is"},
        {"they're", "they are"},
        {"I'm", "i am"},
        {"isn't", "is not"},
        {"can't", "can not"},
        {"won't", "will not"},
        {"don’t", "do not"},
        {"let's", "let us"},
        {"watermelon's", "watermelon is"},
        {"watermelons'", "watermelons"},
        {"'quoted'", "quoted"},
        {"o'clock", "oclock"},
        {"ice-cream", "ice cream"},
        {"well—done", "well done"},
        {"“yes”", "yes"},
        {"8", "eight"},
        {"21 moons", "twenty one moons"},
        {"3.5", "three point five"},
        {"end.5", "end five"},
        {"3.0", "three"},
        {"3.00 moons", "three moons"},
        {"3.", "three"},
        {"-3", "minus three"},
        {"it has -3 moons", "it has minus three moons"},
        {"\xE2\x88\x92 3", "three"},
        {"\xE2\x88\x92"
         "3",
         "minus three"},
        {"2-3", "two three"},
        {"sun-3", "sun three"},
        {"- 3", "three"},
        {"1,000", "one thousand"},
        {"145,000 km", "one hundred and forty five thousand km"},
        {"1,00", "one zero"},
        {"2020,100", "two thousand and twenty one hundred"},
        {"1234567", "1234567"},
        {"007", "seven"},
        {"5kg", "five kg"},
        {"É", "é"},
        {"수박", "수박"},
        {"a\x01"
         "b",
         "a b"},
        {"a\xFF"
         "b",
         "a b"},
        {"\xC3", ""},
        {"\xE2\x82", ""}};
    for (const auto& [text, words] : rows) {
        INFO(text);
        CHECK(joined(text) == words);
    }
}

TEST_CASE("tokens: each knows the bytes it came from") {
    const std::string text = "So, it’s THE 21st isn’t";
    const auto tokens = tokenise(text);
    const std::vector<std::pair<std::string, std::string>> expected = {
        {"so", "So"},  {"it", "it"}, {"is", "’s"}, {"the", "THE"}, {"twenty", "21"},
        {"one", "21"}, {"st", "st"}, {"is", "is"}, {"not", "n’t"}};
    REQUIRE(tokens.size() == expected.size());
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        CHECK(tokens[i].text == expected[i].first);
        INFO(tokens[i].text);
        CHECK(text.substr(tokens[i].begin, tokens[i].end - tokens[i].begin) == expected[i].second);
    }
}

TEST_CASE("tokens: any bytes give words inside the text, in order") {
    CHECK(rc::check([](const std::string& text) {
        std::size_t last = 0;
        for (const Token& token : tokenise(text)) {
            RC_ASSERT(!token.text.empty());
            RC_ASSERT(token.begin <= token.end);
            RC_ASSERT(token.end <= text.size());
            RC_ASSERT(token.begin >= last || token.begin + 6 >= last);
            last = token.begin;
        }
    }));
}

TEST_CASE("tokens: it's got is it has got, and it's hot is it is hot") {
    CHECK(words_of("It's got two") == std::vector<std::string>{"it", "has", "got", "two"});
    CHECK(words_of("it is got") == std::vector<std::string>{"it", "is", "got"});
    CHECK(words_of("it's hot") == std::vector<std::string>{"it", "is", "hot"});
}

TEST_CASE("tokens: words between blanks, and a text without the blanks around it") {
    CHECK(words_between_blanks("It's  the EGG!") == " it is the egg ");
    CHECK(words_between_blanks("") == " ");
    CHECK(without_blanks("  an egg ") == "an egg");
    CHECK(without_blanks("\tan egg\r\n") == "an egg");
    CHECK(without_blanks("   ").empty());
    CHECK(without_blanks("").empty());
}
