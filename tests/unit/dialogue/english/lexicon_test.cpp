#include "dialogue/english/lexicon.h"

#include "dialogue/english/antonyms.h"
#include "dialogue/english/common_noun.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

TEST_CASE("lexicon: what a word mostly is, and a plural by exception") {
    const auto opened = Lexicon::open();
    REQUIRE(opened);
    const auto count = [&](const char* word, WordKind kind) { return opened->count(word, kind); };
    CHECK(count("moon", WordKind::noun) > 10 * count("moon", WordKind::verb));
    CHECK(count("heavy", WordKind::adjective) > count("heavy", WordKind::noun));
    CHECK(count("go", WordKind::verb) > 100);
    CHECK(count("moones", WordKind::noun) == 0);
    CHECK(count("", WordKind::noun) == 0);
    const std::vector<std::string> feet = opened->irregular_plurals("foot");
    CHECK(std::find(feet.begin(), feet.end(), "feet") != feet.end());
}

TEST_CASE("lexicon: a folder without WordNet is one sentence that names the package") {
    const auto message = [](const auto& opened) {
        REQUIRE_FALSE(opened);
        return opened.error().message;
    };
    for (const std::string& told :
         {message(Lexicon::open("/nowhere")), message(Antonyms::open("/nowhere")),
          message(CommonNouns::open("/nowhere"))}) {
        CHECK_THAT(told, Catch::Contains("wordnet-base"));
    }
}
