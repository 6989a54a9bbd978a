#include "dialogue/template/tokens.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

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
