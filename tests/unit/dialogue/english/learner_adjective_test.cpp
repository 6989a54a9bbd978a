#include "dialogue/english/adjective.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

using namespace fulcrum::dialogue;

namespace {

ErrorCode code_of(const char* adjective, Degree degree, const std::string& said) {
    for (const LearnerForm& form : learner_forms(adjective, degree)) {
        if (form.text == said) {
            return form.code;
        }
    }
    return ErrorCode::none;
}

}  // namespace

TEST_CASE("learner forms: what learners say for the superlative, with its code") {
    const std::pair<const char*, ErrorCode> heavy[] = {{"most heavy", ErrorCode::adjective_form},
                                                       {"most heaviest", ErrorCode::adjective_form},
                                                       {"most heavyest", ErrorCode::adjective_form},
                                                       {"heavyest", ErrorCode::spelling},
                                                       {"heavest", ErrorCode::spelling},
                                                       {"heavier", ErrorCode::adjective_form},
                                                       {"more heavy", ErrorCode::adjective_form},
                                                       {"heavy", ErrorCode::adjective_form},
                                                       {"more heavier", ErrorCode::adjective_form},
                                                       {"more heaviest", ErrorCode::adjective_form},
                                                       {"most heavier", ErrorCode::adjective_form}};
    for (const auto& [said, code] : heavy) {
        INFO(said);
        CHECK(code_of("heavy", Degree::superlative, said) == code);
    }
    CHECK(code_of("big", Degree::superlative, "bigest") == ErrorCode::spelling);
    CHECK(code_of("large", Degree::superlative, "largeest") == ErrorCode::spelling);
    CHECK(code_of("cheap", Degree::superlative, "cheappest") == ErrorCode::spelling);
    CHECK(code_of("good", Degree::superlative, "goodest") == ErrorCode::adjective_form);
    CHECK(code_of("good", Degree::superlative, "bestest") == ErrorCode::adjective_form);
    CHECK(code_of("good", Degree::superlative, "most best") == ErrorCode::adjective_form);
    CHECK(code_of("beautiful", Degree::superlative, "beautifulest") == ErrorCode::adjective_form);
    CHECK(code_of("beautiful", Degree::superlative, "beautifullest") == ErrorCode::adjective_form);
}

TEST_CASE("learner forms: what learners say for the comparative, with its code") {
    CHECK(code_of("heavy", Degree::comparative, "more heavy") == ErrorCode::adjective_form);
    CHECK(code_of("heavy", Degree::comparative, "more heavier") == ErrorCode::adjective_form);
    CHECK(code_of("heavy", Degree::comparative, "most heaviest") == ErrorCode::adjective_form);
    CHECK(code_of("heavy", Degree::comparative, "heavyer") == ErrorCode::spelling);
    CHECK(code_of("heavy", Degree::comparative, "heaviest") == ErrorCode::adjective_form);
    CHECK(code_of("heavy", Degree::comparative, "heavy") == ErrorCode::adjective_form);
    CHECK(code_of("bad", Degree::comparative, "worser") == ErrorCode::adjective_form);
    CHECK(code_of("bad", Degree::comparative, "badder") == ErrorCode::adjective_form);
    CHECK(code_of("bad", Degree::comparative, "more bad") == ErrorCode::adjective_form);
    CHECK(code_of("expensive", Degree::comparative, "expensiver") == ErrorCode::adjective_form);
}

TEST_CASE("learner forms: what English accepts is no error") {
    CHECK(code_of("quiet", Degree::comparative, "more quiet") == ErrorCode::none);
    CHECK(code_of("simple", Degree::superlative, "most simple") == ErrorCode::none);
    CHECK(code_of("beautiful", Degree::comparative, "more beautiful") == ErrorCode::none);
    CHECK(code_of("far", Degree::comparative, "further") == ErrorCode::none);
}

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

TEST_CASE("learner forms: what learners say for the plain adjective, with its code") {
    const struct {
        const char *adjective, *said;
        ErrorCode code;
    } rows[] = {{"hard", "hardly", ErrorCode::morphology},
                {"hard", "hardness", ErrorCode::morphology},
                {"hard", "hardy", ErrorCode::morphology},
                {"hard", "hards", ErrorCode::morphology},
                {"hard", "harder", ErrorCode::adjective_form},
                {"hard", "more hard", ErrorCode::adjective_form},
                {"hard", "hardest", ErrorCode::adjective_form},
                {"hard", "more harder", ErrorCode::adjective_form},
                {"sticky", "stickily", ErrorCode::morphology},
                {"sticky", "stickiness", ErrorCode::morphology},
                {"sticky", "stick", ErrorCode::morphology},
                {"sticky", "stickey", ErrorCode::spelling},
                {"foggy", "fog", ErrorCode::morphology},
                {"gentle", "gently", ErrorCode::morphology},
                {"slippery", "most slippery", ErrorCode::adjective_form},
                {"dry", "dryly", ErrorCode::none},
                {"hard", "hard", ErrorCode::none},
                {"hard", "soft", ErrorCode::none}};
    for (const auto& row : rows) {
        INFO(row.said);
        CHECK(code_of(row.adjective, Degree::positive, row.said) == row.code);
    }
    for (const char* adjective : {"hard", "sticky", "slippery", "good", "y", "ty", "e"}) {
        std::set<std::string> seen{adjective};
        for (const LearnerForm& form : learner_forms(adjective, Degree::positive)) {
            INFO(form.text);
            CHECK(seen.insert(form.text).second);
            CHECK(form.code != ErrorCode::none);
        }
    }
}
