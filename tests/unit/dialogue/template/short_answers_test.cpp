#include "dialogue/template/short_answers.h"

#include "dialogue/template/matcher.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("short answers: what is turned round comes last and is taken for nothing else") {
    const Question question = made_of_what();
    const TemplateSet& set = *question.templates;
    const auto turned = match(set, "wood is made of a table");
    REQUIRE(turned);
    const Graph& graph = set.graphs[static_cast<std::size_t>(turned->graph)];
    CHECK(graph.turned_round);
    CHECK_FALSE(graph.short_answer);
    const auto behind = set.graphs.begin() + turned->graph + 1;
    CHECK(std::none_of(behind, set.graphs.end(), [](const Graph& other) {
        return other.short_answer && other.claim == Claim::same;
    }));
    CHECK(turned->slots == std::vector<std::pair<std::string, std::string>>{{"thing", "wood"},
                                                                            {"material", "table"}});
    // The thing is what stands before, whatever follows.
    const TemplateSet more =
        compiled_templates({{"{thing} <made_of:{material}> like {thing:other}"}, textures(), {}});
    REQUIRE(match(more, "wood is made of a table"));
    CHECK(match(more, "wood is made of a table")->slots[0].first == "thing");
    // Where the thing isn't asked for, or both come from one list, there is nothing to turn round.
    const Question spaceship = spaceship_of_what();
    for (const Graph& one : spaceship.templates->graphs) {
        CHECK_FALSE(one.turned_round);
    }
    const TemplateSet same =
        compiled_templates({{"{material:thing} <made_of:{material}>"}, textures(), {}});
    CHECK_FALSE(same.graphs.back().turned_round);
    CHECK(match(same, "paper is made of wood"));
}
