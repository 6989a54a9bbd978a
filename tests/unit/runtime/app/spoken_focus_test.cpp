#include "runtime/app/spoken_focus.h"

#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE(
    "spoken focus: what rests is read once, what is passed over is not, and again when it is come "
    "back to") {
    SpokenFocus focus;
    CHECK_FALSE(focus.look("", 0.0));
    CHECK_FALSE(focus.look("", 5.0));
    CHECK_FALSE(focus.look("the apple", 10.0));
    CHECK_FALSE(focus.look("the egg", 10.2));
    CHECK_FALSE(focus.look("the egg", 10.4));
    CHECK(focus.look("the egg", 10.6) == "the egg");
    CHECK_FALSE(focus.look("the egg", 20.0));
    CHECK_FALSE(focus.look("", 20.1));
    CHECK_FALSE(focus.look("the egg", 20.2));
    CHECK(focus.look("the egg", 20.2 + SpokenFocus::kRest_s) == "the egg");
}
