#include "dialogue/marking/readings.h"
#include "tests/unit/dialogue/questions.h"

#include <catch2/catch.hpp>

using namespace fulcrum::dialogue;

TEST_CASE("reasons: of an answer whose reason is not true the lesson is told what is wrong of it") {
    Mark both = mark_answer(heavier(), "the apple because the egg is heavier");
    CHECK_FALSE(settle(both, {true, false}));
    CHECK(both.understood);
    CHECK(both.slots == Slots{{"thing", "egg"}});
}
