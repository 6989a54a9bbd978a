#include "dialogue/marking/reasons.h"

#include "tests/unit/dialogue/marking/marked_rows.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::dialogue;

TEST_CASE("reasons: one that says as much as an answer has to be true as well") {
    for (const char* said :
         {"the apple because it is heavier", "the apple because the egg is lighter",
          "The apple, because the egg is not heavier.", "the apple because it is big",
          "the egg is not heavier because it is lighter",
          "the apple is heavier because it falls faster"}) {
        INFO(said);
        CHECK(verdict_on(heavier(), said, {"apple"}) == "right");
    }
    for (const char* said :
         {"the apple because it is lighter", "The apple. Because it is lighter.",
          "the apple because it isn't heavier", "the apple because apples are lighter",
          "the apple because the egg is heavier", "the egg because it is heavier",
          "the apple, cause the apple is lighter"}) {
        INFO(said);
        CHECK(verdict_on(heavier(), said, {"apple"}) == "wrong");
    }
    Mark both = mark_answer(heavier(), "the apple because the egg is heavier");
    CHECK_FALSE(settle(both, {true, false}));
    CHECK(both.understood);
    CHECK(both.slots == Slots{{"thing", "egg"}});  // what is wrong of it
    const Mark mark = mark_answer(heavier(), "the apple because it is more light");
    CHECK(mark.form_errors.empty());
    CHECK(mark.unread == "because it is more light");
}

TEST_CASE("reasons: only of a plain answer, and only behind a word that begins one") {
    const auto claim = [](const char* said) {
        const auto mark = mark_with_reason(heavier(), mark_sentence(heavier(), said));
        return mark ? mark->claim : Claim::same;
    };
    CHECK(claim("the apple because it is lighter") == Claim::reasoned);
    CHECK(claim("the apple because") == Claim::same);
    CHECK(claim("the apple") == Claim::same);
    CHECK(claim("the apple so that it is lighter") == Claim::same);
    CHECK(claim("the egg is not heavier because it is big") == Claim::same);
    CHECK(claim("banana bread because it is lighter") == Claim::same);
}
