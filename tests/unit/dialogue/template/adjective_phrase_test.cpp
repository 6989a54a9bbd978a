#include "dialogue/template/matcher.h"
#include "dialogue/template/sentences.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

/// The codes found in `said`; "?" when it isn't understood.
std::string codes_of(const TemplateSet& set, const std::string& said) {
    const auto parse = match(set, said);
    std::string codes = parse ? "" : "?";
    for (std::size_t i = 0; parse && i < parse->pieces.size(); ++i) {
        if (const ErrorCode code = parse->pieces[i].code; code != ErrorCode::none) {
            codes += (codes.empty() ? "" : " ") + std::string(errant_code(code));
        }
    }
    return codes;
}

}  // namespace

TEST_CASE("adjective phrase: a fixed word in its three degrees") {
    const TemplateSet plain = compiled_templates({{"it is <adjective:Sticky>"}, {}, {}});
    CHECK(codes_of(plain, "it is sticky").empty());
    CHECK(codes_of(plain, "it is very sticky").empty());
    CHECK(codes_of(plain, "it is a bit sticky").empty());
    CHECK(codes_of(plain, "it is slightly sticky").empty());
    CHECK(codes_of(plain, "it is much sticky") == "R:ADV");
    CHECK(codes_of(plain, "it is stickily") == "R:MORPH");
    CHECK(codes_of(plain, "it is a sticky") == "U:DET");
    CHECK(codes_of(plain, "it is stickier") == "R:ADJ:FORM");
    CHECK(codes_of(plain, "it is stickey") == "R:SPELL");
    CHECK(codes_of(plain, "it is not sticky") == "?");
    CHECK(codes_of(plain, "it is less sticky") == "?");
    // A capital of the template's is not said back.
    CHECK(render(match(plain, "it is stickey")->pieces) == "It is sticky.");
    // "The" is no error before a superlative that is written without it.
    const TemplateSet most = compiled_templates({{"it is <superlative:sticky>"}, {}, {}});
    CHECK(codes_of(most, "it is the stickiest").empty());
    CHECK(codes_of(most, "it is stickiest").empty());
    // The template's own article is no error.
    const TemplateSet thing = compiled_templates({{"it is a <adjective:hard> thing"}, {}, {}});
    CHECK(codes_of(thing, "it is a hard thing").empty());
    CHECK(codes_of(thing, "it is hard thing") == "M:DET");
    CHECK(codes_of(thing, "it is an hard thing") == "R:DET");
}

TEST_CASE(
    "adjective phrase: any word of a list fills its slot, in every degree, and may be said in two "
    "ways") {
    const NamedLists feel{{"feel", {"hard", "smooth", "slippery|slick", "grey"}}};
    const TemplateSet set =
        compiled_templates({{"it is <adjective:{feel}>", "it is <comparative:{feel}> than that",
                             "it is the <superlative:{feel}> of all"},
                            feel,
                            {}});
    const struct {
        const char *said, *feel;
        int graph;
    } rows[] = {{"it is slick", "slippery", 0},
                {"it is gray", "grey", 0},
                {"it is hardly", "hard", 0},
                {"it is smoother than that", "smooth", 1},
                {"it is more smooth than that", "smooth", 1},
                {"it is the smoothest of all", "smooth", 2},
                {"it is the most hard of all", "hard", 2}};
    for (const auto& row : rows) {
        INFO(row.said);
        const auto parse = match(set, row.said);
        REQUIRE(parse);
        CHECK(parse->graph == row.graph);
        CHECK(parse->slots == std::vector<std::pair<std::string, std::string>>{{"feel", row.feel}});
    }
    CHECK(codes_of(set, "it is the smoothest of all").empty());
    CHECK(codes_of(set, "it is soft") == "?");
}
