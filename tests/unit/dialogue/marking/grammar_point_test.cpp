#include "dialogue/marking/grammar_point.h"

#include "tests/unit/dialogue/questions.h"
#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

#include <set>

using namespace fulcrum::dialogue;

namespace {

std::string points_of(const Question& question, const char* said) {
    std::string points;
    for (const FormError& error : mark_answer(question, said).form_errors) {
        points += (points.empty() ? "" : " ") + std::string(grammar_point_id(grammar_point(error)));
    }
    return points;
}

}  // namespace

TEST_CASE("grammar point: passive, article, adjective, agreement are told apart") {
    const Question made = made_of_what();
    for (const char* said :
         {"a key is make of metal", "a key is maked of metal", "a key makes of metal",
          "a key made of metal", "a key has made of metal"}) {
        INFO(said);
        CHECK(points_of(made, said) == "passive_voice");
    }
    for (const char* said :
         {"a key is made by metal", "a key is made from metal", "a key is made metal"}) {
        INFO(said);
        CHECK(points_of(made, said) == "preposition");
    }
    CHECK(points_of(made, "a key is of metal made") == "wording");
    CHECK(points_of(heaviest(), "a watermelon the heaviest is") == "wording");
    CHECK(points_of(made, "a key are made of metal") == "agreement");
    CHECK(points_of(made, "key is made of metal") == "article");
    CHECK(points_of(made, "a key is made of a metal") == "article");
    CHECK(points_of(made, "a key is made of metals") == "noun_number");
    CHECK(points_of(made, "a key is maid of metal") == "spelling");
    CHECK(points_of(made, "a key it is made of metal") == "pronoun");
    CHECK(points_of(made, "key make by metal") == "article passive_voice preposition");
    const Question feels = feels_how();
    CHECK(points_of(feels, "metal is hardly") == "adjective");
    CHECK(points_of(feels, "metal is harder") == "adjective");
    CHECK(points_of(feels, "metal is much hard") == "adjective");
    CHECK(points_of(feels, "metal is hard smooth") == "joining");
    CHECK(points_of(feels, "metal hard") == "verb");
    CHECK(points_of(feels, "metal are hard") == "agreement");
    CHECK(points_of(feels, "a metal is hard") == "article");
    CHECK(points_of(feels, "metal feels like hard") == "preposition");
    CHECK(points_of(compares_feel(), "wood is more soft then rock") == "comparison comparison");
    CHECK(points_of(heaviest(), "an egg is the most heavy") == "comparison");
}

TEST_CASE("grammar point: every one has a name of its own, and the catalogue a text") {
    const Catalogue words = english_words();
    std::set<std::string_view> ids;
    for (std::size_t i = 0; i < kGrammarPointIds.size(); ++i) {
        const std::string_view id = grammar_point_id(static_cast<GrammarPoint>(i));
        CHECK(ids.insert(id).second);
        CHECK(words.has("point." + std::string(id)));
    }
    for (int code = 1; code < kErrorCodes; ++code) {
        FormError error;
        error.code = static_cast<ErrorCode>(code);
        CHECK(ids.count(grammar_point_id(grammar_point(error))) == 1);
    }
}
