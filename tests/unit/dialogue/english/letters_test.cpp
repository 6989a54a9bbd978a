#include "dialogue/english/letters.h"

#include <catch2/catch.hpp>

#include <rapidcheck.h>

using namespace fulcrum::dialogue;

TEST_CASE("letters: distance in closed form") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("apple", "apple") == 0);
    CHECK(edit_distance("aple", "apple") == 1);
    CHECK(edit_distance("applle", "apple") == 1);
    CHECK(edit_distance("abple", "apple") == 1);
    CHECK(edit_distance("appel", "apple") == 1);
    CHECK(edit_distance("", "egg") == 3);
    CHECK(edit_distance("kitten", "sitting") == 3);
    CHECK(edit_distance("ca", "abc") == 3);
    CHECK(edit_distance(std::string(33, 'a'), "a") == 33);
}

TEST_CASE("letters: every sentence begins with a capital, in asterisks too, and I is one") {
    CHECK(sentences_case("") == "");
    CHECK(sentences_case("it is big") == "It is big");
    CHECK(sentences_case("*the* apple is big. *egg* is small! is it? yes") ==
          "*The* apple is big. *Egg* is small! Is it? Yes");
    CHECK(sentences_case("and i think i'm small, i") == "And I think I'm small, I");
    CHECK(sentences_case("it has 3.5 moons. 4 are big") == "It has 3.5 moons. 4 are big");
    CHECK(sentences_case("a file.txt is no end") == "A file.txt is no end");
    CHECK(sentences_case("\xC3\xA9t\xC3\xA9. \xC3\xA9t\xC3\xA9") ==
          "\xC3\xA9t\xC3\xA9. \xC3\xA9t\xC3\xA9");
}

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

TEST_CASE("letters: case") {
    CHECK(lower_case("Big APPLE 3é") == "big apple 3é");
    CHECK(sentence_case("a watermelon") == "A watermelon");
    CHECK(sentence_case("éclair") == "éclair");
    CHECK(sentence_case("").empty());
}

TEST_CASE("letters: short words bear no slip, long ones two") {
    CHECK(allowed_slip(2) == 0);
    CHECK(allowed_slip(3) == 1);
    CHECK(allowed_slip(7) == 1);
    CHECK(allowed_slip(8) == 2);
}
