#include "dialogue/template/arc_writer.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("arc writer: nodes made in any order are numbered upwards") {
    TemplateSet set;
    ArcWriter writer(set, 100);
    const int end = writer.add_node();
    const int late = writer.add_node();
    const int start = writer.add_node();
    const int middle = writer.add_node();
    const int element = writer.add_element({});
    writer.add_arc(middle, late, element, {"two", "two", ErrorCode::none, 0, true});
    writer.add_arc(start, middle, element, {"one", "one", ErrorCode::none, 0, true});
    writer.join(late, end);
    writer.add_arc(start, late, element, {"both at once", "one two"});
    const Graph graph = writer.finish(start, end);
    REQUIRE(graph.nodes() == 4);
    REQUIRE(graph.arcs.size() == 4);
    for (const Arc& arc : graph.arcs) {
        CHECK(arc.from < arc.to);
    }
    CHECK(graph.arcs_from(graph.start()).size() == 2);
    CHECK(graph.arcs_from(graph.start())[1].word_count == 3);
    CHECK(graph.arcs_from(graph.end()).empty());
    CHECK(set.words.text(graph.said_by(graph.arcs_from(graph.start())[0])[0]) == "one");
}

TEST_CASE("arc writer: what can't be reached is dropped, and the budget holds") {
    TemplateSet set;
    ArcWriter writer(set, 2);
    const int start = writer.add_node();
    const int end = writer.add_node();
    const int nowhere = writer.add_node();
    const int element = writer.add_element({});
    writer.add_arc(start, end, element, {"a", "a"});
    CHECK_FALSE(writer.full());
    writer.add_arc(nowhere, end, element, {"b", "b"});
    CHECK(writer.full());
    writer.add_arc(start, end, element, {"c", "c"});
    writer.join(start, end);
    const Graph graph = writer.finish(start, end);
    CHECK(graph.arcs.size() == 1);
    CHECK(graph.nodes() == 2);
}

TEST_CASE("arc writer: a misspelling has no standing, a recast's word the most") {
    TemplateSet set;
    ArcWriter writer(set, 10);
    const int start = writer.add_node();
    const int end = writer.add_node();
    const int element = writer.add_element({});
    writer.add_arc(start, end, element, {"heavyest", "heaviest", ErrorCode::spelling, 10});
    writer.add_arc(start, end, element, {"most heavy", "heaviest", ErrorCode::adjective_form, 20});
    writer.add_arc(start, end, element, {"heaviest", "heaviest", ErrorCode::none, 0, true});
    const auto standing = [&](const char* word) {
        return set.standing[static_cast<std::size_t>(set.words.find(word))];
    };
    CHECK(standing("heavyest") == 0);
    CHECK(standing("most") == 1);
    CHECK(standing("heaviest") == 2);
}
