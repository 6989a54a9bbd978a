#include "dialogue/template/compile.h"

#include "dialogue/template/matcher.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

namespace {

std::string error_of(const TemplateSource& source) {
    const auto set = compile_templates(source);
    return set ? "" : set.error().message;
}

std::size_t arcs_of(const TemplateSet& set) {
    std::size_t arcs = 0;
    for (const Graph& graph : set.graphs) {
        arcs += graph.arcs.size();
    }
    return arcs;
}

}  // namespace

TEST_CASE("compile: rules are put in their place, lists may be said in several ways") {
    const TemplateSet set = compiled_templates({{"I ride <vehicle>"},
                                                {{"thing", {"bike|bicycle", "bus"}}},
                                                {{"vehicle", "[a|the] {thing}"}}});
    const auto parse = match(set, "I ride a bicycle");
    REQUIRE(parse);
    CHECK(parse->slots == std::vector<std::pair<std::string, std::string>>{{"thing", "bike"}});
    CHECK(parse->cost == 0);
}

TEST_CASE("compile: a list holds plain words, each once") {
    for (const std::string entry : {"the <superlative:good>", "(wood|timber)", "[nice] wood",
                                    "{thing}", "wood; metal", "wo\\od", "wood>"}) {
        INFO(entry);
        const std::string error = error_of({{"it is {stuff}"}, {{"stuff", {"glass", entry}}}, {}});
        CHECK_THAT(error, Catch::StartsWith("list \"stuff\": the entry \"" + entry + "\" has \""));
        CHECK_THAT(error,
                   Catch::Contains("a list holds plain words, with | between two ways to say"));
    }
    CHECK_THAT(error_of({{"it is {stuff}"}, {{"stuff", {"wood", "glass", "wood|timber"}}}, {}}),
               Catch::Contains("list \"stuff\": \"wood\" stands in it twice; take one out"));
    CHECK(
        error_of({{"it is {stuff}"}, {{"stuff", {"the Moon", "stone block", "o'clock|hour"}}}, {}})
            .empty());
}

TEST_CASE("compile: mistakes name their place") {
    CHECK_THAT(error_of({{}, {}, {}}), Catch::Contains("between 1 and 64 answers"));
    CHECK_THAT(error_of({{"a", "b ["}, {}, {}}), Catch::Contains("answer 2"));
    CHECK_THAT(error_of({{"<nothing>"}, {}, {}}), Catch::Contains("there is no form <nothing>"));
    CHECK_THAT(error_of({{"<biggest:heavy>"}, {}, {}}),
               Catch::Contains("there is no form <biggest:"));
    CHECK_THAT(error_of({{"<superlative>"}, {}, {}}),
               Catch::Contains("<superlative> needs a word: <superlative:word>"));
    CHECK_THAT(error_of({{"{thng} is"}, {{"other", {"x"}}, {"thing", {"y"}}}, {}}),
               Catch::Contains("there is no list \"thng\"; did you mean thing?"));
    CHECK_THAT(error_of({{"{a} is"}, {{"b", {"x"}}, {"c", {"y"}}}, {}}),
               Catch::Contains("the lists are: b, c"));
    CHECK_THAT(error_of({{"{a}"}, {{"a", {}}}, {}}), Catch::Contains("is empty"));
    CHECK_THAT(error_of({{"{a}"}, {{"a", {"x"}}, {"a", {"y"}}}, {}}),
               Catch::Contains("given twice"));
    CHECK_THAT(error_of({{"{a}"}, {{"a", {"x", "?!"}}}, {}}), Catch::Contains("has no word in it"));
    CHECK_THAT(error_of({{"{a}"}, {{"a", {"x|"}}}, {}}), Catch::Contains("has no word in it"));
    CHECK_THAT(error_of({{"{a}"}, {{"a", {std::string(81, 'x')}}}, {}}),
               Catch::Contains("longer than 80"));
    CHECK_THAT(error_of({{"a"}, {}, {{"r", "["}}}), Catch::Contains("rule <r>"));
    CHECK_THAT(error_of({{"a"}, {}, {{"r", "a"}, {"r", "b"}}}), Catch::Contains("given twice"));
    CHECK_THAT(error_of({{"[a]"}, {}, {}}), Catch::Contains("may be empty"));
    CHECK_THAT(error_of({{"{a} and {a}"}, {{"a", {"x"}}}, {}}), Catch::Contains("filled twice"));
    CHECK_THAT(error_of({{"{a:s} {b:s}"}, {{"a", {"x"}}, {"b", {"y"}}}, {}}),
               Catch::Contains("from two lists"));
    CHECK_THAT(error_of({{"<r>"}, {}, {{"r", "a <s>"}, {"s", "{x}"}}}),
               Catch::Contains("in <r>: in <s>: there is no list"));
    CHECK_THAT(error_of({{"it is <plase>"}, {}, {{"place", "here"}}}),
               Catch::Contains("there is no rule <plase>; did you mean <place>?"));
    CHECK_THAT(error_of({{"it is <place:heavy>"}, {}, {{"place", "here"}}}),
               Catch::Contains("the rule <place> takes no word"));
}

TEST_CASE("compile: an alternative may fill the same slot as another") {
    CHECK(error_of({{"({a} first|last {a})"}, {{"a", {"x"}}}, {}}).empty());
}

TEST_CASE("compile: rules that use themselves are refused") {
    CHECK_THAT(error_of({{"<a>"}, {}, {{"a", "x <a>"}}}), Catch::Contains("<a> uses itself"));
    CHECK_THAT(error_of({{"<a>"}, {}, {{"a", "x <b>"}, {"b", "y <c>"}, {"c", "z [<a>]"}}}),
               Catch::Contains("uses itself"));
}

