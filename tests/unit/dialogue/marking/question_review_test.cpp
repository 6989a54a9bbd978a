#include "dialogue/marking/question_review.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

namespace {

std::vector<std::string> reviewed(const std::vector<std::string>& answers,
                                  const NamedLists& lists = fruit()) {
    return review_question(compiled({"q", "Which one?", answers, lists}));
}

}  // namespace

TEST_CASE("question review: a good question has nothing to tell") {
    CHECK(review_question(heaviest()).empty());
    CHECK(reviewed({"[the|a|an] {thing} is <comparative:heavy> [than [the|a|an] {thing:other}]"})
              .empty());
}

TEST_CASE("question review: an answer whose sentences another takes is never taken") {
    const auto found = reviewed({"the {thing} is [very] heavy", "the {thing} is heavy"});
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0], Catch::StartsWith("answer 2 is never taken"));
    CHECK_THAT(found[0], Catch::Contains("answer 1"));
    CHECK_THAT(found[0], Catch::Contains("is heavy\""));
    CHECK(reviewed({"the {thing} is heavy", "the {thing} is very heavy"}).empty());
}

TEST_CASE("question review: one sentence that means two things") {
    const NamedLists two{{"thing", {"egg", "rock"}}, {"kind", {"egg", "wood"}}};
    const auto found = reviewed({"it is [a] {thing}", "it is [a] {kind}"}, two);
    REQUIRE_FALSE(found.empty());
    CHECK_THAT(found[0], Catch::Contains("means kind = egg, and thing = egg as well"));
}

TEST_CASE("question review: an opposite that counts as the same answer") {
    const auto found = reviewed({"the {thing} is (<comparative:heavy>|<comparative:light>)"});
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0], Catch::Contains("counts as"));
    CHECK_THAT(found[0], Catch::Contains("heavier"));
    CHECK_THAT(found[0], Catch::Contains("lighter"));
}

TEST_CASE("question review: words that cannot be heard, each once") {
    const auto words = unheard_words(heaviest(), [](std::string_view word) {
        return word != "watermelon" && word != "heaviest";
    });
    CHECK(words == std::vector<std::string>{"watermelon", "heaviest"});
    CHECK(unheard_words(heaviest(), [](std::string_view) { return true; }).empty());
}
