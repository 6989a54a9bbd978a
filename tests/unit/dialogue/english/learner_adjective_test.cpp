#include "dialogue/english/adjective.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace fulcrum::dialogue;

TEST_CASE("learner forms: none is right, none comes twice, each has a code") {
    for (const char* adjective :
         {"heavy", "big", "large", "dry", "quiet", "simple", "beautiful", "good", "little", "many",
          "fun", "tired", "red", "icy", "free", "x", "good-looking"}) {
        for (const Degree degree : {Degree::comparative, Degree::superlative}) {
            INFO(adjective);
            const std::vector<std::string> right = degree_forms(adjective, degree);
            std::set<std::string> seen;
            for (const LearnerForm& form : learner_forms(adjective, degree)) {
                CHECK(std::find(right.begin(), right.end(), form.text) == right.end());
                CHECK(seen.insert(form.text).second);
                CHECK(form.code != ErrorCode::none);
                CHECK((form.slip >= 1 && form.slip <= 3));
            }
            CHECK(seen.size() >= 4);
        }
    }
}

TEST_CASE("learner forms: none for the plain adjective is right, comes twice or lacks a code") {
    for (const char* adjective : {"hard", "sticky", "slippery", "good", "y", "ty", "e"}) {
        std::set<std::string> seen{adjective};
        for (const LearnerForm& form : learner_forms(adjective, Degree::positive)) {
            INFO(form.text);
            CHECK(seen.insert(form.text).second);
            CHECK(form.code != ErrorCode::none);
        }
    }
}
