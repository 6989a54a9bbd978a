#include "dialogue/template/graph_builder.h"

#include "dialogue/template/sentences.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <set>

using namespace fulcrum::dialogue;

namespace {

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