TEST_CASE("compile: growth without end is refused early, whatever makes it grow") {
    // Each rule uses the next twice: 2^20 words.
    NamedTexts doubling;
    for (int i = 0; i < 20; ++i) {
        doubling.emplace_back("r" + std::to_string(i),
                              "<r" + std::to_string(i + 1) + "> <r" + std::to_string(i + 1) + ">");
    }
    doubling.emplace_back("r20", "[x]");
    CHECK_THAT(error_of({{"a <r0>"}, {}, doubling}), Catch::Contains("grow beyond"));
    // The same with nothing in it.
    doubling.back().second = "";
    CHECK_THAT(error_of({{"a <r0>"}, {}, doubling}), Catch::Contains("grow beyond"));
    // Orders within orders.
    NamedTexts orders;
    for (int i = 0; i < 8; ++i) {
        const std::string next = "<r" + std::to_string(i + 1) + ">";
        orders.emplace_back("r" + std::to_string(i),
                            "(" + next + ";" + next + ";" + next + ";" + next + ")");
    }
    orders.emplace_back("r8", "x");
    CHECK_THAT(error_of({{"<r0>"}, {}, orders}), Catch::Contains("grow beyond"));
    // A chain that is too deep.
    NamedTexts chain;
    for (int i = 0; i < 40; ++i) {
        chain.emplace_back("r" + std::to_string(i), "<r" + std::to_string(i + 1) + ">");
    }
    chain.emplace_back("r40", "x");
    CHECK_THAT(error_of({{"<r0>"}, {}, chain}), Catch::Contains("nested deeper"));
    // Long lists, used often.
    NamedLists lists{{"n", {}}};
    for (int i = 0; i < 900; ++i) {
        lists[0].second.push_back("thing" + std::to_string(i));
    }
    std::string many;
    for (int i = 0; i < 12; ++i) {
        many += "{n:s" + std::to_string(i) + "} ";
    }
    CHECK_THAT(error_of({{many}, lists, {}}), Catch::Contains("grow beyond"));
    lists[0].second.resize(1200, "x");
    CHECK_THAT(error_of({{"{n}"}, lists, {}}), Catch::Contains("more than 1000 entries"));
}

TEST_CASE("compile: too many slots or sentences are refused") {
    std::string text;
    for (int i = 0; i < 17; ++i) {
        text += "{n:s" + std::to_string(i) + "} ";
    }
    CHECK_THAT(error_of({{text}, {{"n", {"x"}}}, {}}), Catch::Contains("more than 16 slots"));
    CHECK_THAT(error_of({std::vector<std::string>(65, "a"), {}, {}}),
               Catch::Contains("between 1 and 64"));
}

TEST_CASE(
    "compile: every graph goes upwards from its start to its end and stays within the budget") {
    for (const Question& question : all_questions()) {
        INFO(question.id);
        const TemplateSet& set = *question.templates;
        CHECK(arcs_of(set) <= kLargestGraph_arcs);
        for (const Graph& graph : set.graphs) {
            REQUIRE(graph.nodes() >= 2);
            CHECK((graph.slots & graph.required) == graph.required);
            for (const Arc& arc : graph.arcs) {
                CHECK(arc.from < arc.to);
                CHECK(arc.to <= graph.end());
                CHECK((arc.code == ErrorCode::none) == (arc.cost == 0));
                CHECK_FALSE((arc.canonical && arc.code != ErrorCode::none));
            }
            for (int node = 0; node < graph.end(); ++node) {
                CHECK_FALSE(graph.arcs_from(node).empty());
            }
        }
    }
}

TEST_CASE("compile: short answers come with a sentence whose only required slot they fill") {
    const auto shorts = [](const Question& question) {
        return std::ranges::count_if(question.templates->graphs, [](const Graph& graph) {
            return graph.short_answer && graph.claim == Claim::same;
        });
    };
    CHECK(shorts(heaviest()) == 2);
    CHECK(shorts(heavier()) == 2);
    CHECK(shorts(made_of()) == 0);
}

TEST_CASE("compile: a thing may be called by what tells it apart, and one") {
    const TemplateSource source{
        {"the {thing} is red"},
        {{"thing",
          {"metal block", "wooden block", "big ball", "big box", "egg", "red hat|red one"}}},
        {}};
    const TemplateSet set = compiled_templates(source);
    const auto thing = [&](const char* said) {
        const auto parse = match(set, said);
        return parse && parse->cost == 0 ? parse->slots.at(0).second : std::string("?");
    };
    CHECK(thing("the metal one is red") == "metal block");
    CHECK(thing("the wooden one is red") == "wooden block");
    CHECK(thing("the red one is red") == "red hat");
    CHECK(thing("the big one is red") == "?");  // there are two
    CHECK(thing("the one is red") == "?");
    CHECK(thing("the egg one is red") == "?");
    for (const char* said :
         {"the wood block is red", "the block of wood is red", "a block made of wood is red",
          "the wood one is red", "the one made of wood is red"}) {
        INFO(said);
        CHECK(thing(said) == "wooden block");
    }
    CHECK(thing("the block of metal is red") == "metal block");
    CHECK(thing("the hat of red is red") == "?");
    // Where materials are asked for, what is made of one is no name: a verb is missing.
    const TemplateSet made = compiled_templates(
        {{"the {thing} is made of {material}"},
         {{"thing", {"metal block", "wooden block"}}, {"material", {"metal", "wood"}}},
         {}});
    CHECK_FALSE(match(made, "the block made of wood is made of wood"));
    CHECK(match(made, "the block of wood is made of wood"));
}
