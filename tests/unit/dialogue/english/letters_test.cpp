#include "dialogue/english/letters.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

TEST_CASE("letters: distance is symmetric, zero only for equals, and bounded by the longer word") {
    CHECK(rc::check([](const std::string& a, const std::string& b) {
        const std::string first = a.substr(0, 32);
        const std::string second = b.substr(0, 32);
        const int distance = edit_distance(first, second);
        RC_ASSERT(distance == edit_distance(second, first));
        RC_ASSERT((distance == 0) == (first == second));
        RC_ASSERT(distance <= static_cast<int>(std::max(first.size(), second.size())));
    }));
}

TEST_CASE("letters: one edit is at distance one at most") {
    CHECK(rc::check([](const std::string& text, unsigned at, char letter) {
        const std::string word = text.substr(0, 31);
        std::string edited = word;
        edited.insert(at % (word.size() + 1), 1, letter);
        RC_ASSERT(edit_distance(word, edited) == 1);
    }));
}
