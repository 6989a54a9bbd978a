#include "dialogue/marking/mark.h"
#include "dialogue/template/compile.h"
#include "dialogue/template/matcher.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

Error error_of(const std::string& answer) {
    const auto set = compile_templates({{answer}, textures(), {}});
    return set ? Error{} : set.error();
}

}  // namespace

TEST_CASE("grammar forms: mistakes say what is meant, and where") {
    const struct {
        const char *answer, *part;
        int column;
    } rows[] = {
        {"it <made_of:{materiel}>", "there is no list \"materiel\"; did you mean material?", 13},
        {"it is <adjective:{fel}>", "there is no list \"fel\"; did you mean feel?", 18},
        {"it is <comparative:{x}> than", "the lists are: thing, material, feel", 20},
        {"it <made_of>", "<made_of> needs a word: <made_of:word>", 4},
        {"it is <adjective>", "<adjective> needs a word", 7},
        {"it <made_off:metal>", "there is no form <made_off:…>; did you mean <made_of:word>?", 4},
        {"it is <adjectives:{feel}>", "did you mean <adjective:word>?", 7},
        {"it is <biggest:heavy>", "there is no form <biggest:…>; forms are <adjective:word>", 7},
        {"it is <biggest>", "there is no form <biggest>", 7},
        {"<it:thing> is red", "<it> takes no word; take it out", 1},
        {"<article:a> ball", "<article> takes no word", 1},
        {"two <plural:{thing}>", "takes a word, not a list", 5},
        {"{thing} <made_of:{thing}>", "filled twice", 9},
        {"it is <adjective:{feel}> and <adjective:{feel}>", "filled twice", 30},
        {"{material:s} <made_of:{thing:s}>", "from two lists", 23},
    };
    for (const auto& row : rows) {
        INFO(row.answer);
        const Error error = error_of(row.answer);
        CHECK_THAT(error.message, Catch::Contains(row.part));
        CHECK(error.column == row.column);
    }
}

TEST_CASE("grammar forms: a form may stand in a rule, in brackets and among alternatives") {
    const TemplateSet set =
        compiled_templates({{"<what> [really] (<made>|is <adjective:{feel}>)"},
                            textures(),
                            {{"what", "[the|a] {thing}"}, {"made", "<made_of:{material}>"}}});
    const auto made = match(set, "the scissors are made of metal");
    REQUIRE(made);
    CHECK(made->cost == 0);
    CHECK(made->slots == std::vector<std::pair<std::string, std::string>>{{"thing", "scissors"},
                                                                          {"material", "metal"}});
    CHECK(match(set, "a ball is soft")->slots.back().first == "feel");
    CHECK(match(set, "a ball are soft")->cost == 10);
}

TEST_CASE("grammar forms: a rule of the author's goes before a form of the same name") {
    const TemplateSet set = compiled_templates({{"<it> red"}, {}, {{"it", "that one is"}}});
    CHECK(match(set, "that one is red"));
    CHECK_FALSE(match(set, "it red"));
}

TEST_CASE("grammar forms: what English adds to a degree is right without the author's words") {
    const Question most =
        compiled({"most", "?", {"the {thing} is the <superlative:heavy>"}, fruit()});
    const Question more = compiled(
        {"more", "?", {"the {thing} is <comparative:heavy> [than the {thing:other}]"}, fruit()});
    const struct {
        const Question& question;
        const char *said, *back;
    } right[] = {
        {most, "the egg is the heaviest of the three", "The egg is the heaviest of the three."},
        {most, "the egg is the heaviest of all", "The egg is the heaviest of all."},
        {most, "the egg is the heaviest one", "The egg is the heaviest one."},
        {heaviest(), "the heaviest of all is the egg", "The heaviest of all is the egg."},
        {heaviest(), "the egg is the heaviest one of them all",
         "The egg is the heaviest one of them all."},
        {more, "the egg is heavier than the apple is", "The egg is heavier than the apple."},
        {most_of_feel(), "metal is the hardest of all", "Metal is the hardest of all."},
    };
    for (const auto& row : right) {
        INFO(row.said);
        const Mark mark = mark_answer(row.question, row.said);
        CHECK(mark.understood);
        CHECK(mark.form_right());
        CHECK(mark.corrected == row.back);
    }
    CHECK(mark_answer(most, "the egg is heaviest of all").emphasised ==
          "The egg is *the heaviest* of all.");
    CHECK(mark_answer(most, "the egg is the most heavy of the four").emphasised ==
          "The egg is *the heaviest* of the four.");
    CHECK_FALSE(mark_answer(most, "the egg is the heaviest of").understood);
    CHECK_FALSE(mark_answer(heaviest(), "the egg is the heaviest of all one").understood);
    CHECK_FALSE(mark_answer(more, "the egg is is heavier than the apple").understood);
}

TEST_CASE("grammar forms: what is made of metal is metal, and the metal is not a spaceship") {
    CHECK(mark_answer(spaceship_of_what(), "the spaceship is metal").form_right());
    CHECK(mark_answer(spaceship_of_what(), "metal").slot("material") == "metal");
    CHECK(mark_answer(made_of_what(), "the scissors are metal").form_right());
    CHECK(mark_answer(spaceship_of_what(), "the spaceship are metal").emphasised ==
          "The spaceship *is* metal.");
    CHECK(mark_answer(spaceship_of_what(), "the spaceship is a metal").emphasised ==
          "The spaceship is *metal*.");
    CHECK_FALSE(mark_answer(made_of_what(), "metal is a spaceship").understood);
}
