#include "dialogue/template/compile.h"

#include "dialogue/marking/mark_answer.h"
#include "dialogue/template/matcher.h"
#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/rig.h"

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

TEST_CASE("short answers: they stay within the budget of arcs, or the template is refused") {
    NamedLists lists{{"thing", {}}, {"material", {}}};
    for (int i = 0; i < 400; ++i) {
        lists[0].second.push_back("thing" + std::to_string(i));
        lists[1].second.push_back("stuff" + std::to_string(i));
    }
    std::vector<std::string> answers(4, "[a|the] {thing} <made_of:{material}>");
    const auto many = compile_templates({answers, lists, {}});
    REQUIRE_FALSE(many);
    CHECK_THAT(many.error().message, Catch::Contains("grow beyond"));
}

TEST_CASE("tail answers: where there is no room for them a question goes without") {
    NamedLists lists{{"place", {}}};
    for (int i = 0; i < 400; ++i) {
        lists[0].second.push_back("beside thing " + std::to_string(i));
    }
    std::vector<std::string> answers;
    for (int i = 0; i < 16; ++i) {
        answers.push_back("the apple is {place} the {thing} number " + std::to_string(i));
    }
    lists.emplace_back("thing", std::vector<std::string>{"bowl", "box"});
    const Question question = compiled({"where", "Where is the apple?", answers, lists});
    CHECK(mark_answer(question, "the apple is beside thing 7 the bowl number 15").understood);
    CHECK(mark_answer(question, "beside thing 7 the bowl number 0").understood);
    CHECK_FALSE(mark_answer(question, "beside thing 7 the bowl number 15").understood);
}

TEST_CASE("variants: where there is no room they are left out") {
    NamedLists many{{"thing", {}}};
    for (int i = 0; i < 900; ++i) {
        many[0].second.push_back("word" + std::string(1, static_cast<char>('a' + i / 100)) +
                                 std::string(1, static_cast<char>('a' + i / 10 % 10)) +
                                 std::string(1, static_cast<char>('a' + i % 10)));
    }
    const Question question =
        compiled({"many", "Which?", {"the {thing} is the <superlative:heavy>"}, many});
    CHECK(mark_answer(question, "the wordaaa is the heaviest").understood);
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
