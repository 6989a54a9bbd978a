#include "dialogue/english/lexicon.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <stdexcept>
#include <vector>

using namespace fulcrum::dialogue;

namespace {

const Lexicon& lexicon() {
    static const Lexicon opened = [] {
        auto made = Lexicon::open();
        if (!made) {
            throw std::runtime_error(made.error().message);
        }
        return std::move(*made);
    }();
    return opened;
}

}  // namespace

TEST_CASE("lexicon: the kinds of a word") {
    CHECK(lexicon().has("moon", WordKind::noun));
    CHECK(lexicon().has("moon", WordKind::verb));
    CHECK_FALSE(lexicon().has("moon", WordKind::adjective));
    CHECK(lexicon().has("hardly", WordKind::adverb));
    CHECK_FALSE(lexicon().has("mice", WordKind::noun));
    CHECK_FALSE(lexicon().has("moones", WordKind::noun));
    CHECK_FALSE(lexicon().has("", WordKind::noun));
    CHECK_FALSE(lexicon().has(" ", WordKind::noun));
}

TEST_CASE("lexicon: what a word mostly is") {
    CHECK(lexicon().count("moon", WordKind::noun) > 10 * lexicon().count("moon", WordKind::verb));
    CHECK(lexicon().count("heavy", WordKind::adjective) > lexicon().count("heavy", WordKind::noun));
    CHECK(lexicon().count("go", WordKind::verb) > 100);
    CHECK(lexicon().count("moones", WordKind::noun) == 0);
    CHECK(lexicon().count("", WordKind::noun) == 0);
}

TEST_CASE("lexicon: forms and their words, regular and irregular") {
    using Words = std::vector<std::string>;
    CHECK(lexicon().bases("mice", WordKind::noun) == Words{"mouse"});
    CHECK(lexicon().bases("moons", WordKind::noun) == Words{"moon"});
    CHECK(lexicon().bases("boxes", WordKind::noun) == Words{"box"});
    CHECK(lexicon().bases("goes", WordKind::verb) == Words{"go"});
    CHECK(lexicon().bases("went", WordKind::verb) == Words{"go"});
    CHECK(lexicon().bases("better", WordKind::adjective) == Words{"good", "well"});
    CHECK(lexicon().bases("stickier", WordKind::adjective) == Words{"sticky"});
    CHECK(lexicon().bases("moon", WordKind::noun).empty());
    CHECK(lexicon().bases("glass", WordKind::noun).empty());
    CHECK(lexicon().bases("", WordKind::noun).empty());
    const Words feet = lexicon().irregular_plurals("foot");
    CHECK(std::find(feet.begin(), feet.end(), "feet") != feet.end());
    CHECK(lexicon().irregular_plurals("moon").empty());
}

TEST_CASE("lexicon: a folder without it names the package") {
    const auto none = Lexicon::open("/nowhere");
    REQUIRE_FALSE(none);
    CHECK(none.error().message.find("wordnet-base") != std::string::npos);
}
