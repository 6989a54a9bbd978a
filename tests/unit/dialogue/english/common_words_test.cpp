#include "dialogue/english/common_words.h"

#include <catch2/catch.hpp>

using fulcrum::dialogue::CommonWords;

namespace {

constexpr const char* kList = "# a list\nthe\nbig\nhedge\ncolor\nmeter\ntry\nmake\nstop\nis\n";

}  // namespace

TEST_CASE("common words: a word is common by itself or by what it is a regular form of") {
    const CommonWords words(kList);
    for (const char* word :
         {"the", "hedges", "bigger", "biggest", "tried", "tries", "making", "maker", "stopped",
          "stopping", "colour", "colours", "metres", "hedge's"}) {
        INFO(word);
        CHECK(words.has(word));
    }
    for (const char* word : {"them", "pedge", "bog", "trial", "stopwatch", "lour"}) {
        INFO(word);
        CHECK_FALSE(words.has(word));
    }
}

TEST_CASE("common words: of a text the others are told once, names and what was taught are not") {
    CommonWords words(kList);
    CHECK(words.rare_words("The hedge is thorny. Thorny, big Phobos is 3 metres!") ==
          std::vector<std::string>{"thorny"});
    CHECK(words.rare_words("Phobos is big") == std::vector<std::string>{"phobos"});
    words.add("Phobos|thorny");
    CHECK(words.rare_words("Phobos is the thorniest").empty());
}
