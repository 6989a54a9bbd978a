#include "dialogue/template/what_follows.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("what follows: where all ends a phrase does, and the last noun is its head") {
    const auto syntax = parse_template("big egg");
    REQUIRE(syntax);
    CHECK(closes_phrase(*syntax, nullptr, true));
    CHECK_FALSE(closes_phrase(*syntax, nullptr, false));
    const SyntaxNode& egg = syntax->back();
    const SyntaxNode& big = unwrapped(*syntax, unwrapped(*syntax, 0).children[0]);
    CHECK(may_be_noun(big));
    CHECK_FALSE(is_head_noun(big, &egg));
    CHECK(is_head_noun(egg, nullptr));
}
