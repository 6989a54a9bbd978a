#include "dialogue/marking/mark.h"

#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("mark: an error has its place, its words and what belongs there") {
    const std::string said = "So, a apple is most heavy";
    const Mark mark = mark_answer(heaviest(), said);
    REQUIRE(mark.form_errors.size() == 3);
    const FormError& article = mark.form_errors[0];
    CHECK(said.substr(article.begin, article.end - article.begin) == "a");
    CHECK(article.said == "a");
    CHECK(article.right == "an");
    CHECK(article.phrase == "an apple");
    CHECK_FALSE(article.target);
    const FormError& missing = mark.form_errors[1];
    CHECK(missing.said.empty());
    CHECK(missing.begin == missing.end);
    CHECK(said.substr(missing.begin, 4) == "most");
    CHECK(missing.target);
    const FormError& adjective = mark.form_errors[2];
    CHECK(said.substr(adjective.begin, adjective.end - adjective.begin) == "most heavy");
    CHECK(adjective.right == "heaviest");
    CHECK(adjective.phrase == "the heaviest");
    CHECK(adjective.base == "heavy");
    CHECK(mark.main_error() == &adjective);
    CHECK_FALSE(mark.target_right());
    CHECK(mark.other_errors() == 1);
    CHECK(mark.emphasis == "the heaviest");
    CHECK(mark.gapped == "An apple is …");
}

TEST_CASE("mark: a confidence is kept and decides nothing here") {
    CHECK(mark_answer(heaviest(), "watermelon", 0.1).confidence == 0.1);
    CHECK(mark_answer(heaviest(), "watermelon", 0.1).understood);
}

TEST_CASE("mark: an overlong answer is not understood and not kept whole") {
    const Mark mark = mark_answer(heaviest(), std::string(10'000'000, 'a'));
    CHECK_FALSE(mark.understood);
    CHECK(mark.said.size() <= 1000);
}
