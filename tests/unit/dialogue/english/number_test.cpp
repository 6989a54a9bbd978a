#include "dialogue/english/number.h"

#include <catch2/catch.hpp>

#include <set>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

TEST_CASE("number: all numbers below a thousand differ in words") {
    std::set<std::vector<std::string>> all;
    for (long number = 0; number < 1000; ++number) {
        CHECK(all.insert(number_words(number)).second);
    }
}
