#include "dialogue/speech/word_graph.h"

#include "dialogue/template/compile.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace fulcrum::dialogue;

namespace {

TemplateSet compile(const std::vector<std::string>& sentences) {
    TemplateSource source;
    source.sentences = sentences;
    source.lists = {{"thing", {"watermelon", "apple", "egg"}}};
    return compile_templates(source).value();
}

// All sentences of a graph that is small.
std::multiset<std::string> sentences_of(const WordGraph& graph, int node = 0,
                                        const std::string& said = "") {
    if (node == graph.nodes - 1) {
        return {said};
    }
    std::multiset<std::string> all;
    for (const WordGraph::Arc& arc : graph.arcs) {
        if (arc.from == node) {
            const std::string word =
                arc.word == kNone ? "" : graph.words[static_cast<std::size_t>(arc.word)];
            all.merge(sentences_of(graph, arc.to,
                                   said + (said.empty() || word.empty() ? "" : " ") + word));
        }
    }
    return all;
}

}  // namespace

TEST_CASE("word graph: has what is right, what learners say, and nothing that cannot be heard") {
    const WordGraph graph = make_word_graph(compile({"the {thing} is the <superlative:heavy>"}));
    const auto said = sentences_of(graph);
    CHECK(said.contains("the watermelon is the heaviest"));
    CHECK(said.contains("the egg is the most heavy"));
    CHECK(said.contains("egg is heaviest"));
    CHECK(said.contains("the apple"));  // a short answer
    CHECK_FALSE(said.contains(""));
    // Spelt otherwise, said alike.
    CHECK_FALSE(said.contains("the egg is the heavyest"));
    // Another sentence than the template's.
    CHECK_FALSE(said.contains("the heaviest is the egg"));
}

TEST_CASE("word graph: what sounds alike is heard as what is right") {
    const auto said =
        sentences_of(make_word_graph(compile({"the {thing} is <comparative:heavy> than the egg"})));
    CHECK(said.contains("the apple is heavier than the egg"));
    CHECK(said.contains("the apple is heavier from the egg"));
    CHECK_FALSE(said.contains("the apple is heavier then the egg"));
}

TEST_CASE("word graph: each word and each arc is there once, from 0 to the last node") {
    const WordGraph graph =
        make_word_graph(compile({"the {thing} is the <superlative:beautiful>", "the {thing}"}));
    const std::set<std::string> words(graph.words.begin(), graph.words.end());
    CHECK(words.size() == graph.words.size());
    std::set<std::tuple<int, int, int>> arcs;
    for (const WordGraph::Arc& arc : graph.arcs) {
        CHECK(arcs.emplace(arc.from, arc.to, arc.word).second);
        CHECK(arc.from >= 0);
        CHECK(arc.from < graph.nodes - 1);
        CHECK(arc.to > 0);
        CHECK(arc.to < graph.nodes);
        CHECK(arc.word >= kNone);
        CHECK(arc.word < static_cast<int>(graph.words.size()));
        CHECK((arc.weight == 1.0 || arc.weight == kErrorWeight));
    }
    CHECK(std::ranges::any_of(graph.arcs, [](const auto& arc) { return arc.weight < 1.0; }));
}

TEST_CASE("word graph: numbers are said in words") {
    const WordGraph graph = make_word_graph(compile({"it has 21 moons"}));
    CHECK(sentences_of(graph).contains("it has twenty one moons"));
}
