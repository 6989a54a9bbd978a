#include "dialogue/template/syntax.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

using Kind = SyntaxNode::Kind;

/// The tree as text: s(…) a(…) p(…) o(…) words, {list:slot}, <rule:word>.
std::string shown(const Syntax& syntax, int index = 0) {
    const SyntaxNode& node = syntax[static_cast<std::size_t>(index)];
    std::string inside;
    for (const int child : node.children) {
        CHECK(child > index);
        inside += (inside.empty() ? "" : " ") + shown(syntax, child);
    }
    const std::string argument = node.argument.empty() ? "" : ":" + node.argument;
    switch (node.kind) {
        case Kind::sequence:
            return node.children.size() == 1 ? inside : "s(" + inside + ")";
        case Kind::alternatives:
            return node.children.size() == 1 ? inside : "a(" + inside + ")";
        case Kind::permutation:
            return "p(" + inside + ")";
        case Kind::optional:
            return "o(" + inside + ")";
        case Kind::word:
            return node.text;
        case Kind::list:
            return "{" + node.text + argument + "}";
        case Kind::rule:
            return "<" + node.text + argument + (inside.empty() ? "" : ":" + inside) + ">";
    }
    return "?";
}

std::string parsed(std::string_view text) {
    const auto syntax = parse_template(text);
    return syntax ? shown(*syntax) : syntax.error().message;
}

}  // namespace

TEST_CASE("syntax: every construct becomes its node") {
    CHECK(parsed("It's big!") == "s(it is big)");
    CHECK(parsed("[a|an|the] {thing} is") == "s(o(a(a an the)) {thing} is)");
    CHECK(parsed("(big|very big)") == "a(big s(very big))");
    CHECK(parsed("(a;b c;d)") == "p(a s(b c) d)");
    CHECK(parsed("{list:slot} { other }") == "s({list:slot} {other})");
    CHECK(parsed("<superlative:heavy> <rule>") == "s(<superlative:heavy> <rule>)");
    CHECK(parsed("<made_of:{material}> <adjective: { feel : other } >x") ==
          "s(<made_of:{material}> <adjective:{feel:other}> x)");
    CHECK(parsed("a [b [c (d|e)]]") == "s(a o(s(b o(s(c a(d e))))))");
    CHECK(parsed("yes|no") == "a(yes no)");
    CHECK(parsed("\\[ five \\]") == "five");
    CHECK(parsed("") == "s()");
    CHECK(parsed("[|b]") == "o(a(s() b))");
}

TEST_CASE("syntax: mistakes are told with their column") {
    const struct {
        const char* text;
        const char* part;
        int column;
    } rows[] = {
        {"a [b", "never closed; add ']'", 3},
        {"(a|b", "never closed; add ')'", 1},
        {"a {thing", "never closed; add '}'", 3},
        {"a <rule", "never closed; add '>'", 3},
        {"a ] b", "']' closes nothing", 3},
        {"a) b", "')' closes nothing", 2},
        {"a } b", "'}' closes nothing", 3},
        {"(a]", "']' closes nothing", 3},
        {"{}", "is empty", 2},
        {"{ }", "is empty", 2},
        {"<a b>", "where a colon belongs", 2},
        {"{thing:}", "missing after ':'", 8},
        {"<superlative:>", "missing after ':'", 14},
        {"{a:b c}", "missing after ':'", 4},
        {"<made_of:{material>", "never closed; add '}'", 10},
        {"<made_of:{material}", "never closed; add '>'", 1},
        {"<made_of:{}>", "is empty", 11},
        {"<made_of:{a} {b}>", "only one {list}", 13},
        {"<made_of:{a}b>", "only one {list}", 13},
        {"<made_of:{a> b}", "a name", 11},
        {"<made_of:b{a}>", "missing after ':'", 10},
        {"(a|b;c)", "mixed", 5},
        {"light[s]", "space is missing before", 6},
        {"[un]happy", "space is missing after", 5},
        {"(a;b;c;d;e)", "more than 4 parts", 1},
        {"a \\", "stands at the end", 3},
    };
    for (const auto& row : rows) {
        INFO(row.text);
        const auto syntax = parse_template(row.text);
        REQUIRE_FALSE(syntax);
        CHECK_THAT(syntax.error().message, Catch::Contains(row.part));
        CHECK(syntax.error().column == row.column);
    }
}

TEST_CASE("syntax: hostile depth and length are refused") {
    CHECK(parse_template(std::string(24, '[') + "a" + std::string(24, ']')));
    CHECK_FALSE(parse_template(std::string(25, '[') + "a" + std::string(25, ']')));
    CHECK_FALSE(parse_template(std::string(4000, '(')));
    CHECK_FALSE(parse_template(std::string(5000, 'a')));
    CHECK_FALSE(parse_template(std::string(1 << 20, '[')));
}

TEST_CASE("syntax: a blank instead of a colon, and what is no name, are told with what to write") {
    struct {
        const char *text, *said;
        int column;
    } const rows[] = {
        {"it is the <superlative heavy>",
         "<superlative heavy> has a space where a colon belongs; write <superlative:heavy>", 12},
        {"it is <adjective {feel}>",
         "<adjective {feel}> has a space where a colon belongs; write <adjective:{feel}>", 8},
        {"the {thing other}",
         "{thing other} has a space where a colon belongs; write {thing:other}", 6},
        {"it is <>", "<> is empty; write a form of grammar with its word, such as", 8},
        {"it is {}", "{} is empty; write the name of a list", 8},
        {"it is <most heavy thing>", "<most heavy thing> is no form of grammar and no rule", 8},
        {"it is {big-ger}", "{big-ger} is no list: a name has letters, digits and _", 8},
    };
    for (const auto& row : rows) {
        const auto parsed = parse_template(row.text);
        INFO(row.text);
        REQUIRE_FALSE(parsed);
        INFO(parsed.error().message);
        CHECK(parsed.error().message.starts_with(row.said));
        CHECK(parsed.error().column == row.column);
    }
}
