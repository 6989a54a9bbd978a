#include "dialogue/english/noun.h"

#include <catch2/catch.hpp>

#include <string>

using namespace fulcrum::dialogue;

TEST_CASE("article: a or an by the sound, not by the letter") {
    const std::pair<const char*, const char*> rows[] = {{"apple", "an"},
                                                        {"egg", "an"},
                                                        {"orange", "an"},
                                                        {"umbrella", "an"},
                                                        {"ice cube", "an"},
                                                        {"onion", "an"},
                                                        {"watermelon", "a"},
                                                        {"banana", "a"},
                                                        {"yo-yo", "a"},
                                                        {"year", "a"},
                                                        {"house", "a"},
                                                        {"horse", "a"},
                                                        {"hour", "an"},
                                                        {"hourglass", "an"},
                                                        {"honest answer", "an"},
                                                        {"honour", "an"},
                                                        {"heir", "an"},
                                                        {"heirloom", "an"},
                                                        {"hotdog", "a"},
                                                        {"heron", "a"},
                                                        {"heavy box", "a"},
                                                        {"uniform", "a"},
                                                        {"unit", "a"},
                                                        {"unicorn", "a"},
                                                        {"union", "a"},
                                                        {"unique thing", "a"},
                                                        {"university", "a"},
                                                        {"useful tool", "a"},
                                                        {"user", "a"},
                                                        {"usual day", "a"},
                                                        {"European", "a"},
                                                        {"eucalyptus", "a"},
                                                        {"ewe", "a"},
                                                        {"one-euro coin", "a"},
                                                        {"once-only offer", "a"},
                                                        {"ukulele", "a"},
                                                        {"ufo", "a"},
                                                        {"uranium rod", "a"},
                                                        {"utensil", "a"},
                                                        {"U-turn", "a"},
                                                        {"unidentified object", "an"},
                                                        {"unimportant thing", "an"},
                                                        {"uninteresting book", "an"},
                                                        {"uncle", "an"},
                                                        {"usher", "an"},
                                                        {"upper shelf", "an"},
                                                        {"eraser", "an"},
                                                        {"elephant", "an"},
                                                        {"X-ray", "an"},
                                                        {"x-ray", "an"},
                                                        {"SUV", "an"},
                                                        {"MRI", "an"},
                                                        {"LED", "an"},
                                                        {"UFO", "a"},
                                                        {"TV", "a"},
                                                        {"NASA robot", "a"},
                                                        {"8", "an"},
                                                        {"11", "an"},
                                                        {"18", "an"},
                                                        {"80", "an"},
                                                        {"800", "an"},
                                                        {"1", "a"},
                                                        {"100", "a"},
                                                        {"110", "a"},
                                                        {"180", "a"},
                                                        {"11000", "an"},
                                                        {"7", "a"},
                                                        {"one", "a"},
                                                        {"owl", "an"},
                                                        {"", ""}};
    for (const auto& [phrase, article] : rows) {
        INFO(phrase);
        CHECK(std::string(indefinite_article(phrase)) == article);
    }
}

TEST_CASE("article: some words take both") {
    CHECK(both_articles("herb"));
    CHECK(both_articles("historic place"));
    CHECK_FALSE(both_articles("hour"));
    CHECK_FALSE(both_articles("house"));
}
