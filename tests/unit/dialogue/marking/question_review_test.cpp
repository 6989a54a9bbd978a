#include "dialogue/marking/question_review.h"

#include "dialogue/english/antonyms.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>

using namespace fulcrum::dialogue;

namespace {

Opposites opposites() {
    const auto antonyms = std::make_shared<Expected<Antonyms>>(Antonyms::open());
    REQUIRE(*antonyms);
    return [antonyms](std::string_view word) { return (*antonyms)->of(word); };
}

std::vector<std::string> reviewed(const std::vector<std::string>& answers,
                                  const NamedLists& lists = fruit()) {
    return review_question(compiled({"q", "Which one?", answers, lists}), opposites());
}

}  // namespace

TEST_CASE("question review: a good question has nothing to tell") {
    CHECK(review_question(heaviest(), opposites()).empty());
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

TEST_CASE(
    "question review: opposites of any kind of word, in a list's other words, and by \"not\"") {
    struct {
        std::vector<std::string> answers;
        const char* said;
    } const rows[] = {{{"(push|pull) the {thing}"}, "ull the "},
                      {{"the {thing} (rises|falls)"}, "counts as"},
                      {{"the {thing} goes (up|down)"}, "counts as"},
                      {{"it is (with|without) the {thing}"}, "counts as"},
                      {{"it is [not] the {thing}"}, "counts as"},
                      {{"the {thing} (is|isn't) here"}, "counts as"},
                      {{"the {thing} is here", "the {thing} is not here"}, "counts as"}};
    for (const auto& row : rows) {
        INFO(row.answers[0]);
        const auto found = reviewed(row.answers);
        REQUIRE(found.size() >= 1);
        CHECK_THAT(found[0], Catch::Contains(row.said) && Catch::Contains("counts as"));
    }
    const NamedLists one_word{{"thing", {"egg"}}, {"size", {"big|small"}}};
    CHECK(reviewed({"the {thing} is {size}"}, one_word).size() == 1);
    const NamedLists two_words{{"thing", {"egg"}}, {"size", {"big", "small"}}};
    CHECK(reviewed({"the {thing} is {size}"}, two_words).empty());
}

TEST_CASE("question review: opposites that the author means to be alike are not told") {
    const Question question = compiled({"q", "?", {"the {thing} (pushes|pulls) it up"}, fruit()});
    CHECK(review_question(question, opposites()).size() == 1);
    CHECK(review_question(question, opposites(), {"The egg pushes it up.", "The egg pulls it up."})
              .empty());
    CHECK(review_question(question, opposites(), {"The egg pushing it", "the egg pullses it"})
              .size() == 1);
}

TEST_CASE("question review: what is said back, of each answer") {
    const auto all = said_back(
        compiled({"q", "Which one?", {"the {thing} is big", "it is the {thing} [here]"}, fruit()}));
    CHECK(std::ranges::any_of(all, [](const SaidBack& one) {
        return one.answer == 0 && one.sentence == "The egg is big.";
    }));
    CHECK(std::ranges::any_of(all, [](const SaidBack& one) {
        return one.answer == 1 && one.sentence == "It is the egg.";
    }));
}

TEST_CASE("question review: words that cannot be heard, each once") {
    const auto words = unheard_words(heaviest(), [](std::string_view word) {
        return word != "watermelon" && word != "heaviest";
    });
    CHECK(words == std::vector<std::string>{"watermelon", "heaviest"});
    CHECK(unheard_words(heaviest(), [](std::string_view) { return true; }).empty());
}
