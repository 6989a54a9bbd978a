#include "dialogue/template/slot_entries.h"

#include "dialogue/template/compile.h"
#include "dialogue/template/sentences.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

TemplateSet set_of(const std::string& sentence, std::vector<std::string> things) {
    TemplateSource source;
    source.sentences = {sentence};
    source.lists = {{"thing", std::move(things)}, {"where", {"on", "under"}}};
    auto set = compile_templates(source);
    REQUIRE(set);
    return std::move(*set);
}

}  // namespace

TEST_CASE("slot entries: two slots of one list have two of its entries") {
    const TemplateSet set =
        set_of("the {thing} is {where} the {thing:other}", {"ball", "box", "egg"});
    CHECK(render(canonical_pieces(set, 0, {})) == "The ball is on the box.");
    CHECK(render(canonical_pieces(set, 0, {{"other", "ball"}})) == "The box is on the ball.");
    CHECK(render(canonical_pieces(set, 0, {{"thing", "box"}, {"where", "under"}})) ==
          "The box is under the ball.");
    // What is said is said, though it is the same thing twice.
    CHECK(render(canonical_pieces(set, 0, {{"thing", "egg"}, {"other", "egg"}})) ==
          "The egg is on the egg.");
    // Two lists of the same words are the same things.
    TemplateSource two;
    two.sentences = {"the {thing} is on the {other}"};
    two.lists = {{"thing", {"ball", "box"}}, {"other", {"ball", "box"}}};
    const auto both = compile_templates(two);
    REQUIRE(both);
    CHECK(render(canonical_pieces(*both, 0, {})) == "The ball is on the box.");
    CHECK(wanted_entries(set, {{"other", "nothing of it"}}) == wanted_entries(set, {}));
}

TEST_CASE("slot entries: a list of one entry has no other") {
    const TemplateSet set = set_of("the {thing} is {where} the {thing:other}", {"ball"});
    CHECK(render(canonical_pieces(set, 0, {})) == "The ball is on the ball.");
}
