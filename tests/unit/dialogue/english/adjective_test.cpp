#include "dialogue/english/adjective.h"

#include <catch2/catch.hpp>

#include <string>
#include <vector>

using namespace fulcrum::dialogue;

TEST_CASE("adjective: the positive degree is the word itself, and nothing has no degrees") {
    CHECK(degree_forms("heavy", Degree::positive) == std::vector<std::string>{"heavy"});
    CHECK(degree_forms("", Degree::superlative) == std::vector<std::string>{""});
    CHECK(with_ending("", "er").empty());
    CHECK(learner_forms("", Degree::comparative).empty());
    CHECK(learner_forms("", Degree::positive).empty());
}
