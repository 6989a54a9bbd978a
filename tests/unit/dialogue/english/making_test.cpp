#include "dialogue/english/making.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace fulcrum::dialogue;

namespace {

ErrorCode code_of(const std::vector<LearnerVerb>& verbs, const std::string& said) {
    const auto found = std::find_if(verbs.begin(), verbs.end(),
                                    [&](const LearnerVerb& verb) { return verb.text == said; });
    return found == verbs.end() ? ErrorCode::none : found->code;
}

}  // namespace

TEST_CASE("making: what is changed in the making is made from it, all else is made of it") {
    CHECK(changed_in_making("paper", "wood"));
    CHECK(changed_in_making("Sheet of paper", "trees"));
    CHECK(changed_in_making("glass", "Sand"));
    CHECK(changed_in_making("bread", "flour"));
    CHECK_FALSE(changed_in_making("wood", "paper"));
    CHECK_FALSE(changed_in_making("table", "wood"));
    CHECK_FALSE(changed_in_making("spaceship", "metal"));
    CHECK_FALSE(changed_in_making("paper", "metal"));
    CHECK_FALSE(changed_in_making("", ""));
}

TEST_CASE("making: the wrong participles, auxiliaries and active verbs have their codes") {
    CHECK(code_of(learner_participles(), "make") == ErrorCode::verb_form);
    CHECK(code_of(learner_participles(), "maked") == ErrorCode::verb_inflection);
    CHECK(code_of(learner_participles(), "maid") == ErrorCode::spelling);
    CHECK(code_of(learner_participles(), "made") == ErrorCode::none);
    CHECK(code_of(learner_auxiliaries(), "has") == ErrorCode::verb_form);
    CHECK(code_of(learner_auxiliaries(), "is") == ErrorCode::none);
    CHECK(code_of(learner_auxiliaries(), "are") == ErrorCode::none);
    CHECK(code_of(active_for_passive(), "makes") == ErrorCode::verb_voice);
}
