#include "dialogue/template/matcher.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

std::string codes_of(const std::string& answer, const std::string& said) {
    const TemplateSet set = compiled_templates({{answer}, textures(), {}});
    const auto parse = match(set, said);
    std::string codes = parse ? "" : "?";
    for (std::size_t i = 0; parse && i < parse->pieces.size(); ++i) {
        const Piece& piece = parse->pieces[i];
        if (piece.code != ErrorCode::none) {
            codes += (codes.empty() ? "" : " ") + std::string(errant_code(piece.code)) + "->" +
                     piece.right;
        }
    }
    return codes;
}

}  // namespace

TEST_CASE("passive: the auxiliary agrees with a listed noun, a plain noun and a pronoun") {
    const std::string listed = "[the] {thing} <made_of:metal>";
    CHECK(codes_of(listed, "the scissors are made of metal").empty());
    CHECK(codes_of(listed, "the key is made of metal").empty());
    CHECK(codes_of(listed, "the scissors is made of metal") == "R:VERB:SVA->are");
    CHECK(codes_of(listed, "the key are made of metal") == "R:VERB:SVA->is");
    CHECK(codes_of("the doors <made_of:wood>", "the doors are made of wood").empty());
    CHECK(codes_of("the doors <made_of:wood>", "the doors is made of wood") == "R:VERB:SVA->are");
    CHECK(codes_of("the door <made_of:wood>", "the door are made of wood") == "R:VERB:SVA->is");
    CHECK(codes_of("<it> <made_of:wood>", "they are made of wood").empty());
    CHECK(codes_of("<it> <made_of:wood>", "these is made of wood") == "R:VERB:SVA->are");
    CHECK(codes_of("<it> <made_of:wood>", "is made of wood") == "M:PRON->it");
    // Not known which: both are let pass.
    const std::string either = "the (door|doors) <made_of:wood>";
    CHECK(codes_of(either, "the door is made of wood").empty());
    CHECK(codes_of(either, "the doors are made of wood").empty());
}

TEST_CASE("passive: an active verb is one error, in the number of its subject") {
    const std::string listed = "[the] {thing} <made_of:{material}>";
    CHECK(codes_of(listed, "the key makes of metal") == "R:VERB:VOICE->is made");
    CHECK(codes_of(listed, "the scissors make of metal") == "R:VERB:VOICE->are made");
    CHECK(codes_of(listed, "the scissors makes of metal") == "R:VERB:VOICE->are made");
    CHECK(codes_of("the doors <made_of:wood>", "the doors make of wood") ==
          "R:VERB:VOICE->are made");
    CHECK(codes_of(listed, "the key is makes of metal") == "R:VERB:FORM->made");
    CHECK(codes_of(listed, "the key is maked of metal") == "R:VERB:INFL->made");
    CHECK(codes_of(listed, "the key is maid of metal") == "R:SPELL->made");
    CHECK(codes_of(listed, "the key was made of metal").empty());
    CHECK(codes_of(listed, "the key were made of metal") == "R:VERB:SVA->was");
    CHECK(codes_of(listed, "the scissors were made of metal").empty());
    CHECK(codes_of("the doors <made_of:wood>", "the doors was made of wood") == "R:VERB:SVA->were");
    CHECK(codes_of(listed, "the key has made of metal") == "R:VERB:FORM->is");
}

TEST_CASE("passive: a material has no article and, where it can't be counted, no plural") {
    const std::string listed = "[the] {thing} <made_of:{material}>";
    CHECK(codes_of(listed, "the castle is made of stone").empty());
    CHECK(codes_of(listed, "the castle is made of stones").empty());
    CHECK(codes_of(listed, "the castle is made of some stone").empty());
    CHECK(codes_of(listed, "the castle is made of the stone") == "U:DET->");
    CHECK(codes_of(listed, "the castle is made out of the stone") == "U:DET->");
    CHECK(codes_of(listed, "made of the metal") == "U:DET->");
    CHECK(codes_of(listed, "of the metal") == "U:DET->");
    CHECK(codes_of(listed, "made of metals") == "R:NOUN:NUM->metal");
    CHECK(codes_of(listed, "made of metal").empty());
    CHECK(codes_of(listed, "of metal").empty());
    CHECK(codes_of(listed, "the castle is made of a stone") == "U:DET->");
    CHECK(codes_of(listed, "the key is made of an metal") == "U:DET->");
    CHECK(codes_of(listed, "the key is made of metals") == "R:NOUN:NUM->metal");
    // Words that no table knows as materials are taken for such.
    const TemplateSet cake = compiled_templates(
        {{"it <made_of:{stuff}>"}, {{"stuff", {"marzipan", "feathers", "Lego"}}}, {}});
    for (const char* said :
         {"it is made of marzipan", "it is made of feathers", "it is made of Lego"}) {
        INFO(said);
        REQUIRE(match(cake, said));
        CHECK(match(cake, said)->cost == 0);
    }
}
