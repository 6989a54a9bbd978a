#include "dialogue/marked_text.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

TEST_CASE("marked text: asterisks part what is strong") {
    const MarkedText text = part_emphasis("A watermelon is *the heaviest*.");
    CHECK(text.plain == "A watermelon is the heaviest.");
    REQUIRE(text.strong.size() == 1);
    CHECK(text.plain.substr(text.strong[0].first, text.strong[0].second - text.strong[0].first) ==
          "the heaviest");
    CHECK(part_emphasis("*a* b *c*").strong ==
          std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {4, 5}});
}

TEST_CASE("marked text: single and empty asterisks") {
    CHECK(part_emphasis("").plain.empty());
    CHECK(part_emphasis("2 * 3").plain == "2 * 3");
    CHECK(part_emphasis("2 * 3").strong.empty());
    CHECK(part_emphasis("a ** b").plain == "a  b");
    CHECK(part_emphasis("a ** b").strong.empty());
    CHECK(part_emphasis("*a* *").plain == "a *");
}

TEST_CASE("marked text: ranges lie in order inside any text") {
    CHECK(rc::check([](const std::string& any) {
        const MarkedText text = part_emphasis(any);
        std::size_t last = 0;
        for (const auto& [begin, end] : text.strong) {
            RC_ASSERT(last <= begin);
            RC_ASSERT(begin < end);
            RC_ASSERT(end <= text.plain.size());
            last = end;
        }
    }));
}
