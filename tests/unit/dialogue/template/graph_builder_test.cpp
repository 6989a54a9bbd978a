#include "dialogue/template/graph_builder.h"

#include "dialogue/template/matcher.h"
#include "dialogue/template/sentences.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <set>

using namespace fulcrum::dialogue;

namespace {

/// How what was said is put right by a template, with what it costs.
std::string put_right(const std::string& text, std::string_view said) {
    const TemplateSet set = compiled_templates({{text}, {}, {}});
    const auto parse = match(set, said);
    return parse ? render(parse->pieces) + " " + std::to_string(parse->cost) : "?";
}

/// All right sentences of the first graph, by trying every series of choices.
std::set<std::string> sentences(const std::string& text, const NamedTexts& rules = {}) {
    const TemplateSet set = compiled_templates({{text}, {{"n", {"two", "three"}}}, rules});
    std::set<std::string> result;
    for (unsigned seed = 0; seed < 4096; ++seed) {
        unsigned rest = seed;
        const Sample sample = walk(set, 0, false, [&](std::size_t ways) {
            const std::size_t choice = rest % ways;
            rest /= static_cast<unsigned>(ways);
            return choice;
        });
        result.insert(sample.said);
    }
    return result;
}

using Sentences = std::set<std::string>;

}  // namespace

TEST_CASE("graph builder: brackets, alternatives, orders, lists and rules make their sentences") {
    CHECK(sentences("go [now]") == Sentences{"go", "go now"});
    CHECK(sentences("(go|run) home") == Sentences{"go home", "run home"});
    CHECK(sentences("go [now|then]") == Sentences{"go", "go now", "go then"});
    CHECK(sentences("(go;now)") == Sentences{"go now", "now go"});
    CHECK(sentences("(x;y;z)").size() == 6);
    CHECK(sentences("yes|no") == Sentences{"yes", "no"});
    CHECK(sentences("<r> home", {{"r", "go|run"}}) == Sentences{"go home", "run home"});
    CHECK(sentences("go [[now] home]") == Sentences{"go", "go home", "go now home"});
    CHECK(sentences("go {n}").count("go two") == 1);
}

TEST_CASE("graph builder: slots are known as possible and as required") {
    const auto masks = [](const std::string& text) {
        const TemplateSet set = compiled_templates({{text}, {{"a", {"x"}}, {"b", {"y"}}}, {}});
        return std::pair(set.graphs[0].slots, set.graphs[0].required);
    };
    CHECK(masks("{a} {b}") == std::pair(3U, 3U));
    CHECK(masks("{a} [{b}]") == std::pair(3U, 1U));
    CHECK(masks("go ({a}|{b})") == std::pair(3U, 0U));
    CHECK(masks("({a} {b}|{a})") == std::pair(3U, 1U));
    CHECK(masks("({a};{b})") == std::pair(3U, 3U));
}

TEST_CASE("graph builder: the article before a list is the list's, before other words its own") {
    const TemplateSet set =
        compiled_templates({{"the {n} is a <comparative:old> one"}, {{"n", {"egg"}}}, {}});
    const auto parse = match(set, "the egg is a older one");
    REQUIRE(parse);
    CHECK(render(parse->pieces) == "The egg is an older one.");
    CHECK(parse->cost > 0);
    CHECK(match(set, "the egg is an older one")->cost == 0);
}

TEST_CASE(
    "graph builder: this and these may stand where the template has an article before a plain "
    "noun") {
    for (const char* text :
         {"the big egg is here", "(the|a) big egg is here", "[a|the] big egg is here"}) {
        INFO(text);
        CHECK(put_right(text, "this big egg is here") == "This big egg is here. 0");
        CHECK(put_right(text, "that big egg is here") == "That big egg is here. 0");
        CHECK(put_right(text, "these big egg is here") == "This big egg is here. 10");
    }
    CHECK(put_right("look at the eggs", "look at these eggs") == "Look at these eggs. 0");
    CHECK(put_right("look at the eggs", "look at this eggs") == "Look at these eggs. 10");
    // Only before a noun: "this heaviest" and "this to" are no English.
    CHECK(put_right("it is the <superlative:heavy>", "it is this heaviest") == "?");
    CHECK(put_right("the is here", "this is here") == "?");
}

TEST_CASE("graph builder: a material that begins a sentence may be pointed at") {
    const char* text = "metal is <comparative:hard> than wood";
    CHECK(put_right(text, "this metal is harder than that wood") ==
          "This metal is harder than that wood. 0");
    CHECK(put_right(text, "the metal is harder than the wood") ==
          "The metal is harder than the wood. 0");
    CHECK(put_right(text, "these metal is harder than wood") ==
          "This metal is harder than wood. 10");
    CHECK(put_right(text, "metal is harder than wood") == "Metal is harder than wood. 0");
    CHECK(put_right("grey metal is here", "grey this metal is here") == "?");
    CHECK(put_right("stone is here", "this stone is here") == "?");
}
