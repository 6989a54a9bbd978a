#include "tests/unit/dialogue/checking/checked.h"

using namespace fulcrum::dialogue;

TEST_CASE("place rules: a thing is next to another") {
    CHECK(checked("It is next of the bowl.") == "R:PREP => It is next *to* the bowl.");
    check_right({"It is next to the bowl.", "Jupiter is next of all."});
}
