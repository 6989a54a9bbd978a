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

}  // namespace

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
