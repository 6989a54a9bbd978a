#include "runtime/lesson/sentence_form.h"

#include "runtime/lesson/free_english.h"
#include "tests/unit/runtime/rig.h"

using namespace fulcrum::runtime::test;

TEST_CASE("sentence form: what is amiss is told as a sentence's end, what is good not at all") {
    const auto check = value_of(open_free_english({"egg"}));
    CHECK(tell_form(check, "The egg is heavy. Lift it!").empty());
    CHECK(tell_form(check, "").empty());
    CHECK(tell_form(check, "Lift it. It have two moon.") ==
          "is no good English; better is \"Lift it. It has two moons.\"");
    CHECK(tell_form(check, "It is is heavy.") ==
          "has \"is\" twice; take one out, or the form of grammar that brings it");
    CHECK(tell_form(check, "It weighs six million million tonnes.").empty());
    CHECK(tell_form({}, "It have two moon.").empty());
}
