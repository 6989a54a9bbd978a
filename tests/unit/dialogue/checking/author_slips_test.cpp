#include "tests/unit/dialogue/checking/checked.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("author slips: a review tells them, and what is said to learners does not") {
    EnglishChecker checker = words_alone();
    checker.set_things({"block", "ball", "apple"});
    const CheckedText review = checker.review("The wooden block float.");
    REQUIRE(review.errors.size() == 1);
    CHECK(review.errors[0].right == "floats");
    CHECK_FALSE(review.proven);
    CHECK(checker.advise("The wooden block float.").errors.empty());
    CHECK(checker.review("Why float the block?").unread == "Why float the block");
}
