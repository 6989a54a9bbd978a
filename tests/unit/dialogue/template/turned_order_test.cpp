#include "dialogue/template/turned_order.h"

#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

TEST_CASE(
    "turned order: a comparison that stands first is understood, and said back in its place") {
    check_rows(heavier(), {{"heavier is the apple", "R:WO", "*An apple is heavier*."},
                           {"is heavier the apple", "R:WO", "*An apple is heavier*."},
                           {"heavier is the apple than the egg", "R:WO",
                            "*An apple is heavier than an egg*."}});
}

TEST_CASE(
    "turned order: nothing is turned behind a pronoun, without a comparison or without room") {
    const auto none_turned = [](const TemplateSource& source) {
        const TemplateSet set = compiled_templates(source);
        return std::none_of(set.graphs.begin(), set.graphs.end(),
                            [](const Graph& graph) { return graph.nearly; });
    };
    CHECK(none_turned({{"it is <comparative:heavy>"}, {}, {}}));
    CHECK(none_turned(
        {{"the {thing} is {colour}"}, {{"thing", {"egg"}}, {"colour", {"red", "blue"}}}, {}}));
    CHECK_FALSE(none_turned({{"the {thing} is <comparative:heavy>"}, {{"thing", {"egg"}}}, {}}));
}
