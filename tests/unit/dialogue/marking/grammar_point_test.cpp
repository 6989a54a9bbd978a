#include "dialogue/marking/grammar_point.h"

#include "tests/unit/dialogue/words.h"

#include <catch2/catch.hpp>

#include <set>

using namespace fulcrum::dialogue;

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
