#include "dialogue/template/sentence_parts.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("sentence parts: where the verb stands, what is compared, and with what") {
    const TemplateSet set = compiled_templates(
        {{"[the] {thing} is <comparative:heavy>"}, {{"thing", {"red block", "blue block"}}}, {}});
    const std::string text = "[the] {thing} (is|looks) <comparative:heavy> from here [than that]";
    const auto syntax = parse_template(text);
    REQUIRE(syntax);
    const ParsedRules rules;
    const SentenceParts parts(set, rules, text, *syntax);
    REQUIRE(parts.size() == 7);
    CHECK(parts.text(0, 2) == "[the] {thing}");
    CHECK(parts.is_be(2));
    CHECK(parts.be(2) == "is");
    CHECK(parts.form(3) == "comparative");
    CHECK(parts.adjectives(3, "comparative") == std::vector<std::string>{"heavy"});
    CHECK(parts.adjectives(3, "superlative").empty());
    CHECK(parts.than_at(3) == 6);
    CHECK(parts.begins_with(6, "than"));
    CHECK(parts.slots(0, 7) == std::vector<std::string>{"thing"});
    CHECK(parts.head_of("thing") == "block");
    CHECK(parts.same_words("thing", "thing"));
    CHECK(parts.list_of("other") == nullptr);
    CHECK(parts.is_plain_statement());
}
