#include "dialogue/template/resolve.h"

#include "dialogue/marking/mark.h"
#include "dialogue/template/sentences.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

std::string put_right(const TemplateSource& source, std::string_view said) {
    const TemplateSet set = compiled_templates(source);
    const auto parse = match(set, said);
    return parse ? render(parse->pieces) + " " + std::to_string(total_cost(parse->pieces)) : "?";
}

const NamedLists& things() {
    static const NamedLists lists{{"thing", {"apple", "scissors", "water"}}};
    return lists;
}

}  // namespace

TEST_CASE("resolve: the verb agrees with the noun right before it") {
    const TemplateSource is{{"the {thing} is here"}, things(), {}};
    CHECK(put_right(is, "the apple is here") == "The apple is here. 0");
    CHECK(put_right(is, "the apple are here") == "The apple is here. 10");
    const TemplateSource any{{"<article> {thing} is here"}, things(), {}};
    CHECK(put_right(any, "apples are here") == "Apples are here. 0");
    CHECK(put_right(any, "apples is here") == "Apples are here. 10");
    CHECK(put_right(is, "the scissors is here") == "The scissors are here. 10");
    CHECK(put_right(is, "the water are here") == "The water is here. 10");
    CHECK(put_right(is, "the scissors here") == "The scissors are here. 20");
}

TEST_CASE("resolve: a noun in the wrong number takes its verb along: one error, not two") {
    const TemplateSource is{{"the {thing} is here"}, things(), {}};
    CHECK(put_right(is, "the apples are here") == "The apple is here. 10");
    CHECK(put_right(is, "the apples is here") == "The apple is here. 10");
    CHECK(put_right(is, "these apples are here") == "This apple is here. 10");
    CHECK(put_right(is, "the apples here") == "The apple is here. 30");
    CHECK(put_right(is, "this apples are here") == "This apple is here. 10");
    CHECK(put_right(is, "these apple are here") == "This apple is here. 10");
    CHECK(put_right(is, "these apple is here") == "This apple is here. 10");
    CHECK(put_right(is, "this scissors is here") == "These scissors are here. 10");
    CHECK(put_right(is, "this apple are here") == "This apple is here. 10");
    const TemplateSource were{{"the {thing} are here"}, things(), {}};
    CHECK(put_right(were, "the apples are here") == "The apple is here. 10");
}

TEST_CASE("resolve: a noun inside a longer subject doesn't decide") {
    const TemplateSource weight{{"the weight of the {thing} is small"}, things(), {}};
    CHECK(put_right(weight, "the weight of the scissors is small") ==
          "The weight of the scissors is small. 0");
    CHECK(put_right(weight, "the weight of the scissors are small") ==
          "The weight of the scissors is small. 10");
    const TemplateSource both{{"the {thing} and the {thing:other} are here"}, things(), {}};
    CHECK(put_right(both, "the apple and the water are here") ==
          "The apple and the water are here. 0");
    CHECK(put_right(both, "the apple and the water is here") ==
          "The apple and the water are here. 10");
    const TemplateSource coloured{{"the {colour} {thing} is here"},
                                  {{"thing", {"apple", "scissors"}}, {"colour", {"red"}}},
                                  {}};
    CHECK(put_right(coloured, "the red scissors are here") == "The red scissors are here. 0");
    CHECK(put_right(coloured, "the red scissors is here") == "The red scissors are here. 10");
    const TemplateSource it{{"it is the {thing}"}, things(), {}};
    CHECK(put_right(it, "it is the scissors") == "It is the scissors. 0");
    CHECK(put_right(it, "it are the scissors") == "It is the scissors. 10");
}

TEST_CASE("resolve: the goes before heavier, but not before heavier than") {
    const TemplateSource source{{"it is <comparative:heavy> [one|than the {thing}]"}, things(), {}};
    CHECK(put_right(source, "it is the heavier one") == "It is the heavier one. 0");
    CHECK(put_right(source, "it is the heavier") == "It is the heavier. 0");
    CHECK(put_right(source, "it is the heavier than the apple") ==
          "It is heavier than the apple. 10");
    const TemplateSource asked{{"it is the <comparative:heavy> one"}, {}, {}};
    CHECK(put_right(asked, "it is the heavier one") == "It is the heavier one. 0");
}

TEST_CASE("resolve: a literal a goes by the sound of the next word") {
    const TemplateSource source{{"it is a (<comparative:old>|<comparative:big>) thing"}, {}, {}};
    CHECK(put_right(source, "it is an older thing") == "It is an older thing. 0");
    CHECK(put_right(source, "it is a older thing") == "It is an older thing. 10");
    CHECK(put_right(source, "it is a bigger thing") == "It is a bigger thing. 0");
    CHECK(put_right(source, "it is an bigger thing") == "It is a bigger thing. 10");
}

TEST_CASE("resolve: made from is right where the material was changed, in either number") {
    const TemplateSource made{{"[the] {thing} <made_of:{material}>"},
                              {{"thing", {"paper", "table"}}, {"material", {"wood", "trees"}}},
                              {}};
    CHECK(put_right(made, "the paper is made from wood") == "The paper is made from wood. 0");
    CHECK(put_right(made, "paper is made from trees") == "Paper is made from trees. 0");
    CHECK(put_right(made, "paper is made by wood") == "Paper is made of wood. 20");
    CHECK(put_right(made, "the table is made from wood") == "The table is made of wood. 20");
    CHECK(put_right(made, "it is made from wood") == "It is made of wood. 20");
}

TEST_CASE("resolve: no moon is as good as no moons, and is said back as it was said") {
    const Question question =
        compiled({"moons",
                  "How many moons has Venus?",
                  {"Venus has {number} <plural:moon>", "there (is|are) {number} <plural:moon>"},
                  {{"number", {"no", "one", "two"}}}});
    for (const char* right : {"Venus has no moon.", "Venus has no moons.", "There is no moon.",
                              "There are no moons.", "Venus has one moon."}) {
        INFO(right);
        const Mark mark = mark_answer(question, right);
        REQUIRE(mark.understood);
        CHECK(mark.form_right());
        CHECK(mark.corrected == right);
    }
    for (const char* wrong : {"Venus has two moon.", "Venus has one moons."}) {
        INFO(wrong);
        CHECK_FALSE(mark_answer(question, wrong).form_right());
    }
}
