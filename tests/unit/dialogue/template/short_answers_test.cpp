#include "dialogue/template/short_answers.h"

#include "dialogue/template/matcher.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

std::vector<std::string> shorts_of(const Question& question, const std::vector<std::string>& said) {
    std::vector<std::string> result;
    for (const std::string& text : said) {
        const auto parse = match(*question.templates, text);
        const bool is_short =
            parse && parse->cost == 0 &&
            question.templates->graphs[static_cast<std::size_t>(parse->graph)].short_answer;
        if (is_short) {
            result.push_back(text);
        }
    }
    return result;
}

}  // namespace

TEST_CASE("short answers: each kind of question has its own") {
    const std::vector<std::string> said = {
        "metal",           "it is metal",  "it is made of metal",
        "made of metal",   "of metal",     "hard",
        "hard and smooth", "it is hard",   "they feel hard and smooth",
        "the key",         "it is the key"};
    CHECK(shorts_of(made_of_what(), said) == std::vector<std::string>{"metal", "it is metal",
                                                                      "it is made of metal",
                                                                      "made of metal", "of metal"});
    CHECK(shorts_of(feels_how(), said) == std::vector<std::string>{"hard", "hard and smooth",
                                                                   "it is hard",
                                                                   "they feel hard and smooth"});
    CHECK(shorts_of(feels_two(), said) ==
          std::vector<std::string>{"hard and smooth", "they feel hard and smooth"});
    CHECK(shorts_of(what_of_metal(), said) == std::vector<std::string>{"the key", "it is the key"});
    CHECK(shorts_of(compares_feel(), said).empty());
}

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

TEST_CASE("short answers: what is counted is said alone, and completed") {
    const NamedLists numbers{{"number", {"one|a|an", "two", "three"}}};
    const Question ramps =
        compiled({"q", "How many ramps are there?", {"there are {number} <plural:ramp>"}, numbers});
    CHECK(shorts_of(ramps, {"three ramps", "two ramps", "three", "a ramp", "ramps"}) ==
          std::vector<std::string>{"three ramps", "two ramps", "three", "a ramp"});
    CHECK(mark_answer(ramps, "three ramps").corrected == "There are three ramps.");
    CHECK(mark_answer(ramps, "three ramps").slot("number") == "three");
    CHECK(mark_answer(ramps, "three ramp").form_errors.size() == 1);
    CHECK(mark_answer(ramps, "three ramp").emphasised == "There are three *ramps*.");
    // What the author wrote is no short answer.
    const Question both = compiled(
        {"q", "How many?", {"there are {number} <plural:egg>", "{number} <plural:egg>"}, numbers});
    CHECK(shorts_of(both, {"two eggs"}).empty());
    CHECK(mark_answer(both, "two eggs").understood);
}
