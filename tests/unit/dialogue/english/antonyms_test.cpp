#include "dialogue/english/antonyms.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

namespace {

bool are_opposites(const Antonyms& antonyms, const std::string& one, const std::string& other) {
    const std::vector<std::string> found = antonyms.of(one);
    return std::find(found.begin(), found.end(), other) != found.end();
}

}  // namespace

TEST_CASE("antonyms: of every kind of word, both ways") {
    const auto antonyms = Antonyms::open();
    REQUIRE(antonyms);
    const std::pair<const char*, const char*> pairs[] = {
        {"heavy", "light"},     {"push", "pull"},         {"rise", "fall"},
        {"open", "close"},      {"day", "night"},         {"up", "down"},
        {"always", "never"},    {"with", "without"},      {"above", "below"},
        {"yes", "no"},          {"long", "short"},        {"sharp", "blunt"},
        {"sticky", "slippery"}, {"visible", "invisible"}, {"attract", "repel"}};
    for (const auto& [one, other] : pairs) {
        INFO(one << " " << other);
        CHECK(are_opposites(*antonyms, one, other));
        CHECK(are_opposites(*antonyms, other, one));
    }
}

TEST_CASE("antonyms: in the form that was said") {
    const auto antonyms = Antonyms::open();
    REQUIRE(antonyms);
    CHECK(are_opposites(*antonyms, "heavier", "lighter"));
    CHECK(are_opposites(*antonyms, "longest", "shortest"));
    CHECK(are_opposites(*antonyms, "pushes", "pulls"));
    CHECK(are_opposites(*antonyms, "better", "worse"));
    CHECK_FALSE(are_opposites(*antonyms, "heavier", "light"));
}

TEST_CASE("antonyms: a verb and what it is with \"not\"") {
    const auto antonyms = Antonyms::open();
    REQUIRE(antonyms);
    CHECK(are_opposites(*antonyms, "is", "is not"));
    CHECK(are_opposites(*antonyms, "is", "isn't"));
    CHECK(are_opposites(*antonyms, "can", "can't"));
    CHECK(are_opposites(*antonyms, "can", "cannot"));
}

TEST_CASE("antonyms: none of what has none, and of no word") {
    const auto antonyms = Antonyms::open();
    REQUIRE(antonyms);
    for (const char* word : {"watermelon", "", " ", "zorbly", "heavy light", "'", "\xC3\xA9"}) {
        INFO(word);
        CHECK(antonyms->of(word).empty());
    }
}

TEST_CASE("antonyms: a folder without the words is one sentence that names the package") {
    const auto antonyms = Antonyms::open("/nowhere");
    REQUIRE_FALSE(antonyms);
    CHECK_THAT(antonyms.error().message, Catch::Contains("wordnet-base"));
}
