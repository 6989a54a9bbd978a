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
