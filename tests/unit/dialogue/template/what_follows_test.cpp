#include "dialogue/template/what_follows.h"

#include <catch2/catch.hpp>

#include <stdexcept>

using namespace fulcrum::dialogue;

namespace {

Syntax parsed(std::string_view text) {
    auto syntax = parse_template(text);
    if (!syntax) {
        throw std::runtime_error(syntax.error().message);
    }
    return *syntax;
}

/// The first part of a template's own sequence.
const SyntaxNode& first_of(const Syntax& syntax) {
    const SyntaxNode& whole = unwrapped(syntax, 0);
    return whole.kind == SyntaxNode::Kind::sequence ? unwrapped(syntax, whole.children[0]) : whole;
}

bool closes(std::string_view next) {
    const Syntax syntax = parsed(next);
    return closes_phrase(syntax, &first_of(syntax), false);
}

bool optional_noun(std::string_view text) {
    const Syntax syntax = parsed(text);
    return is_optional_noun(syntax, &first_of(syntax));
}

bool than(std::string_view text) {
    const Syntax syntax = parsed(text);
    return begins_with_than(syntax, &first_of(syntax));
}

}  // namespace

TEST_CASE("what follows: a phrase ends at a verb, a preposition but of, and where all ends") {
    CHECK(closes("is heavy"));
    CHECK(closes("[is heavy] now"));
    CHECK(closes("[in the room] now"));
    CHECK_FALSE(closes("of all now"));
    CHECK_FALSE(closes("[of all] now"));
    CHECK_FALSE(closes("one now"));
    CHECK_FALSE(closes("{list} now"));
    const Syntax syntax = parsed("egg");
    CHECK(closes_phrase(syntax, nullptr, true));
    CHECK_FALSE(closes_phrase(syntax, nullptr, false));
}

TEST_CASE("what follows: behind a word for how much a noun has no article") {
    const auto none = [](std::string_view text) { return takes_no_article(parsed(text), 0); };
    for (const char* much : {"no", "enough", "not any", "(no|too little)", "there is no"}) {
        INFO(much);
        CHECK(none(much));
    }
    for (const char* other : {"the", "(no|the)", "no egg", "[no]", "{no}"}) {
        INFO(other);
        CHECK_FALSE(none(other));
    }
}

TEST_CASE("what follows: nouns that may be said, and than") {
    CHECK(optional_noun("[one|object] is"));
    CHECK(optional_noun("[one]"));
    CHECK_FALSE(optional_noun("[is|object] one"));
    CHECK_FALSE(optional_noun("one"));
    CHECK(than("[than the egg] now"));
    CHECK(than("than"));
    CHECK_FALSE(than("[of all]"));
    const Syntax syntax = parsed("big egg");
    CHECK(may_be_noun(first_of(syntax)));
    CHECK_FALSE(is_head_noun(first_of(syntax), &syntax.back()));
    CHECK(is_head_noun(syntax.back(), nullptr));
}
