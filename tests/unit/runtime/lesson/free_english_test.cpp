#include "runtime/lesson/free_english.h"

#include <catch2/catch.hpp>

using namespace fulcrum;
using namespace fulcrum::runtime;

TEST_CASE("free English: opened, it finds errors by its words and by its grammar") {
    const auto check = open_free_english();
    REQUIRE(check);
    CHECK((*check)("it have two moon").corrected == "it has two moons");
    CHECK((*check)("I saw moon.").corrected == "I saw a moon.");
    CHECK((*check)("It has two moons.").errors.empty());
}
